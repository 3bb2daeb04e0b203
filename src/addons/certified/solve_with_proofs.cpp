#include "addons/certified/solve_with_proofs.hpp"

#include <iterator>
#include <optional>
#include <vector>

#include "addons/certified/many_bodies.hpp"
#include "addons/certified/members.hpp"
#include "addons/certified/proofs.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/solvers/portfolio.hpp"

namespace signorini {
namespace {

/// A member that names others, with those of this add-on that the problem is for. Bodies that nothing pushes are asked for first, at no
/// cost. Soft pairs are sure and slow, as each of their exchanges takes a factor: they come before the last, whose word on why it
/// does not arrive counts.
Solver strengthened(const Solver& solver, const ContactProblem& problem) {
  Solver strong = solver;
  if (solver.others.empty()) return strong;
  if (!problem.law.pair.empty()) strong.others.insert(std::prev(strong.others.end()), soft_pairs);
  if (problem.resultant.size() > 0) strong.others.insert(strong.others.begin(), at_rest);
  return strong;
}

/// The determinant of the set decides for held bodies without cohesion only; what a warning rests on it tells for all.
void prove_uniqueness(ScaledProblem& scaled, ContactState& state) {
  if (!scaled.symmetric) return;
  const std::vector<ContactStatus> statuses = state.contact_status;
  ActiveSetSolution solution;
  solution.force = all_forces(state).cwiseQuotient(scaled.scale);
  solution.movement = all_movements(state).cwiseProduct(scaled.scale);
  solution.force_rounding = static_cast<double>(scaled.free.size() + scaled.rigid.cols() + 1) *
                            epsilon * largest(solution.force);
  const auto factor = [&] {
    solution.reversed = active_set_system(scaled, active_set(statuses, scaled.law)).reversed;
  };
  const bool decides = scaled.rigid.cols() == 0 && scaled.law.cohesion.isZero(0);
  if (decides) factor();
  if (decides && !scaled.excludes_others) scaled.excludes_others = excludes_others(scaled);
  state.uniqueness = uniqueness(scaled, statuses, solution);
  if (state.uniqueness != Uniqueness::Doubtful) return;
  if (!decides) factor();
  state.uniqueness_warning = uniqueness_warning(scaled, statuses, solution);
}

}  // namespace

ContactState solve_with_proofs(const ContactProblem& problem, const Solver& solver,
                               SolverOptions options, ScaledProblem* scaled) {
  const bool frictional = !problem.law.pair.empty();
  const bool floats = problem.resultant.size() > 0;
  std::optional<ScaledProblem> own;
  const auto in_own_units = [&]() -> ScaledProblem& {
    if (scaled == nullptr)
      scaled = &own.emplace(floats ? equilibrate(problem) : equilibrate_any(problem));
    return *scaled;
  };
  if (many_bodies(problem.resultant.size(), solver, options))
    if (auto sparse = many_bodies_state(problem, options)) return std::move(*sparse);
  if (floats && (!frictional || solver.friction != Takes::No))
    if (auto away = infeasible_resultant(problem, in_own_units())) return *away;
  const bool mostly_zero = !floats && scaled != nullptr ? scaled->sparse.size() > 0 : few_entries(problem);
  if (mostly_zero && many_bodies(many_motions, solver, options))
    if (auto sparse = many_bodies_state(problem, options)) {
      prove_uniqueness(in_own_units(), *sparse);
      return std::move(*sparse);
    }
  options.known = scaled != nullptr ? &problem : nullptr;
  options.scaled = scaled;
  ContactState state = solve(problem, strengthened(solver, problem), options);
  const SolveStatus status = state.report.status;
  if (frictional && status == SolveStatus::Solved) in_own_units();
  if (scaled != nullptr) scaled->factored = state.system;
  if (frictional && status == SolveStatus::Solved) prove_uniqueness(*scaled, state);
  if (frictional || floats || status == SolveStatus::Solved || status == SolveStatus::Infeasible)
    return state;
  if (!in_own_units().symmetric) state.farkas_certificate = farkas_certificate(*scaled);
  if (state.farkas_certificate.size() > 0) state.report.status = SolveStatus::Infeasible;
  return state;
}

}  // namespace signorini
