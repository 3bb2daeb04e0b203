// How two sides fit before anything moves: adjusted gaps, interference, and friction that ties.
#include <algorithm>
#include <limits>

#include "catch_compat.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Two blocks of equal cells on each other, the lower one held, the upper one pressed and dragged.
Scene stacked_blocks(const std::string& element, double gap) {
  BlockSpec spec;
  spec.size = {4, 1};
  spec.cells_x = 8;
  spec.cells_y = 2;
  spec.order = element == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear;
  Scene scene;
  scene.bodies.resize(2);
  spec.name = "lower";
  scene.bodies[0].mesh = make_block(spec);
  spec.name = "upper";
  spec.corner = {0, 1 + gap};
  scene.bodies[1].mesh = make_block(spec);
  for (Body& body : scene.bodies) {
    body.element = element;
    body.material = {1000, 0.3, PlaneState::Strain, 1};
  }
  scene.bodies[0].supports = {fixed("bottom")};
  scene.bodies[1].loads.edges = {{"top", 5, [](const Vector2d& x) -> Vector2d {
                                    return {0.5 + 0.1 * x.x(), 0};
                                  }}};
  scene.contacts = {{{"bottom", "upper"}, Side{"top", "lower"}}};
  return scene;
}

/// The same as one body.
Scene one_block(const std::string& element) {
  Scene scene = stacked_blocks(element, 0);
  Scene one = scene;
  one.bodies.resize(1);
  one.bodies[0].mesh = block("both", {0, 0}, {4, 2}, 8, 4,
                             element == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear);
  one.bodies[0].loads = scene.bodies[1].loads;
  one.contacts.clear();
  return one;
}

bool contains(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("an interference is an obstacle that stands so much closer", "[fit]") {
  Scene closer = cantilever("q4_incompatible", 20, 2);
  closer.bodies[0].supports = {fixed("top")};
  closer.contacts[0].target = half_plane({0, 0.25}, {0, 1});
  Scene pressed = closer;
  pressed.contacts[0].target = half_plane({0, 0}, {0, 1});
  pressed.contacts[0].interference = 0.25;
  const Solution one = solve(closer);
  const Solution two = solve(pressed);
  REQUIRE(two.contact.report.status == SolveStatus::Solved);
  CHECK(two.contact.force == one.contact.force);  // 0 - 0.25 is exact
  CHECK(two.displacements[0] == one.displacements[0]);
  const Plan planned = plan(pressed);
  CHECK(
      contains(planned.on,
               "interference of the contact of 'bottom' of 'beam' with a rigid half plane: 0.25"));
  CHECK(contains(planned.on, "all closer by 0.25"));
  CHECK(contains(planned.on, "initial overlap of 21 pairs"));
}

TEST_CASE("every operator: an interference lowers every gap by itself", "[fit]") {
  for (const GapOperator& member : gap_operators())
    for (const char* element : {"q4_incompatible", "q8"}) {
      CAPTURE(member.name, element);
      Scene scene = stacked_blocks(element, 0.125);
      scene.contacts[0].gap_operator = member.name;
      scene.bodies[1].supports = {symmetric("left")};
      const VectorXd bare = plan(scene).gaps.pairs.initial_gap;
      scene.contacts[0].interference = 0.5;
      CHECK((plan(scene).gaps.pairs.initial_gap - bare).isApproxToConstant(-0.5, 1e-15));
    }
}

TEST_CASE("an interference counts besides what supports move", "[fit]") {
  Scene scene = stacked_blocks("q4", 0);
  scene.bodies[1].supports = {prescribed("top", Axis::Y, -0.01), prescribed("top", Axis::X, 0)};
  scene.bodies[1].loads = {};
  const VectorXd bare = plan(scene).gaps.pairs.initial_gap;
  scene.contacts[0].interference = 0.002;
  scene.contacts[0].adjust =
      0.005;  // less than what the support moves, which is no fault of the mesh
  CHECK((plan(scene).gaps.pairs.initial_gap - bare).isApproxToConstant(-0.002, 1e-15));
}

// Overlaps and gaps up to 1e-5 of a mesh written with few digits: adjusted, they never were.
TEST_CASE("adjusted gaps are those of an exact mesh, larger ones stay", "[fit]") {
  Scene exact = cantilever("q4_incompatible", 20, 2);
  exact.contacts[0].target = half_plane({0, 0}, {0, 1});
  Scene rough = exact;
  Scene bumped = exact;
  for (const Index node : boundary_nodes(exact.bodies[0].mesh, "bottom")) {
    rough.bodies[0].mesh.nodes(node, 1) = 1e-5 * static_cast<double>((node + 1) % 3 - 1);
    bumped.bodies[0].mesh.nodes(node, 1) =
        node == 7 ? -3e-5 : 1e-5 * static_cast<double>((node + 1) % 3 - 1);
  }
  const VectorXd before = plan(rough).gaps.pairs.initial_gap;
  CHECK(before.minCoeff() < 0);
  rough.contacts[0].adjust = 1.5e-5;
  bumped.contacts[0].adjust = 1.5e-5;
  bumped.bodies[0].supports = {fixed("top")};
  const Plan planned = plan(rough);
  CHECK((planned.gaps.pairs.initial_gap.array() == 0).all());
  CHECK(contains(planned.on, "14 of them adjusted by up to 1e-05"));
  CHECK(contains(planned.on, "adjusted gaps of the contact of 'bottom'"));
  CHECK(contains(planned.off, "initial overlap"));
  rough.bodies[0].mesh.nodes(0, 1) = -1e-5;  // held, and a fault without the adjustment
  CHECK(contains(plan(rough).on, "15 of them"));
  rough.contacts[0].adjust.reset();
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(rough)); }),
             ContainsSubstring("is held by supports and overlaps by 1e-05"));
  const VectorXd left = plan(bumped).gaps.pairs.initial_gap;
  CHECK((left.array() != 0).count() == 1);
  CHECK(left.minCoeff() == -3e-5);
  bumped.contacts[0].interference = 1e-3;  // after the adjustment
  const VectorXd both = plan(bumped).gaps.pairs.initial_gap;
  CHECK((both.array() == -1e-3).count() == 20);
  CHECK(both.minCoeff() == Approx(-1.03e-3).epsilon(1e-14));
}

