#include "addons/certified/separate.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Places = std::vector<Index>;

/// Puts numbers where they belong, others being 0; nothing where there are none.
void put(const VectorXd& part, const Places& places, Index size, VectorXd& whole) {
  if (part.size() == 0) return;
  if (whole.size() == 0) whole.setZero(size);
  whole(places) = part;
}

/// One system beside the whole that it is a part of.
class Separate {
 public:
  Separate(const QuadraticProgramme& programme, const CondensedProgramme& condensed,
           const MatrixXd& null_vectors, const SystemParts& parts)
      : whole_(condensed.problem), parts_(parts), programme_(part_of(programme, parts)) {
    for (const Index row : parts.rows)
      (row < pairs() ? gaps_ : slips_).push_back(row < pairs() ? row : row - pairs());
    problem_.compliance = whole_.compliance(parts.rows, parts.rows);
    problem_.free_gap = whole_.free_gap(gaps_);
    problem_.free_slip = whole_.free_slip(slips_);
    problem_.law = part_of(whole_.law, pairs(), parts);
    if (!parts.modes.empty()) {
      problem_.rigid = whole_.rigid(parts.rows, parts.modes);
      problem_.resultant = whole_.resultant(parts.modes);
      modes_ = null_vectors(parts.unknowns, parts.modes);
    }
    free_ = condensed.free_displacement(parts.unknowns);
  }

  CertifiedSolution end(const CondensedProgramme& condensed, const Solver& solver,
                        SolverOptions options, Ledger& ledger) const {
    if (static_cast<Index>(options.start.size()) == pairs()) {
      std::vector<ContactStatus> start;
      for (const Index pair : gaps_) start.push_back(options.start[at(pair)]);
      options.start = std::move(start);
    }
    CondensedProgramme small{problem_, free_, {}};
    if (condensed.solve_part) small.solve_stiffness = condensed.solve_part(parts_.unknowns);
    if (!small.solve_stiffness)
      small.solve_stiffness = [&](const VectorXd& load) {
        VectorXd all;
        put(load, parts_.unknowns, condensed.free_displacement.size(), all);
        return VectorXd(condensed.solve_stiffness(all)(parts_.unknowns));
      };
    return certified_solve(programme_, small, modes_, solver, options, ledger);
  }

  /// Adds the end of this system to those before it.
  void put_into(CertifiedSolution& whole, CertifiedSolution part, Index unknowns) const;

 private:
  [[nodiscard]] Index pairs() const { return whole_.free_gap.size(); }

  const ContactProblem& whole_;
  const SystemParts& parts_;
  Places gaps_;
  Places slips_;
  QuadraticProgramme programme_;
  ContactProblem problem_;
  MatrixXd modes_;
  VectorXd free_;
};

void Separate::put_into(CertifiedSolution& whole, CertifiedSolution part, Index unknowns) const {
  const Index slips = whole_.free_slip.size();
  const Index modes = whole_.resultant.size();
  PrimalDual& solution = whole.solution;
  put(part.solution.displacement, parts_.unknowns, unknowns, solution.displacement);
  put(part.solution.displacement_low, parts_.unknowns, unknowns, solution.displacement_low);
  put(part.solution.rigid, parts_.unknowns, unknowns, solution.rigid);
  put(part.solution.force, parts_.rows, pairs() + slips, solution.force);
  ContactState& all = whole.state;
  const ContactState& now = part.state;
  put(now.force, gaps_, pairs(), all.force);
  put(now.gap, gaps_, pairs(), all.gap);
  put(now.farkas_certificate, gaps_, pairs(), all.farkas_certificate);
  put(now.friction, slips_, slips, all.friction);
  put(now.slip, slips_, slips, all.slip);
  put(now.amplitude, parts_.modes, modes, all.amplitude);
  put(now.unbounded_direction, parts_.modes, modes, all.unbounded_direction);
  for (const Index pair : now.active) all.active.push_back(gaps_[at(pair)]);
  all.contact_status.resize(at(slips), ContactStatus::Open);
  for (std::size_t k = 0; k < now.contact_status.size(); ++k)
    all.contact_status[at(slips_[k])] = now.contact_status[k];
  const bool first_warning =
      now.uniqueness == Uniqueness::Doubtful && all.uniqueness != Uniqueness::Doubtful;
  if (first_warning) all.uniqueness_warning = now.uniqueness_warning;
  if (first_warning && now.uniqueness_warning.pair >= 0)
    all.uniqueness_warning.pair = gaps_[at(now.uniqueness_warning.pair)];
  if (!parts_.rows.empty()) all.uniqueness = std::max(all.uniqueness, now.uniqueness);
  if (part.force_uncertainty.share > whole.force_uncertainty.share)
    whole.force_uncertainty = {gaps_[at(part.force_uncertainty.pair)],
                               part.force_uncertainty.share};
  const SolveStatus before = all.report.status;
  append(all.report, now.report);
  if (before != SolveStatus::Solved)
    all.report.status = before;
  else
    all.reason = now.reason;
}

}  // namespace

CertifiedSolution separate_solutions(const QuadraticProgramme& programme,
                                     const CondensedProgramme& condensed,
                                     const MatrixXd& null_vectors,
                                     const std::vector<SystemParts>& systems, const Solver& solver,
                                     const SolverOptions& options, Ledger& ledger) {
  CertifiedSolution whole;
  whole.state.report.status = SolveStatus::Solved;
  if (!condensed.problem.law.pair.empty()) whole.state.uniqueness = Uniqueness::Proved;
  bool complete = true;
  for (const SystemParts& parts : systems) {
    const Separate system(programme, condensed, null_vectors, parts);
    CertifiedSolution end = system.end(condensed, solver, options, ledger);
    complete = complete && end.solution.displacement.size() > 0;
    system.put_into(whole, std::move(end), programme.load.size());
  }
  ContactState& state = whole.state;
  if (!complete) {
    CertifiedSolution none;
    none.state.report = std::move(state.report);
    none.state.reason = std::move(state.reason);
    none.state.farkas_certificate = std::move(state.farkas_certificate);
    none.state.unbounded_direction = std::move(state.unbounded_direction);
    return none;
  }
  std::sort(state.active.begin(), state.active.end());
  state.frictional_pairs = condensed.problem.law.pair;
  whole.certificate = certify(programme, whole.solution, condensed.problem.law);
  return whole;
}

}  // namespace signorini
