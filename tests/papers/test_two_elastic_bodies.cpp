// The printed method on two elastic bodies, which the paper treats like one body and an obstacle.
#include "catch_compat.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/scene.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

namespace {

// A block of 8 x 2 with E = 100 is pressed by 0.01 onto one of 8 x 4 with E = 50, whose top falls off like crown x^2.
Scene stacked(double crown) {
  Scene scene;
  scene.bodies.resize(2);
  Body& upper = scene.bodies[0];
  upper.mesh = block("upper", {0, 0}, {8, 2}, 8, 4);
  upper.material = {100, 0.3, PlaneState::Stress, 1};
  upper.supports = {prescribed("left", Axis::X, 0.0), prescribed("top", Axis::Y, -0.01)};
  Body& lower = scene.bodies[1];
  lower.mesh =
      mapped(block("lower", {0, -4}, {8, 4}, 8, 8), [crown](const Vector2d& x) -> Vector2d {
        return {x.x(), x.y() - crown * (1 + x.y() / 4) * x.x() * x.x()};
      });
  lower.material = {50, 0.2, PlaneState::Stress, 1};
  lower.supports = {prescribed("left", Axis::X, 0.0), prescribed("bottom", Axis::Y, 0.0)};
  scene.contacts = {{{"bottom", "upper"}, Side{"top", "lower"}, "node_to_segment"}};
  return scene;
}

QuasiActiveRun printed(const Scene& scene) {
  Ledger ledger;
  return run_quasi_active_set_literal(condense(build(scene, ledger), ledger).problem);
}

}  // namespace

// The pressure is 0.01 / (2/100 + 4/50) = 0.1 everywhere. All nine pairs overlap by 0.01 without contact.
TEST_CASE("two elastic blocks close in one printed step, with the pressure of both in series",
          "[literal][closed-form][XuanLi2002-13]") {
  const QuasiActiveRun run = printed(stacked(0));
  REQUIRE(run.state.report.status == SolveStatus::Solved);
  CHECK(run.outer_steps == 1);
  CHECK(run.steps[0].quasi_active.size() == 9);
  CHECK(run.state.force.sum() == Approx(0.8).epsilon(1e-12));  // eta
  for (Index i = 0; i < 9; ++i)
    CHECK(run.state.force(i) == Approx(i == 0 || i == 8 ? 0.05 : 0.1).epsilon(1e-11));
}

TEST_CASE("on a crowned block the printed method closes the pairs that the default solver closes",
          "[literal]") {
  const Scene scene = stacked(1e-3);  // a gap of 0.01 at x = 3.2
  const QuasiActiveRun run = printed(scene);
  const Solution solution = solve(scene);
  REQUIRE(run.state.report.status == SolveStatus::Solved);
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  CHECK(run.outer_steps == 1);
  CHECK((run.state.active().size() > 1 && run.state.active().size() < 5));
  CHECK(run.state.active() == solution.contact.active());
  CHECK((run.state.force - solution.contact.force).norm() <= 1e-10 * run.state.force.norm());
}
