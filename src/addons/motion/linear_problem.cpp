// # The linear problem of an iteration
//
// If all strains are small, K is that of the scene, and so is its factor. An iteration then costs
// the compliance of the rows of its pairs. Under finite strain K is the tangent of the place, and is factored. How contact forces turn is
// on the right in both, see [corrected_solve.cpp](corrected_solve.cpp).
//
// A tangent may be indefinite in a body that is stable. A block of rubber between rough plates is stable when it is pressed to half of
// its height. Its tangent is not positive definite from a sixth on: without the plates it would buckle, and the tangent does not know
// of the plates. Their hold is in the rows of contact. So it is put into K, where the factor sees it:
// \f[ K + \rho A_c^T A_c, \qquad p + \rho A_c^T g_c \f]
// with the rows c of pairs that press. If they do hold, \f$ A_c u = g_c \f$, both sides of \f$ Ku = p - A^T\lambda \f$ have got
// the same, and neither u nor \f$ \lambda \f$ is another. By hand: K = -1, one row A = 1, g = 0 and p = 2 have u = 0 and the
// force 2. With \f$ \rho = 3 \f$ the matrix is 2, positive, and u = 0 with the force 2 solves that too.
//
// Where contact has not begun to hold a body nothing makes it definite. So there is a ladder. Each rung changes how the way is found,
// and none where the loop ends:
//
// 1. closed pairs hold, ever more stiffly;
// 2. springs hold every unknown where it is, ever more stiffly. Weak ones only let the matrix have a factor. Like contact forces that turn
//    they are on the right as well, so that they do not shorten the way; that of stiffer ones is what makes iterations go less far.
//
// A body that lies in a bowl is held by nothing but how contact forces turn. Then the first tangents have no factor, or one of rounding,
// whose corrections lead away; with weak springs they find what resists.
#include "addons/motion/linear_problem.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include "addons/motion/linearised_model.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/strain_law.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// Multiples of the mean stiffness.
struct Rung {
  double pairs;
  double springs;
};

constexpr std::array<Rung, 7> ladder = {
    {{40, 0}, {400, 0}, {4000, 0}, {40, 1e-6}, {40, 1e-4}, {40, 1e-2}, {40, 1e-1}}};
constexpr std::size_t stiff_springs = 6;  // these make ways short; weaker ones are on the right as well
constexpr std::size_t unstable = 5;       // a body that such springs hold at the end has lost its stability

/// Makes \f$ \rho A_c^T A_c \f$, which belongs to K, and adds \f$ \rho A_c^T g_c \f$ to p. Where one of the rows c is about to open it resists
/// a little, as a spring that is at rest where it holds.
Eigen::SparseMatrix<double> hold_by_pairs(const std::vector<Index>& rows, double stiffness,
                                          QuadraticProgramme& programme) {
  const NodalRows held = selected_rows(programme.A, rows);
  programme.load += stiffness * (held.transpose() * programme.initial_gap(rows));
  return stiffness * (held.transpose() * held);
}

/// What turning contact forces lack, and weak springs, which are on all unknowns. While supports are on their way nothing turns yet,
/// and springs shorten the way.
TurnedForces lacking(const TangentProblem& problem, std::size_t rung, double spring) {
  if (rung < weak_springs || rung >= stiff_springs || !problem.turned.along) return problem.turned;
  TurnedForces lack{std::vector<Index>(at(problem.model.unknowns.count))};
  std::iota(lack.unknowns.begin(), lack.unknowns.end(), 0);
  lack.along = [&turned = problem.turned, spring](const VectorXd& way, const VectorXd& force) {
    VectorXd load = spring * way;
    load(turned.unknowns) += turned.along(way(turned.unknowns), force);
    return load;
  };
  return lack;
}

/// One try. \return nothing if K has no factor
/// \param trial  the model of the problem, but for K, p and rigid motions, which are those before strain
std::optional<Corrected> try_rung(std::size_t number, const TangentProblem& problem, Model& trial,
                                  Condensed& condensed, Ledger& ledger) {
  const QuadraticProgramme& here = problem.model.programme;
  QuadraticProgramme& programme = trial.programme;
  const Rung& rung = ladder[number];
  const double mean = here.stiffness.diagonal().cwiseAbs().mean();
  programme.load = here.load;
  programme.stiffness = here.stiffness + hold_by_pairs(problem.held, rung.pairs * mean, programme);
  if (rung.springs > 0) programme.stiffness.diagonal().array() += rung.springs * mean;
  ledger.count("tangents tried", 1);
  try {
    condensed = condense(trial, ledger);
  } catch (const ProblemError&) {
    ledger.count("tangents without a factor", 1);
    return {};
  }
  problem.model.order = trial.order = condensed.factor.order();  // patterns of a step hardly differ
  ledger.count("factors", 1);
  if (rung.springs > 0) ledger.count("held by springs", 1);
  Corrected tried = corrected_solve(trial, lacking(problem, number, rung.springs * mean),
                                    problem.options, condensed, std::exchange(ledger, {}));
  ledger = std::move(tried.solution.ledger);
  return tried;
}

}  // namespace

std::string most_shortened(const Model& model) {
  double least = 1;
  std::string words = "no side of a cell is shorter than it was";
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
                     body.material.of(cell).law->name, ") is ", left, " of what it was");
      }
  }
  return words;
}

Solution solve_with_tangent(const TangentProblem& problem, Condensed& condensed, Ledger ledger) {
  Model trial = without_stiffness(problem.model);
  trial.modes.clear();  // K before strain has them
  std::optional<Solution> solution;
  for (std::size_t k = problem.rung < weak_springs ? problem.rung : 0; k < ladder.size(); ++k) {
    std::optional<Corrected> next = try_rung(k, problem, trial, condensed, ledger);
    if (!next) continue;
    solution = std::move(next->solution);
    problem.rung = k;
    if (next->closer) break;
    k = std::max(k, weak_springs - 1);  // pairs do not make it definite
  }
  if (!solution) {
    solution.emplace();
    solution->contact.report.status = SolveStatus::Breakdown;
    solution->contact.reason = why_indefinite(problem.model, problem.held, ladder.size());
  }
  solution->ledger = std::move(ledger);
  return *std::move(solution);
}

std::vector<Index> held_rows(const std::vector<ContactStatus>& statuses, const FrictionLaw& law) {
  std::vector<Index> rows;
  const Index pairs = static_cast<Index>(statuses.size());
  for (Index pair = 0; pair < pairs; ++pair)
    if (statuses[at(pair)] != ContactStatus::Open) rows.push_back(pair);
  for (std::size_t k = 0; k < law.pair.size(); ++k)
    if (statuses[at(law.pair[k])] == ContactStatus::Stick)
      rows.push_back(pairs + static_cast<Index>(k));
  return rows;
}

std::string why_indefinite(const Model& model, const std::vector<Index>& held, std::size_t rung) {
  const auto motions = [&model] {
    return joined(motions_without_contact(selected_rows(model.programme.A, {}), model.modes), "; ");
  };
  const bool free = !model.modes.empty();
  if (free && held.empty())
    return text("no pair presses, and nothing else holds the bodies: ", motions(),
                ". Turn the load round or add a support");
  if (rung < unstable) return {};
  if (free)
    return text("contact alone holds the bodies, and iterations did not come to where it does: ", motions(),
                ". Take shorter steps, draw them nearer to where they come to rest, or add a support");
  return text("the tangent is indefinite, however stiffly closed pairs hold it: a body has lost its stability, where ",
              most_shortened(model),
              ". Take shorter steps, hold the body, or a law that resists at such a strain");
}

}  // namespace signorini
