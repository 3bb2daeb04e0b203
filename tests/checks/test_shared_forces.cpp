// Notes on forces that are not determined, against dense arithmetic of another kind, closed forms and certificates.
#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "meshes/reshape.hpp"
#include "support/facing_blocks.hpp"
#include "support/shared_forces.hpp"
#include "support/two_bodies.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// The note on forces that are not determined, or nothing.
std::string note_of(const Solution& solution) {
  for (const std::string& note : solution.notes)
    if (note.find("are not determined (") != note.npos) return note;
  return "";
}

/// A block in a corner of two walls, pressed into it from above and from the right, all of it turned and moved.
Scene corner(double first, double second, double angle = 0, const Vector2d& shift = {0, 0}) {
  const auto turn = [&](const Vector2d& v) -> Vector2d {
    return {std::cos(angle) * v.x() - std::sin(angle) * v.y(),
            std::sin(angle) * v.x() + std::cos(angle) * v.y()};
  };
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = mapped(named_block("block", {0, 0}, {1, 1}, 6, 6),
                     [&](const Vector2d& x) -> Vector2d { return shift + turn(x); });
  body.material = {1000, 0.3, PlaneState::Stress, 1};
  body.loads.edges = {{"top", 1, {}}, {"right", 1, {}}};
  scene.contacts = {{{"bottom"}, half_plane(shift, turn({0, 1}))},
                    {{"left"}, half_plane(shift, turn({1, 0}))}};
  if (first > 0) scene.contacts[0].friction = Friction{first, 0};
  if (second > 0) scene.contacts[1].friction = Friction{second, 0};
  return scene;
}

}  // namespace

TEST_CASE("what is not determined is named, and nothing else", "[scene][friction][random]") {
  const SharedForceCounts counts = compare_shared_forces(0, 150);
  CHECK(counts.open >= 50);
  CHECK(counts.solved - counts.open >= 50);
  CHECK(100 * counts.missed <= counts.open);
  CHECK(20 * counts.in_vain <= counts.solved - counts.open);
  CHECK(100 * counts.pairs_missed <= counts.pairs);
  CHECK(20 * counts.pairs_in_vain <= counts.pairs);
  for (const std::string& wrong : counts.wrong) UNSCOPED_INFO(wrong);
  CHECK(counts.wrong.empty());
}

TEST_CASE("the ends of a range are solutions, and nothing beyond them is", "[scene][friction]") {
  Ledger ledger;
  const Model model = build(corner(2, 0), ledger);
  const Solution solution = solve(model, condense(model, ledger), ledger);
  REQUIRE(solution.shared.size() == 1);
  const SharedForces& group = solution.shared[0];
  REQUIRE(group.exchanges.cols() == 1);
  REQUIRE_FALSE(group.forces.empty());
  const VectorXd exchange = VectorXd(group.exchanges.col(0));
  for (const ForceRange& range : group.forces)
    for (const double end : {range.low, range.high}) {
      const double share = (end - solution.refined.force(range.row)) / exchange(range.row);
      const auto certificate = [&](double part) {
        PrimalDual other = solution.refined;
        other.force += part * share * exchange;
        return certify(model.programme, other, model.law);
      };
      CAPTURE(range.row, range.low, range.high, share);
      CHECK(certificate(1).holds());
      CHECK(certificate(0.5).holds());
      if (std::abs(share) > 1e-6) CHECK_FALSE(certificate(1.01).holds());
    }
}

TEST_CASE("ranges and sum of what is not determined turn with the scene", "[scene][friction]") {
  const Solution straight = solve(corner(2, 0.2));
  REQUIRE(straight.shared.size() == 1);
  CHECK_THAT(note_of(straight),
             ContainsSubstring("contact forces of 2 pairs are not determined (0, 13)") &&
                 ContainsSubstring("pair 0 of node 0 of body 'block' at (0, 0) presses with ") &&
                 ContainsSubstring("pairs 0, 13 together push body 'block' with (0.0341956, "
                                   "0.0729141)") &&
                 ContainsSubstring("A node is in several contacts"));
  for (int step = 1; step < 20; ++step) {
    const Vector2d shift = step % 2 == 0 ? Vector2d(0, 0) : Vector2d(-30, 20);
    const Solution turned = solve(corner(2, 0.2, 0.33 * step, shift));
    CAPTURE(step, note_of(turned));
    REQUIRE(turned.shared.size() == 1);
    const std::vector<ForceRange>& expected = straight.shared[0].forces;
    const std::vector<ForceRange>& found = turned.shared[0].forces;
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(found[k].row == expected[k].row);
      CHECK(found[k].low == Approx(expected[k].low).epsilon(1e-9).margin(1e-10));
      CHECK(found[k].high == Approx(expected[k].high).epsilon(1e-9).margin(1e-10));
    }
  }
}

TEST_CASE("one wall, or walls without friction, determine all forces", "[scene][friction]") {
  CHECK(note_of(solve(corner(0, 0))).empty());
  Scene one = corner(0.3, 0);
  one.contacts.pop_back();
  one.bodies[0].supports = {symmetric("left")};
  CHECK(note_of(solve(one)).empty());
}

// Three points of one edge carry P as two nodes do: the outer ones alike, the middle one what is left.
TEST_CASE("three Gauss points on two nodes share the force of an edge", "[scene][closed-form]") {
  Scene scene = two_blocks(named_block("lower", {0, -1}, {2, 1}, 1, 1),
                           named_block("upper", {0, 0}, {2, 1}, 1, 1));
  scene.bodies[1].supports = {symmetric("left")};
  scene.bodies[1].loads.edges = {{"top", 3, {}}};
  scene.contacts[0].gap_operator = "gauss_points";
  scene.contacts[0].points = 3;
  const Solution solution = solve(scene);
  REQUIRE(solution.shared.size() == 1);
  const std::vector<ForceRange>& forces = solution.shared[0].forces;
  REQUIRE(forces.size() == 3);
  for (const ForceRange& range : forces) {
    CHECK(range.low == Approx(0).margin(1e-13));
    CHECK(range.high == Approx(range.row == 1 ? 6 : 3).epsilon(1e-12));
  }
  CHECK_THAT(note_of(solution), ContainsSubstring("more points than nodes") &&
                                    ContainsSubstring("pairs 0 to 2 together push body 'lower' "
                                                      "with (0, -6)"));
  scene.contacts[0].points = 2;
  CHECK(note_of(solve(scene)).empty());
}

TEST_CASE("the sum of many points is told where not all ranges are looked for", "[scene]") {
  Scene scene = two_blocks(named_block("lower", {0, -1}, {100, 1}, 50, 2),
                           named_block("upper", {0, 0}, {100, 1}, 50, 2));
  scene.bodies[1].supports = {symmetric("left")};
  scene.bodies[1].loads.edges = {{"top", 3, {}}};
  scene.contacts[0].friction = Friction{0.3, 0};
  scene.contacts[0].gap_operator = "gauss_points";
  scene.contacts[0].points = 3;
  const Solution solution = solve(scene);
  REQUIRE(solution.shared.size() == 1);
  CHECK(std::isinf(solution.shared[0].width()));
  CHECK_THAT(note_of(solution), ContainsSubstring("airs 0 to 149 together push body 'lower' with"));
}
