// The forces that obstacle and supports put on the nodes.
#include "catch_compat.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/message.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::cantilever;

// The clamp and the foundation bear 3.6 kN/cm^2 on 50 cm, and their moment about the clamp. 1e-10: what
// displacements in doubles leave of the balance.
TEST_CASE("forces of supports, obstacle and loads balance", "[solved]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible", "q8"}) {
    CAPTURE(element);
    const Scene scene = cantilever(element, 50, 5);
    const auto [model, condensed, solution] = solved(scene, "the beam");
    const NodeArray support = support_forces(model, solution);
    const NodeArray obstacle = contact_forces(model, solution);
    const NodeArray sum = support + obstacle;
    CHECK(sum.col(0).sum() == Approx(0).margin(1e-8));
    CHECK(sum.col(1).sum() == Approx(180).epsilon(1e-10));
    CHECK(sum.col(1).dot(model.bodies[0].mesh.nodes.col(0)) -
              sum.col(0).dot(model.bodies[0].mesh.nodes.col(1)) ==
          Approx(180 * 25).epsilon(1e-9));
    CHECK(obstacle.col(1).sum() == Approx(solution.contact.force.sum()).epsilon(1e-14));
    for (Index node = 0; node < model.bodies[0].mesh.n_nodes(); ++node)
      if (model.bodies[0].mesh.nodes(node, 0) > 0 && support.row(node).norm() > 1e-8)
        FAIL("node " << node << " is held by nothing");
  }
}

TEST_CASE("the forces on a boundary are those of obstacle and supports", "[solved]") {
  const Scene scene = cantilever("q4", 20, 4);
  const SolvedScene run = solved(scene, "the beam");
  const BoundaryForces below = boundary_forces(run, {"bottom"});
  REQUIRE(below.force.rows() == 21);
  const NodeArray support = support_forces(run.model, run.solution);
  CHECK(below.force.row(0) == support.row(0));  // the clamped corner has no pair
  CHECK(below.force.col(1).tail(20) == run.solution.contact.force);
  CHECK(below.force.col(0).tail(20).norm() == 0);
  CHECK(below.weight.sum() == Approx(50).epsilon(1e-14));
  CHECK(below.position(20, 0) == 50);
  const BoundaryForces clamp = boundary_forces(run, {"left"});
  CHECK(clamp.force.col(1).sum() + run.solution.contact.force.sum() == Approx(180).epsilon(1e-10));
  CHECK_THROWS_AS(boundary_forces(run, {"side"}), ProblemError);
}

TEST_CASE("a scene that is not solved has no forces", "[solved]") {
  const Scene scene = cantilever("q4", 10, 1);
  auto run = solved(scene, "the beam");
  run.solution.contact.report.status = SolveStatus::IterationLimit;
  CHECK_THROWS_AS(contact_forces(run.model, run.solution), std::invalid_argument);
  CHECK_THROWS_AS(support_forces(run.model, run.solution), std::invalid_argument);
  CHECK_THROWS_AS(internal_forces(run.model.bodies[0].mesh, run.model.bodies[0].element,
                                  run.model.bodies[0].material, NodeArray::Zero(3, 2)),
                  std::invalid_argument);
}
