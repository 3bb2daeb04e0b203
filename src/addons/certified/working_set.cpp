#include "addons/certified/working_set.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "addons/certified/separate.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/core/index.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Statuses = std::vector<ContactStatus>;

/// The first matrix whose rows are worth leaving out: with doubles, half a megabyte.
constexpr Index fewest_pairs = 256;

/// How many pairs, if they are dense, cost as much as the factor of K, see chapter 21.
Index paid_for(double operations) { return static_cast<Index>(std::cbrt(3 * operations)); }

/// Every so many of some pairs that no more are left than are paid for: a load may make all pairs overlap where few will close.
std::vector<Index> thinned(const std::vector<Index>& some, Index most) {
  const Index stride = 1 + static_cast<Index>(some.size()) / std::max<Index>(most, 1);
  std::vector<Index> left;
  for (std::size_t k = 0; k < some.size(); k += at(stride)) left.push_back(some[k]);
  return left;
}

/// K and p, and no rows yet.
QuadraticProgramme without_rows(QuadraticProgramme programme) {
  programme.A.resize(0, programme.A.cols());
  programme.initial_gap.resize(0);
  return programme;
}

/// The pairs that are condensed, among all.
struct WorkingSet {
  const Model& model;
  const CondensedProgramme whole;  ///< without compliance
  QuadraticProgramme programme;    ///< K and p; A and g of the set
  const KnownMatrices known;       ///< of K, whatever rows are in the set
  std::vector<bool> in;            ///< `n_c` whether a pair is in the set
  std::vector<Index> pairs = {};   ///< that are, in increasing order
  ContactProblem problem = {};     ///< of the set, condensed
  Statuses statuses;               ///< `n_c` to begin a round with; empty: none are known

  WorkingSet(const Model& of, const CondensedProgramme& condensed, const SolverOptions& options);
  [[nodiscard]] VectorXd rounding(const CertifiedSolution& end) const;
  [[nodiscard]] std::vector<Index> entering(const CertifiedSolution& end) const;
  void take(const std::vector<Index>& some, Index reach);
  void condense(const Factor& factor, Ledger& ledger);
  [[nodiscard]] SolverOptions started(SolverOptions options) const;
  CertifiedSolution tried(const Solver& solver, const SolverOptions& options, Ledger& ledger) const;
  CertifiedSolution solved(const Solver& solver, const SolverOptions& options, Ledger& ledger) const;
  void widen(CertifiedSolution& end);
};

WorkingSet::WorkingSet(const Model& of, const CondensedProgramme& condensed,
                       const SolverOptions& options)
    : model(of),
      whole(condensed),
      programme(without_rows(of.programme)),
      known(known_matrices(programme, {})),
      in(at(of.programme.A.rows()), false),
      statuses(options.start) {}

/// What gaps are known to, as in check_signs().
VectorXd WorkingSet::rounding(const CertifiedSolution& end) const {
  return 2 * static_cast<double>(end.state.active().size() + 1) * movement_rounding(model.programme, end.solution);
}

/// The pairs outside that overlap, or may by rounding.
std::vector<Index> WorkingSet::entering(const CertifiedSolution& end) const {
  const VectorXd least = rounding(end);
  std::vector<Index> some;
  for (Index pair = 0; pair < least.size(); ++pair)
    if (!in[at(pair)] && !(end.state.gap(pair) > least(pair))) some.push_back(pair);
  return some;
}

/// Takes in pairs, and so many neighbours on each side of each. Pairs of a contact are numbered along its source.
void WorkingSet::take(const std::vector<Index>& some, Index reach) {
  const Index count = static_cast<Index>(in.size());
  for (const Index pair : some)
    for (Index other = std::max<Index>(0, pair - reach); other <= std::min(count - 1, pair + reach); ++other)
      if (model.contact_of[at(other)] == model.contact_of[at(pair)]) in[at(other)] = true;
  pairs.clear();
  for (Index pair = 0; pair < count; ++pair)
    if (in[at(pair)]) pairs.push_back(pair);
}

void WorkingSet::condense(const Factor& factor, Ledger& ledger) {
  const Ledger::Phase phase(ledger, "condensation");
  programme.A = selected_rows(model.programme.A, pairs);
  programme.initial_gap = model.programme.initial_gap(pairs);
  problem.compliance = factor.compliance(programme.A, ledger);
  problem.free_gap = whole.problem.free_gap(pairs);
  ledger.count("condensed pairs", programme.A.rows());
  ledger.bytes(problem.compliance.size() * static_cast<long long>(sizeof(double)));
}

/// Options that begin with the statuses of the last round, if there was one.
SolverOptions WorkingSet::started(SolverOptions options) const {
  options.start.clear();
  if (statuses.size() == in.size())
    for (const Index pair : pairs) options.start.push_back(statuses[at(pair)]);
  return options;
}

