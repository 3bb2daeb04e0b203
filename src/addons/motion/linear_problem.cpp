// # The linear problem of an iteration
//
// If all strains are small, K is that of the scene, and so is its factor. An iteration then costs
// the compliance of the rows of its pairs. How contact forces turn is on the right then, see [corrected_solve.cpp](corrected_solve.cpp).
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
#include <limits>
#include <string>
#include <utility>

#include "addons/motion/curvature.hpp"
#include "addons/motion/held_by_pairs.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/fem/strain_law.hpp"
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
constexpr std::size_t last_turning = 2;  // later rungs slow the loop: no iteration begins with them
constexpr Rung weak = {false, 40, 1e-6};

/// What turning contact forces take from K.
Eigen::SparseMatrix<double> turned_by(const TangentProblem& problem) {
  const Model& model = problem.model;
  Eigen::SparseMatrix<double> turn(model.unknowns.count, model.unknowns.count);
  if (problem.turning.size() == 0) return turn;
  NodeArray places = model.standing->displacement;
  for (const BodyModel& body : model.bodies)
    places.middleRows(body.first_node, body.mesh.n_nodes()) += body.mesh.nodes;
  const Eigen::SparseMatrix<double> all =
      contact_curvature(problem.points, problem.turning, places);
  std::vector<Eigen::Triplet<double>> entries;
  const auto unknown = [&](Index component) {
    return static_cast<int>(model.unknowns.number(component / 2, component % 2));
  };
  for (Index column = 0; column < all.cols(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator it(all, column); it; ++it)
      if (unknown(it.row()) >= 0 && unknown(column) >= 0)
        entries.emplace_back(unknown(it.row()), unknown(column), it.value());
  turn.setFromTriplets(entries.begin(), entries.end());
  return turn;
}

/// Of an iteration, before a rung adds to it.
struct Tangent {
  Eigen::SparseMatrix<double> stiffness;
  VectorXd load;
  Eigen::SparseMatrix<double> turn;  ///< what turning contact forces take from `stiffness`
  double mean;                       ///< stiffness
};

/// Rigid motions are those of K before strain, and of no other: without them as long as this lives.
class WithoutModes {
 public:
  explicit WithoutModes(Model& model) : model_(model) { modes_.swap(model.modes); }
  ~WithoutModes() { modes_.swap(model_.modes); }
  WithoutModes(const WithoutModes&) = delete;
  WithoutModes& operator=(const WithoutModes&) = delete;
  WithoutModes(WithoutModes&&) = delete;
  WithoutModes& operator=(WithoutModes&&) = delete;

 private:
  Model& model_;
  std::vector<FreeMotion> modes_;
};

/// One try. \return nothing if K has no factor
std::optional<Solution> try_rung(const Rung& rung, const Tangent& tangent,
                                 const TangentProblem& problem, Condensed& condensed,
                                 Ledger& ledger) {
  Model& model = problem.model;
  QuadraticProgramme& programme = model.programme;
  programme.load = tangent.load;
  Eigen::SparseMatrix<double> more =
      hold_by_pairs(problem.held, rung.pairs * tangent.mean, programme);
  if (rung.turns) more -= tangent.turn;
  programme.stiffness = tangent.stiffness + more;
  hold_by_springs(rung.springs * tangent.mean, programme);
  const WithoutModes without(model);
  std::optional<Solution> solution;
  ledger.count("tangents tried", 1);
  try {
    condensed = condense(model, ledger);
    model.order = condensed.factor.order();  // patterns of a step hardly differ
    ledger.count("factors", 1);
    solution.emplace();
  } catch (const ProblemError&) {
    ledger.count("tangents without a factor", 1);
  }
  if (solution) {
    *solution =
        rung.turns && problem.turned
            ? corrected_solve(model, problem.turned, tangent.turn, problem.options, condensed,
                              std::exchange(ledger, {}))
            : solve(model, condensed, model.solver, std::exchange(ledger, {}), problem.options);
    ledger = std::move(solution->ledger);
  }
  return solution;
}

/// The side of a cell with a law that is shortened most, in words.
std::string most_shortened(const Model& model) {
  double least = std::numeric_limits<double>::infinity();
  std::string words;
  for (const BodyModel& body : model.bodies) {
    if (body.material.base.law == nullptr) continue;
    const Mesh& mesh = body.mesh;
    const auto moved = model.standing->displacement.middleRows(body.first_node, mesh.n_nodes());
    for (Index cell = 0; cell < mesh.n_cells(); ++cell)
      for (int k = 0; k < mesh.corners(cell); ++k) {
        const Index from = mesh.cells(cell, k);
        const Index to = mesh.cells(cell, (k + 1) % mesh.corners(cell));
        const Eigen::RowVector2d side = mesh.nodes.row(to) - mesh.nodes.row(from);
        const double left = (side + moved.row(to) - moved.row(from)).norm() / side.norm();
        if (left >= least) continue;
        least = left;
        words = text("a side of cell ", cell, " of '", mesh.name, "' (",
                     body.material.base.law->name, ") is ", left, " of what it was");
      }
  }
  return words.empty() ? "all strains are small" : words;
}

}  // namespace

Solution solve_with_one_factor(Model& model, VectorXd free, const TurnedForces& turned,
                               const SolverOptions& options, Condensed& condensed, Ledger ledger) {
  condensed.problem.law = model.law;
  {
    const Ledger::Phase phase(ledger, "compliance");  // as often as pairs are found
    condensed.problem.compliance = condensed.factor.compliance(model.programme.A, ledger);
  }
  move_freely(model, std::move(free), condensed);
  if (!turned) return solve(model, condensed, model.solver, std::move(ledger), options);
  const Eigen::SparseMatrix<double> none(model.unknowns.count, model.unknowns.count);
  return corrected_solve(model, turned, none, options, condensed, std::move(ledger));
}

Solution solve_with_tangent(const TangentProblem& problem, Condensed& condensed, Ledger ledger,
                            bool& bounded) {
  QuadraticProgramme& programme = problem.model.programme;
  Tangent tangent{{}, programme.load, turned_by(problem), mean_stiffness(programme)};
  tangent.stiffness.swap(programme.stiffness);
  std::optional<Solution> solution;
  bounded = false;
  const std::size_t first = problem.rung > last_turning ? 0 : problem.rung;
  for (std::size_t k = first; k < ladder.size(); ++k) {
    solution = try_rung(ladder[k], tangent, problem, condensed, ledger);
    problem.rung = k;
    if (solution) break;
  }
  const bool flies = solution && solution->contact.unbounded_direction.size() > 0;
  if (!solution || (flies && problem.held.empty())) {
    std::optional<Solution> small = try_rung(weak, tangent, problem, condensed, ledger);
    bounded = small && small->contact.report.status == SolveStatus::Solved;
    if (bounded || !solution) solution = std::move(small);
  }
  if (!solution) {
    solution.emplace();
    solution->contact.report.status = SolveStatus::Breakdown;
    solution->contact.reason =
        text("the tangent stays indefinite, however stiffly closed pairs and springs hold it: a body has lost its "
             "stability, where ", most_shortened(problem.model),
             ". Take shorter steps, hold the body, or a law that resists at such a strain");
  }
  programme.stiffness.swap(tangent.stiffness);
  programme.load.swap(tangent.load);
  solution->ledger = std::move(ledger);
  return *std::move(solution);
}

}  // namespace signorini
