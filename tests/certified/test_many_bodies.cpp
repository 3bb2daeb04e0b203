// Stacks of blocks that contact alone holds: by the entries that are there, and by the dense systems of the methods.
#include "addons/certified/many_bodies.hpp"

#include "addons/certified/pair_sweeps.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "support/stack.hpp"

using namespace signorini;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini_test::stack;

namespace {

/// One scene, condensed.
struct Prepared {
  Ledger ledger;
  Model model;
  Condensed condensed;
  explicit Prepared(const Scene& scene)
      : model(build(scene, ledger)), condensed(condense(model, ledger)) {}
};

/// The method of the default alone: it sees the dense problem.
Solver alone() { return primal_dual_active_set().before({}); }

}  // namespace

TEST_CASE("a stack of blocks by its few entries: the same forces after few sets", "[many_bodies]") {
  for (const double friction : {0.0, 0.3}) {
    Prepared scene(stack(26, friction));
    const MatrixXd modes = mode_shapes(scene.model.modes);
    CAPTURE(friction, modes.cols());
    REQUIRE(modes.cols() >= many_motions);
    const CondensedProgramme condensed = condensed_programme(scene.condensed, scene.ledger);
    const auto sparse = many_bodies_solution(scene.model.programme, condensed, modes, {}, scene.ledger);
    REQUIRE(sparse.has_value());
    CHECK(sparse->certificate.worst() <= certificate_tolerance);
    CHECK(sparse->state.report.iterations <= 10);
    const CertifiedSolution dense = certified_solve(scene.model.programme, condensed, modes, alone(),
                                                    {}, scene.ledger);
    REQUIRE(dense.state.report.status == SolveStatus::Solved);
    const double size = largest(dense.solution.force);
    CHECK(largest(VectorXd(sparse->solution.force - dense.solution.force)) <= 1e-9 * size);
    // Where they move to is the same as well, and what of it is rigid.
    CHECK(largest(VectorXd(sparse->solution.displacement - dense.solution.displacement)) <=
          1e-9 * largest(dense.solution.displacement));
    CHECK(largest(VectorXd(modes * (sparse->state.amplitude - dense.state.amplitude))) <=
          1e-9 * largest(VectorXd(modes * dense.state.amplitude)));
    CHECK(all_statuses(sparse->state) == all_statuses(dense.state));
  }
}

TEST_CASE("the condensed problem of a stack has the same forces", "[many_bodies]") {
  for (const double friction : {0.0, 0.3}) {
    Prepared scene(stack(26, friction));
    const ContactProblem& problem = scene.condensed.problem;
    const auto sparse = many_bodies_state(problem, {});
    CAPTURE(friction);
    REQUIRE(sparse.has_value());
    CHECK(certify(problem, *sparse).worst() <= 0.25 * certificate_tolerance);
    const ContactState dense = solve_with_proofs(problem, alone(), {});
    REQUIRE(dense.report.status == SolveStatus::Solved);
    CHECK(largest(VectorXd(sparse->force - dense.force)) <= 1e-9 * largest(dense.force));
    CHECK(all_statuses(*sparse) == all_statuses(dense));
    // The statuses of a solution are confirmed by one set.
    SolverOptions options;
    options.start = all_statuses(dense);
    const auto again = many_bodies_state(problem, options);
    REQUIRE(again.has_value());
    CHECK(again->report.iterations == 1);
  }
}

TEST_CASE("what no contact holds has no answer by few entries", "[many_bodies]") {
  Scene scene = stack(26, 0);
  scene.bodies.back().loads.edges = {{"top", -1, {}}};  // lifts the top block
  scene.bodies.back().loads.points.clear();
  Prepared prepared(scene);
  CHECK_FALSE(many_bodies_state(prepared.condensed.problem, {}).has_value());
  const CondensedProgramme condensed = condensed_programme(prepared.condensed, prepared.ledger);
  CHECK_FALSE(many_bodies_solution(prepared.model.programme, condensed,
                                   mode_shapes(prepared.model.modes), {}, prepared.ledger)
                  .has_value());
}

TEST_CASE("few bodies and methods that were asked for are left alone", "[many_bodies]") {
  SolverOptions limited;
  limited.iteration_limit = 3;
  CHECK(many_bodies(many_motions, primal_dual_active_set(), {}));
  CHECK_FALSE(many_bodies(many_motions - 1, primal_dual_active_set(), {}));
  CHECK_FALSE(many_bodies(many_motions, primal_dual_active_set(), limited));
  CHECK_FALSE(many_bodies(many_motions, alone(), {}));
}

TEST_CASE("a pair alone is open, sticks or slides as its equations say", "[many_bodies]") {
  // F = (2, 0.5; 0.5, 1): what it does without forces decides.
  const auto force = [](double gap, double slip, double mu, double cohesion = 0) {
    return lone_pair_force({gap, slip, 2, 0.5, 0.5, 1, mu, cohesion});
  };
  CHECK(force(0.1, 3, 0.5).isZero(0));
  // Closed without slip: 2 l + 0.5 t = 4, 0.5 l + t = 1 gives l = 2, t = 0.
  CHECK((force(-4, -1, 0.5) - Eigen::Vector2d(2, 0)).norm() <= 4 * epsilon);
  // Forward, t = -l/2: 2 l - l/4 = 3.5, and the slip is 5 + 1 - 1.
  CHECK((force(-3.5, 5, 0.5) - Eigen::Vector2d(2, -1)).norm() <= 4 * epsilon);
  // Backward, t = l/2: 2 l + l/4 = 4.5, and the slip is -5 + 1 + 1.
  CHECK((force(-4.5, -5, 0.5) - Eigen::Vector2d(2, 1)).norm() <= 4 * epsilon);
  // With cohesion alone the bound is given: t = -1, 2 l - 0.5 = 3.5.
  CHECK((force(-3.5, 5, 0, 1) - Eigen::Vector2d(2, -1)).norm() <= 4 * epsilon);
}

TEST_CASE("sweeps over coupled pairs end at a solution", "[many_bodies]") {
  // Two pairs, the second without friction: rows are two gaps and the slip of the first.
  ContactProblem problem;
  problem.compliance.resize(3, 3);
  problem.compliance << 2, 0.5, 0.2, 0.5, 1, 0.1, 0.2, 0.1, 1;
  problem.free_gap = Eigen::Vector2d(-1, -0.5);
  problem.free_slip = VectorXd::Constant(1, 0.4);
  problem.law = {{0}, VectorXd::Constant(1, 0.3), VectorXd::Zero(1)};
  VectorXd force = VectorXd::Zero(3);
  // Each sweep leaves less than half: fifty leave a rounding.
  sweep_pairs(problem.compliance.sparseView(), free_movement(problem), problem.law, 50, force);
  const VectorXd movement = free_movement(problem) + problem.compliance * force;
  ContactState state;
  fill_state(problem.law, {ContactStatus::SlipForward, ContactStatus::Stick}, force, movement, state);
  CHECK(certify(problem, state).worst() <= 16 * epsilon);
  CHECK(force(2) == Approx(-0.3 * force(0)).epsilon(4 * epsilon));
}