TEST_CASE("lengths of zero are none", "[fit]") {
  Scene none = stacked_blocks("q4_incompatible", -0.001);
  none.contacts[0].friction = Friction{0.3, 0};
  Scene zero = none;
  zero.contacts[0].interference = 0.0;
  zero.contacts[0].adjust = 0.0;
  CHECK(plan(zero).on == plan(none).on);
  CHECK(plan(zero).off == plan(none).off);
  const Solution one = solve(none);
  const Solution two = solve(zero);
  CHECK(one.contact.force == two.contact.force);
  CHECK(one.displacements[1] == two.displacements[1]);
}

TEST_CASE("lengths that cannot be are errors that name the contact", "[fit]") {
  const auto message = [](std::optional<double> interference, std::optional<double> adjust) {
    Scene scene = stacked_blocks("q4", 0);
    scene.contacts[0].interference = interference;
    scene.contacts[0].adjust = adjust;
    return problem_message([&] { static_cast<void>(plan(scene)); });
  };
  CHECK_THAT(message(-0.1, {}),
             ContainsSubstring("interference of the contact of 'bottom' of 'upper' with 'top' of "
                               "'lower' must be a length >= 0, got -0.1"));
  CHECK_THAT(message({}, -0.1), ContainsSubstring("adjusted gaps of the contact of 'bottom'"));
  CHECK_THAT(message(std::numeric_limits<double>::infinity(), {}),
             ContainsSubstring("must be a length >= 0"));
  CHECK_THAT(message({}, std::numeric_limits<double>::quiet_NaN()),
             ContainsSubstring("must be a length >= 0"));
}

// Equal cells, everything pressed and stuck: then contact joins the nodes, and two bodies are one.
TEST_CASE("bodies with friction that nothing overcomes are one body", "[fit][friction]") {
  for (const char* element : {"q4_incompatible", "q8"})
    for (const GapOperator& member : gap_operators()) {
      if (std::string(member.name) == "gauss_points") continue;
      CAPTURE(element, member.name);
      Scene scene = stacked_blocks(element, 0);
      scene.contacts[0].gap_operator = member.name;
      scene.contacts[0].friction = Friction{1e4, 0};
      const SolvedScene two = solved(scene, "the blocks");
      const SolvedScene one = solved(one_block(element), "the block");
      for (const ContactStatus contact_status : two.solution.contact.contact_status)
        CHECK(contact_status == ContactStatus::Stick);
      const NodeArray& whole = one.model.bodies[0].mesh.nodes;
      for (std::size_t b = 0; b < 2; ++b) {
        const NodeArray& x = two.model.bodies[b].mesh.nodes;
        double worst = 0;
        for (Index node = 0; node < x.rows(); ++node) {
          Index same = 0;
          (whole.rowwise() - x.row(node)).rowwise().squaredNorm().minCoeff(&same);
          worst = std::max(worst, (two.solution.displacements[b].row(node) -
                                   one.solution.displacements[0].row(same))
                                      .norm());
        }
        CHECK(worst <= 1e-9 * one.solution.displacements[0].cwiseAbs().maxCoeff());
      }
    }
}
