// # The linear problem of an iteration
//
// If all strains are small, K is that of the scene, and so is its factor. An iteration then costs the compliance of the rows
// of its pairs.
//
// Under finite strain K is the tangent of the place, and is factored. A tangent may be indefinite in a body that is stable,
// see [held_by_pairs.cpp](held_by_pairs.cpp), and where contact has not begun to hold a body nothing makes it definite. So
// there is a ladder. Each rung changes how far the iteration goes, and none where the loop ends:
//
// 1. contact forces turn with the bodies, and closed pairs hold, ever more stiffly;
// 2. contact forces keep their directions: what turns may be what makes the tangent indefinite;
// 3. springs hold every unknown where it is, ever more stiffly;
// 4. if the linear problem then has no solution, because a body would fly off before its pairs are found, weak springs, and
//    the way is bounded.
#include "addons/motion/linear_problem.hpp"

#include <array>
#include <utility>

#include "addons/motion/curvature.hpp"
#include "addons/motion/held_by_pairs.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Multiples of the mean stiffness.
struct Rung {
  bool turns;
  double pairs;
  double springs;
};

constexpr std::array<Rung, 8> ladder = {{{true, 40, 0},
                                         {true, 400, 0},
                                         {true, 4000, 0},
                                         {false, 40, 0},
                                         {false, 4000, 0},
                                         {false, 40, 1e-3},
                                         {false, 40, 1e-2},
                                         {false, 40, 1e-1}}};
constexpr Rung weak = {false, 40, 1e-6};

/// K less what turning contact forces add to it.
void turn_forces(const TangentProblem& problem, QuadraticProgramme& programme) {
  const Model& model = problem.model;
  if (problem.turning.size() == 0) return;
  NodeArray places = model.standing->displacement;
  for (const BodyModel& body : model.bodies)
    places.middleRows(body.first_node, body.mesh.n_nodes()) += body.mesh.nodes;
  const Eigen::SparseMatrix<double> all = contact_curvature(model.pairs, problem.turning, places);
  std::vector<Eigen::Triplet<double>> entries;
  const auto unknown = [&](Index component) {
    return static_cast<int>(model.unknowns.number(component / 2, component % 2));
  };
  for (Index column = 0; column < all.cols(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator it(all, column); it; ++it)
      if (unknown(it.row()) >= 0 && unknown(column) >= 0)
        entries.emplace_back(unknown(it.row()), unknown(column), it.value());
  Eigen::SparseMatrix<double> turn(model.unknowns.count, model.unknowns.count);
  turn.setFromTriplets(entries.begin(), entries.end());
  programme.stiffness = (programme.stiffness - turn).eval();
}

/// One try. \return nothing if K has no factor
std::optional<Solution> try_rung(const Rung& rung, const QuadraticProgramme& before,
                                 const TangentProblem& problem, Condensed& condensed,
                                 Ledger& ledger, std::string& reason) {
  Model& model = problem.model;
  model.programme.stiffness = before.stiffness;
  model.programme.load = before.load;
  const double mean = mean_stiffness(before);
  if (rung.turns) turn_forces(problem, model.programme);
  hold_by_pairs(problem.held, rung.pairs * mean, model.programme);
  hold_by_springs(rung.springs * mean, model.programme);
  std::vector<FreeMotion> modes;  // of K before strain, and of no other
  modes.swap(model.modes);
  std::optional<Solution> solution;
  ledger.count("tangents tried", 1);
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
