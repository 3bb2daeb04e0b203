// Numbers, names and places in what is said of a scene.
#include <algorithm>
#include <string>
#include <vector>

#include "addons/certified/end_words.hpp"
#include "catch_compat.hpp"
#include "support/loose_meshes.hpp"
#include "support/message.hpp"
#include "support/two_bodies.hpp"

using namespace signorini;
using Eigen::Index;
using signorini_test::named_block;
using signorini_test::two_blocks;

namespace {

bool any_says(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

/// A block 2 x 1 that stands on a floor, held sideways at its left.
Body stone(const std::string& name, double left) {
  Body body;
  body.mesh = named_block(name, {left, 0}, {2, 1}, 4, 2);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.supports = {symmetric("left")};
  return body;
}

}  // namespace

TEST_CASE("source nodes that face nothing are counted, and the first is the first", "[said]") {
  Scene scene = two_blocks(named_block("lower", {0, 0}, {2, 1}, 2, 1),
                           named_block("upper", {-1, 1}, {4, 1}, 4, 1));
  scene.bodies[1].supports = {prescribed_at("top", {-1, 2}, Axis::X)};
  CHECK(any_says(plan(scene).notes,
                 "2 source nodes face no target and are left out, the first is "
                 "node 0"));
}

TEST_CASE("a plan counts every displacement that supports give", "[said]") {
  Scene scene;
  scene.bodies = {stone("stone", 0)};
  scene.bodies[0].supports = {fixed("bottom"), symmetric("left")};
  CHECK(any_says(plan(scene).on, "supports of 'stone': 12 displacements given"));
}

TEST_CASE("cells that lock are noted in plane strain and around an axis, not in plane stress",
          "[said]") {
  Scene scene;
  scene.bodies = {stone("stone", 0)};
  Body& body = scene.bodies[0];
  body.supports = {fixed("bottom")};
  body.element = "q4";
  for (const PlaneState state : {PlaneState::Strain, PlaneState::Axial, PlaneState::Stress}) {
    body.material = {1000, 0.45, state, 1};
    CHECK(any_says(plan(scene).notes, "locks for Poisson's ratio 0.45") ==
          (state != PlaneState::Stress));
  }
}

TEST_CASE("a pair in doubt is called by the number of its node in its own body", "[said]") {
  Scene scene = two_blocks(named_block("lower", {0, 0}, {2, 1}, 3, 1),
                           named_block("upper", {0, 1}, {2, 1}, 4, 2));
  scene.contacts[0].friction = Friction{0.5};
  Ledger ledger;
  const Model model = build(scene, ledger);
  for (const Index pair : model.law.pair) {
    const Index node =
        model.pairs.node[static_cast<std::size_t>(pair)] - model.bodies[1].first_node;
    const auto x = model.bodies[1].mesh.nodes.row(node);
    const std::string words = uniqueness_warning_in_words(model, {pair, -0.25});
    CAPTURE(words);
    CHECK(words.find(text("pair ", pair, " of node ", node, " of body 'upper' at (", x.x(), ", ",
                          x.y(), ')')) != std::string::npos);
    CHECK(words.find("friction coefficient of 0.4 on; there it is 0.5") != std::string::npos);
  }
}

TEST_CASE("of two bodies only the one that flies off is said to", "[said]") {
  Scene scene;
  scene.bodies = {stone("resting", 0), stone("lifted", 5)};
  scene.bodies[0].loads.edges = {{"top", 1, {}}};
  scene.bodies[1].loads.edges = {{"bottom", 1, {}}};
  for (const char* name : {"resting", "lifted"})
    scene.contacts.push_back({{"bottom", name}, half_plane({0, 0}, {0, 1})});
  const Solution solution = solve(scene);
  REQUIRE(solution.contact.report.status != SolveStatus::Solved);
  CAPTURE(solution.unbounded_direction);
  CHECK(solution.unbounded_direction.find("'lifted'") != std::string::npos);
  CHECK(solution.unbounded_direction.find("'resting'") == std::string::npos);
}

TEST_CASE("where a body is no body is said of the node in its own body", "[said]") {
  // The second body is a block that a hinge alone holds to another, which stands; all of these nodes come behind.
  Scene scene;
  scene.bodies = {stone("other", -9), stone("hinged", 0)};
  scene.bodies[0].supports = {fixed("bottom")};
  Body& hinged = scene.bodies[1];
  hinged.mesh = signorini_test::merged(signorini_test::together(
      named_block("hinged", {1, 1}, {1, 1}, 2, 2), named_block("", {0, 0}, {1, 1}, 3, 3)));
  hinged.supports = {fixed("bottom2")};
  const std::string said =
      signorini_test::problem_message([&] { static_cast<void>(solve(scene)); });
  CAPTURE(said);
  const std::string head = "body 'hinged', node ";
  REQUIRE(said.find(head) != std::string::npos);
  const auto node = static_cast<Index>(std::stoi(said.substr(said.find(head) + head.size())));
  const auto x = hinged.mesh.nodes.row(node);
  CHECK(x.x() >= 1);
  CHECK(x.y() >= 1);
  CHECK(said.find(text("node ", node, " at (", x.x(), ", ", x.y(), ')')) != std::string::npos);
}
