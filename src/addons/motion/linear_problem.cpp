// # The linear problem of an iteration
//
// If all strains are small, K is that of the scene, and so is its factor. An iteration then costs the compliance of the rows
// of its pairs.
//
// Under finite strain K is the tangent of the place, and is factored. A tangent may be indefinite in a body that is stable,
// see [held_by_pairs.cpp](held_by_pairs.cpp), and where contact has not begun to hold a body nothing makes it definite. So
// there is a ladder. Each rung changes how far the iteration goes, and none where the loop ends:
//
// 1. closed pairs hold, ever more stiffly;
// 2. springs hold every unknown where it is, ever more stiffly;
// 3. if the linear problem then has no solution, because a body would fly off before its pairs are found, weak springs, and
//    the way is bounded.
#include "addons/motion/linear_problem.hpp"

#include <array>
#include <utility>

#include "addons/motion/held_by_pairs.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {
namespace {

using Eigen::VectorXd;

/// Multiples of the mean stiffness.
struct Rung {
  double pairs;
  double springs;
};

constexpr std::array<Rung, 6> ladder = {
    {{40, 0}, {400, 0}, {4000, 0}, {40, 1e-3}, {40, 1e-2}, {40, 1e-1}}};
constexpr Rung weak = {40, 1e-6};

/// One try. \return nothing if K has no factor
std::optional<Solution> try_rung(const Rung& rung, const QuadraticProgramme& before,
                                 const TangentProblem& problem, Condensed& condensed,
                                 Ledger& ledger, std::string& reason) {
  Model& model = problem.model;
  model.programme.stiffness = before.stiffness;
  model.programme.load = before.load;
  const double mean = mean_stiffness(before);
  hold_by_pairs(problem.held, rung.pairs * mean, model.programme);
  hold_by_springs(rung.springs * mean, model.programme);
  std::vector<FreeMotion> modes;  // of K before strain, and of no other
  modes.swap(model.modes);
  std::optional<Solution> solution;
  try {
    condensed = condense(model, ledger);
    ledger.count("factors", 1);
    solution = solve(model, condensed, model.solver, std::exchange(ledger, {}), problem.options);
    ledger = std::move(solution->ledger);
  } catch (const ProblemError& error) {
    reason = error.what();
  }
  model.modes.swap(modes);
  return solution;
}

}  // namespace

Solution solve_with_one_factor(const Model& model, VectorXd free, const SolverOptions& options,
                               Condensed& condensed, Ledger ledger) {
  condensed.problem.law = model.law;
  {
    const Ledger::Phase phase(ledger, "compliance");  // as often as pairs are found
    condensed.problem.compliance = condensed.factor.compliance(model.programme.A, ledger);
  }
  move_freely(model, std::move(free), condensed);
  return solve(model, condensed, model.solver, std::move(ledger), options);
}

Solution solve_with_tangent(const TangentProblem& problem, Condensed& condensed, Ledger ledger,
                            bool& bounded) {
  const QuadraticProgramme before = problem.model.programme;
  std::string reason;
  std::optional<Solution> solution;
  bounded = false;
  for (const Rung& rung : ladder) {
    solution = try_rung(rung, before, problem, condensed, ledger, reason);
    if (solution) break;
  }
  const bool flies = solution && solution->contact.unbounded_direction.size() > 0;
  if (!solution || (flies && problem.held.empty())) {
    std::optional<Solution> small = try_rung(weak, before, problem, condensed, ledger, reason);
    bounded = small && small->contact.report.status == SolveStatus::Solved;
    if (bounded || !solution) solution = std::move(small);
  }
  if (!solution) {
    solution.emplace();
    solution->contact.report.status = SolveStatus::Breakdown;
    solution->contact.reason = text(
        "the tangent stays indefinite, however stiffly closed pairs and springs hold it: the material, or the body, "
        "has lost its stability there (", reason, "). Take neo_hooke, which resists any compression, shorter steps, or hold the body");
  }
  solution->ledger = std::move(ledger);
  return *std::move(solution);
}

}  // namespace signorini
