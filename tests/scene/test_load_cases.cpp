// Many loads with one factor: change_loads() against models that are built anew.
#include "catch_compat.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/scene/scene.hpp"
#include "support/hertz.hpp"
#include "support/message.hpp"

using namespace signorini;
using signorini_test::problem_message;

namespace {

/// A beam that bends down onto a foundation; its right side is moved.
Scene beam(double pressure) {
  Scene scene;
  BlockSpec block;
  block.size = {10, 1};
  block.cells_x = 20;
  block.cells_y = 2;
  Body& body = scene.bodies[0];
  body.mesh = make_block(block);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.supports = {fixed("left"), prescribed("right", Axis::X, 0.01)};
  if (pressure != 0) body.loads.edges = {{"top", pressure, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, -0.1}, {0, 1})}};
  return scene;
}

void check_same(const Solution& one, const Solution& other) {
  REQUIRE(one.contact.report.status == Status::Solved);
  REQUIRE(other.contact.report.status == Status::Solved);
  CHECK(one.contact.active == other.contact.active);
  CHECK(one.contact.force == other.contact.force);
  for (std::size_t b = 0; b < one.displacements.size(); ++b)
    CHECK(one.displacements[b] == other.displacements[b]);
}

}  // namespace

TEST_CASE("other loads on a model without any are those of a new model, bit by bit", "[scene]") {
  Ledger ledger;
  Model model = build(beam(0), ledger);
  Condensed condensed = condense(model, ledger);
  for (const double pressure : {1.0, 0.1, 0.3, 0.0, 1.0}) {
    const Scene fresh = beam(pressure);
    change_loads({fresh.bodies[0].loads}, model, condensed);
    check_same(solve(model, condensed, ledger), solve(fresh));
  }
}

TEST_CASE("loads take the place of those that were there, on all bodies", "[scene]") {
  const Scene scene = signorini_test::hertz();  // the disc is held by contact alone
  std::vector<Loads> loads = {scene.bodies[0].loads, scene.bodies[1].loads};
  Ledger ledger;
  Model model = build(scene, ledger);
  Condensed condensed = condense(model, ledger);
  const Solution first = solve(model, condensed, ledger);
  require_solved(first, "Hertz");
  std::vector<Loads> twice = loads;
  twice[0].edges[0].pressure *= 2;
  change_loads(twice, model, condensed);
  const Solution second = solve(model, condensed, ledger);
  require_solved(second, "Hertz, twice");
  CHECK(std::abs(second.contact.force.sum() / first.contact.force.sum() - 2) < 1e-10);
  change_loads(loads, model, condensed);
  const Solution third = solve(model, condensed, ledger);
  require_solved(third, "Hertz again");
  CHECK((third.contact.force - first.contact.force).norm() <= 1e-10 * first.contact.force.norm());
}

TEST_CASE("a change that cannot be meant changes nothing", "[scene]") {
  Ledger ledger;
  Model model = build(beam(1), ledger);
  Condensed condensed = condense(model, ledger);
  const Eigen::VectorXd load = model.programme.load;
  const Eigen::VectorXd gap = condensed.problem.free_gap;
  Loads lost;
  lost.edges = {{"tip", 1, {}}};
  CHECK_THAT(problem_message([&] { change_loads({lost}, model, condensed); }),
             ContainsSubstring("tip"));
  CHECK_THAT(problem_message([&] {
               change_loads({lost, lost}, model, condensed);
             }),
             ContainsSubstring("expected the loads of 1 bodies, got those of 2"));
  CHECK(model.programme.load == load);
  CHECK(condensed.problem.free_gap == gap);
  CHECK(model.bodies[0].loads.edges[0].boundary == "top");
}
