#include "addons/certified/working_set.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "signorini/contact/gaps.hpp"
#include "signorini/core/index.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Statuses = std::vector<ContactStatus>;

/// The first matrix whose rows are worth leaving out: with doubles, half a megabyte.
constexpr Index fewest_pairs = 256;

/// The pairs that are condensed, among all.
struct WorkingSet {
  const Model& model;
  const CondensedProgramme whole;  ///< without compliance
  QuadraticProgramme programme;    ///< K and p; A and g of the set
  std::vector<bool> in;            ///< `n_c` whether a pair is in the set
  std::vector<Index> pairs = {};   ///< that are, in increasing order
  Statuses statuses;               ///< `n_c` in the last round

  WorkingSet(const Model& of, const CondensedProgramme& condensed, const SolverOptions& options);
  Index take(const VectorXd& gap, const PrimalDual& solution, Index reach);
  CertifiedSolution solve(const Factor& factor, const Solver& solver, SolverOptions options,
                          Ledger& ledger);
  void widen(CertifiedSolution& end);
};

WorkingSet::WorkingSet(const Model& of, const CondensedProgramme& condensed,
                       const SolverOptions& options)
    : model(of),
      whole(condensed),
      programme(of.programme),
      in(at(of.programme.A.rows()), false),
      statuses(options.start) {}

/// Takes in every pair outside that overlaps, or may by rounding, and so many neighbours on each side. Pairs of a contact are
/// numbered along its source. \return how many pairs came in
Index WorkingSet::take(const VectorXd& gap, const PrimalDual& solution, Index reach) {
  const auto roundings = 2 * static_cast<double>(closed_pairs(statuses).size() + 1);  // as in check_signs()
  const VectorXd rounding = roundings * movement_rounding(model.programme, solution);
  const std::vector<bool> before = in;
  const Index count = gap.size();
  for (Index pair = 0; pair < count; ++pair) {
    if (before[at(pair)] || gap(pair) > rounding(pair)) continue;
    for (Index other = std::max<Index>(0, pair - reach); other <= std::min(count - 1, pair + reach); ++other)
      if (model.contact_of[at(other)] == model.contact_of[at(pair)]) in[at(other)] = true;
  }
  const Index last = static_cast<Index>(pairs.size());
  pairs.clear();
  for (Index pair = 0; pair < count; ++pair)
    if (in[at(pair)]) pairs.push_back(pair);
  return static_cast<Index>(pairs.size()) - last;
}

/// Condenses the set and solves it, from the statuses of the last round if there was one.
CertifiedSolution WorkingSet::solve(const Factor& factor, const Solver& solver,
                                    SolverOptions options, Ledger& ledger) {
  ContactProblem problem;
  {
    const Ledger::Phase phase(ledger, "condensation");
    programme.A = selected_rows(model.programme.A, pairs);
    programme.initial_gap = model.programme.initial_gap(pairs);
    problem.compliance = factor.compliance(programme.A, ledger);
    ledger.count("condensed pairs", programme.A.rows());
    ledger.bytes(problem.compliance.size() * static_cast<long long>(sizeof(double)));
  }
  problem.free_gap = whole.problem.free_gap(pairs);
  options.start.clear();
  if (statuses.size() == in.size())
    for (const Index pair : pairs) options.start.push_back(statuses[at(pair)]);
  const CondensedProgramme own{problem, whole.free_displacement, whole.solve_stiffness,
                               whole.solve_part};
  return certified_solve(programme, own, mode_shapes(model.modes), solver, options, ledger);
}

/// Makes the end of the set a claim for all pairs: the others are open, without a force.
void WorkingSet::widen(CertifiedSolution& end) {
  const Statuses own = all_statuses(end.state);
  statuses.assign(in.size(), ContactStatus::Open);
  for (std::size_t k = 0; k < own.size(); ++k) statuses[at(pairs[k])] = own[k];
  VectorXd force = VectorXd::Zero(model.programme.A.rows());
  force(pairs) = end.solution.force;
  end.solution.force = std::move(force);
  const VectorXd gap = gaps(model.programme, end.solution);
  fill_state(model.law, statuses, end.solution.force, gap, end.state);
  if (Index& pair = end.force_uncertainty.pair; pair >= 0) pair = pairs[at(pair)];
}

/// Round after round. \return the last one, if it was solved and was worth its rounds
std::optional<CertifiedSolution> grown(WorkingSet& set, const Condensed& condensed,
                                       const Solver& solver, const SolverOptions& options,
                                       Ledger& ledger) {
  const Index all = condensed.problem.free_gap.size();
  CertifiedSolution end;
  end.solution = {condensed.free_displacement, {}, VectorXd::Zero(all)};
  end.state.gap = condensed.problem.free_gap;
  Report report;
  Index made = 0;
  Index reach = 1;
  set.take(end.state.gap, end.solution, reach);
  do {
    made += static_cast<Index>(set.pairs.size());
    if (made >= all) return std::nullopt;
    end = set.solve(condensed.factor, solver, options, ledger);
    append(report, end.state.report);
    if (report.status != SolveStatus::Solved) return std::nullopt;
    set.widen(end);
    reach *= 2;
  } while (set.take(end.state.gap, end.solution, reach) > 0);
  end.state.report = std::move(report);
  return end;
}

}  // namespace

bool working_set_pays(const Plan& plan, Index pairs, double operations) {
  const bool plain = plan.modes.empty() && plan.law.pair.empty() && plan.path.times.empty() &&
                     !plan.equations && !plan.loop;
  const double m = static_cast<double>(pairs);
  return plain && pairs >= fewest_pairs && m * m * m > 3 * operations;
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
    end->certificate = certify(model.programme, end->solution, model.law);
    return end->certificate.holds() ? std::move(end) : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // numbers that no unit can take: the problem of all pairs says which
  }
}

/// An empty compliance of three pairs was left out. An empty one of no pairs is all of it.
bool is_complete(const Condensed& condensed) {
  const ContactProblem& problem = condensed.problem;
  return problem.compliance.rows() == problem.free_gap.size() + problem.free_slip.size();
}

Condensed completed(const Model& model, Condensed condensed, Ledger& ledger) {
  if (is_complete(condensed)) return condensed;
  const Ledger::Phase phase(ledger, "condensation");
  Eigen::MatrixXd& compliance = condensed.problem.compliance;
  compliance = condensed.factor.compliance(model.programme.A, ledger);
  ledger.bytes(compliance.size() * static_cast<long long>(sizeof(double)));
  move_freely(model, condensed.free_displacement, condensed);  // rigid motions had been left, too
  return condensed;
}

}  // namespace signorini
