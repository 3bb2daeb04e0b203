// Two bodies of which contact alone holds one: the uncondensed method, and what is refused.
#include <sstream>

#include "catch_compat.hpp"
#include "papers/saddle_point_newton.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/solvers.hpp"
#include "support/hertz.hpp"
#include "support/message.hpp"

using namespace signorini;
using signorini_test::hertz;
using signorini_test::hertz_load;

TEST_CASE("the uncondensed Newton method comes to the same forces", "[two_bodies][LinEtAl-31]") {
  Ledger ledger;
  const Scene scene = hertz();
  const Model model = build(scene, ledger);
  const Solution ours = solve(model, condense(model, ledger), scene.solver, ledger);
  CHECK(ours.contact.report.iterations <= 10);
  SaddlePointOptions options;
  options.start_force = hertz_load / 2 * model.pairs.weight / model.pairs.weight.sum();
  const SaddlePointSolution paper = saddle_point_newton(model.programme, options);
  CHECK(paper.report.status == SolveStatus::Solved);
  CHECK(paper.report.iterations <= 15);
  CHECK((paper.solution.force - ours.contact.force).norm() <= 1e-11 * ours.contact.force.norm());
  options.start_force = Eigen::VectorXd::Ones(3);
  CHECK_THROWS_WITH(saddle_point_newton(model.programme, options), ContainsSubstring("got 3"));
}

TEST_CASE("the plan names the motion that only contact holds", "[two_bodies][floating]") {
  std::ostringstream out;
  out << plan(hertz());
  CHECK_THAT(out.str(),
             ContainsSubstring("body 'disc'") &&
                 ContainsSubstring("can move freely in direction y: only contact holds"));
}

TEST_CASE("a body that is pulled away is refused by name", "[two_bodies][floating]") {
  Scene scene = hertz();
  scene.bodies[0].loads.edges[0].pressure *= -1;
  CHECK_THROWS_WITH(solved(scene, "the disc"), ContainsSubstring("pulls a body away") &&
                                                   ContainsSubstring("body 'disc'") &&
                                                   ContainsSubstring("direction y"));
  CHECK_THROWS_AS(solved(scene, "the disc"), NotSolved);
}

TEST_CASE("what no contact can stop needs a support", "[two_bodies][floating]") {
  Scene scene = hertz();
  scene.bodies[0].supports.clear();  // the disc can now roll, and slide along the plate
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("no contact stops that: add a support") &&
                                     ContainsSubstring("direction x"));
  scene.contacts.clear();
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("can") && ContainsSubstring("add a support"));
}

TEST_CASE("names of bodies and operators are looked up", "[two_bodies][input]") {
  Scene scene = hertz();
  scene.contacts[0].source.body = "disk";
  CHECK_THROWS_WITH(plan(scene),
                    ContainsSubstring("no body 'disk'") && ContainsSubstring("'disc', 'plate'"));
  scene = hertz();
  scene.contacts[0].gap_operator = "motar";
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("motar") && ContainsSubstring("mortar"));
  scene = hertz();
  scene.bodies[1].mesh.name = "disc";
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("two bodies are called 'disc'"));
  scene = hertz();
  scene.bodies[1].material.thickness = 2;
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("1 and 2 thick"));
}

TEST_CASE("the order of the bodies does not matter", "[two_bodies]") {
  const Scene scene = hertz();
  Scene swapped = scene;
  std::swap(swapped.bodies[0], swapped.bodies[1]);
  const Solution first = solve(scene);
  const Solution second = solve(swapped);
  CHECK((second.contact.force - first.contact.force).norm() <= 1e-11 * first.contact.force.norm());
  CHECK((second.displacements[1] - first.displacements[0]).norm() <=
        1e-10 * first.displacements[0].norm());
}

TEST_CASE("forces of contact and supports balance body by body", "[two_bodies]") {
  const Scene scene = hertz();
  const SolvedScene run = solved(scene, "the disc");
  for (std::size_t b = 0; b < 2; ++b) {
    const NodeArray sum =
        contact_forces(run.model, run.solution, b) + support_forces(run.model, run.solution, b);
    CHECK(sum.col(1).sum() == Approx(b == 0 ? hertz_load / 2 : 0).margin(1e-9 * hertz_load));
  }
}
