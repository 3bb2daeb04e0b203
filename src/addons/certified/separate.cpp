#include "addons/certified/separate.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Places = std::vector<Index>;

/// Puts numbers where they belong, others being 0; nothing where there are none.
void put(const VectorXd& part, const Places& places, Index size, VectorXd& whole) {
  if (part.size() == 0) return;
  if (whole.size() == 0) whole.setZero(size);
  whole(places) = part;
}

/// One system beside the whole that it is a part of: its gaps and slips by their numbers there.
struct Separate {
  const ContactProblem& whole;
  const SystemParts& parts;
  Places gaps = {}, slips = {};

  Separate(const ContactProblem& problem, const SystemParts& system)
      : whole(problem), parts(system) {
    for (const Index row : parts.rows)
      (row < pairs() ? gaps : slips).push_back(row < pairs() ? row : row - pairs());
  }
  [[nodiscard]] Index pairs() const { return whole.free_gap.size(); }
  [[nodiscard]] ContactProblem problem() const;
  void put_into(CertifiedSolution& all, CertifiedSolution part, Index unknowns) const;
};

ContactProblem Separate::problem() const {
  ContactProblem own{whole.compliance(parts.rows, parts.rows), whole.free_gap(gaps)};
  own.free_slip = whole.free_slip(slips);
  own.law = part_of(whole.law, pairs(), parts);
  if (parts.modes.empty()) return own;
  own.rigid = whole.rigid(parts.rows, parts.modes);
  own.resultant = whole.resultant(parts.modes);
  return own;
}

/// Solves one system.
CertifiedSolution end_of(const Separate& system, const QuadraticProgramme& programme,
                         const CondensedProgramme& condensed, const MatrixXd& null_vectors,
                         const Solver& solver, SolverOptions options, Ledger& ledger) {
  const SystemParts& parts = system.parts;
  if (static_cast<Index>(options.start.size()) == system.pairs()) {
    std::vector<ContactStatus> start;
    for (const Index pair : system.gaps) start.push_back(options.start[at(pair)]);
    options.start = std::move(start);
  }
  const ContactProblem problem = system.problem();
  const VectorXd free = condensed.free_displacement(parts.unknowns);
  CondensedProgramme small{problem, free, {}};
  if (condensed.solve_part) small.solve_stiffness = condensed.solve_part(parts.unknowns);
  if (!small.solve_stiffness)
    small.solve_stiffness = [&](const VectorXd& load) {
      VectorXd all;
      put(load, parts.unknowns, condensed.free_displacement.size(), all);
      return VectorXd(condensed.solve_stiffness(all)(parts.unknowns));
    };
  const MatrixXd modes =
      parts.modes.empty() ? MatrixXd() : MatrixXd(null_vectors(parts.unknowns, parts.modes));
  return certified_solve(part_of(programme, parts), small, modes, solver, options, ledger);
}

/// Adds the end of this system to those before it.
void Separate::put_into(CertifiedSolution& all, CertifiedSolution part, Index unknowns) const {
  const Index n_slips = whole.free_slip.size();
  const Index modes = whole.resultant.size();
  PrimalDual& solution = all.solution;
  put(part.solution.displacement, parts.unknowns, unknowns, solution.displacement);
  put(part.solution.displacement_low, parts.unknowns, unknowns, solution.displacement_low);
  put(part.solution.rigid, parts.unknowns, unknowns, solution.rigid);
  put(part.solution.force, parts.rows, pairs() + n_slips, solution.force);
  ContactState& state = all.state;
  const ContactState& now = part.state;
  put(now.force, gaps, pairs(), state.force);
  put(now.gap, gaps, pairs(), state.gap);
  put(now.farkas_certificate, gaps, pairs(), state.farkas_certificate);
  put(now.friction, slips, n_slips, state.friction);
  put(now.slip, slips, n_slips, state.slip);
  put(now.amplitude, parts.modes, modes, state.amplitude);
  put(now.unbounded_direction, parts.modes, modes, state.unbounded_direction);
  state.contact_status.resize(at(pairs()), ContactStatus::Open);
  for (std::size_t k = 0; k < now.contact_status.size(); ++k)
    state.contact_status[at(gaps[k])] = now.contact_status[k];
  if (now.uniqueness == Uniqueness::Doubtful && state.uniqueness != Uniqueness::Doubtful) {
    state.uniqueness_warning = now.uniqueness_warning;
    if (auto& pair = state.uniqueness_warning.pair; pair) pair = gaps[at(*pair)];
  }
  if (!parts.rows.empty()) state.uniqueness = std::max(state.uniqueness, now.uniqueness);
  if (const ForceUncertainty& own = part.force_uncertainty; own.share > all.force_uncertainty.share)
    all.force_uncertainty = {gaps[at(own.pair)], own.share};
  const SolveStatus before = state.report.status;
  append(state.report, now.report);
  if (before != SolveStatus::Solved)
    state.report.status = before;
  else
    state.reason = now.reason;
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
    const Separate system(condensed.problem, parts);
    CertifiedSolution end =
        end_of(system, programme, condensed, null_vectors, solver, options, ledger);
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
  state.frictional_pairs = condensed.problem.law.pair;
  whole.certificate = certify(programme, whole.solution, condensed.problem.law);
  return whole;
}

Eigen::Index largest_of(const std::vector<SystemParts>& systems) {
  std::size_t most = 0;
  for (const SystemParts& parts : systems) most = std::max(most, parts.rows.size());
  return static_cast<Eigen::Index>(most);
}

// Where everything hangs together although rounding connects nothing, it does so with rounding and rigid motions, too.
KnownMatrices known_matrices(const QuadraticProgramme& programme, const FrictionLaw& law) {
  return {programme.stiffness.diagonal(), unconnected_systems(programme, law, {}, epsilon).empty()};
}

}  // namespace signorini