/// What the condensed set says of its pairs, and displacements that are not refined: enough to tell who else may close.
CertifiedSolution WorkingSet::tried(const Solver& solver, const SolverOptions& options,
                                    Ledger& ledger) const {
  const Ledger::Phase phase(ledger, "contact");
  CertifiedSolution end;
  end.state = solve_with_proofs(problem, solver, started(options));
  ledger.count("iterations", end.state.report.iterations);
  ledger.count("factorisations", end.state.report.factorisations);
  if (end.state.report.status != SolveStatus::Solved) return end;
  end.solution.force = end.state.force;
  end.solution.displacement =
      whole.free_displacement - whole.solve_stiffness(programme.A.transpose() * end.state.force);
  return end;
}

CertifiedSolution WorkingSet::solved(const Solver& solver, const SolverOptions& options,
                                     Ledger& ledger) const {
  const CondensedProgramme own{problem, whole.free_displacement, whole.solve_stiffness,
                               whole.solve_part, &known};
  return certified_solve(programme, own, mode_shapes(model.modes), solver, started(options), ledger);
}

/// Makes the end of the set a claim for all pairs: the others are open, without a force. Where they overlap the next round
/// begins with them closed.
void WorkingSet::widen(CertifiedSolution& end) {
  const Statuses own = end.state.contact_status;
  statuses.assign(in.size(), ContactStatus::Open);
  for (std::size_t k = 0; k < own.size(); ++k) statuses[at(pairs[k])] = own[k];
  VectorXd force = VectorXd::Zero(model.programme.A.rows());
  force(pairs) = end.solution.force;
  end.solution.force = std::move(force);
  const VectorXd gap = gaps(model.programme, end.solution);
  fill_state(model.law, statuses, end.solution.force, gap, end.state);
  if (Index& pair = end.force_uncertainty.pair; pair >= 0) pair = pairs[at(pair)];
  const VectorXd least = rounding(end);
  for (Index pair = 0; pair < gap.size(); ++pair)
    if (!in[at(pair)] && gap(pair) < -least(pair)) statuses[at(pair)] = ContactStatus::Stick;
}

/// Round after round. Where not all that overlap are in the first one, it is not refined: it is there to say who enters.
/// \return the last one, if it was solved and was worth its rounds
std::optional<CertifiedSolution> grown(WorkingSet& set, const Condensed& condensed,
                                       const Solver& solver, const SolverOptions& options,
                                       Ledger& ledger) {
  const Index all = condensed.problem.free_gap.size();
  const auto dense = [](double m) { return m * m * m; };
  CertifiedSolution end;
  end.solution = {condensed.free_displacement, {}, VectorXd::Zero(all)};
  end.state.gap = condensed.problem.free_gap;
  Report report;
  const std::vector<Index> overlapping = set.entering(end);
  std::vector<Index> some = thinned(overlapping, paid_for(condensed.factor.operations()));
  bool trial = some.size() < overlapping.size();
  double made = 0;
  for (Index reach = 0; reach == 0 || !some.empty(); reach = std::max<Index>(1, 2 * reach)) {
    set.take(some, reach);
    made += dense(static_cast<double>(set.pairs.size()));
    if (2 * made > dense(static_cast<double>(all))) return std::nullopt;
    set.condense(condensed.factor, ledger);
    do {
      end = trial ? set.tried(solver, options, ledger) : set.solved(solver, options, ledger);
      append(report, end.state.report);
      if (report.status != SolveStatus::Solved) return std::nullopt;
      set.widen(end);
      some = set.entering(end);
    } while (std::exchange(trial, false) && some.empty());
  }
  end.state.report = std::move(report);
  return end;
}

}  // namespace

bool working_set_pays(const Plan& plan, Index pairs, double operations) {
  const bool plain = plan.modes.empty() && plan.law.pair.empty() && plan.path.times.empty() &&
                     !plan.equations && !plan.loop;
  return plain && pairs >= fewest_pairs && pairs > paid_for(operations);
}

std::optional<CertifiedSolution> working_set_solution(const Model& model,
                                                      const Condensed& condensed,
                                                      const Solver& solver,
                                                      const SolverOptions& options,
                                                      Ledger& ledger) {
  try {
    WorkingSet set(model, condensed_programme(condensed, ledger), options);
    std::optional<CertifiedSolution> end = grown(set, condensed, solver, options, ledger);
    if (!end) return end;
    end->certificate = certify(model.programme, end->solution, model.law, &set.known);
    return end->certificate.holds() ? std::move(end) : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // numbers that no unit can take: the problem of all pairs says which
  }
}

}  // namespace signorini
