// Springs between a body and the ground, against closed forms and against supports.

#include "catch_compat.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/checked_scene.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::cantilever;
using signorini_test::check_scene;
using signorini_test::problem_message;

namespace {

/// A block 4 x 2 without supports, 0.5 thick.
Scene loose_block(const std::string& element, double unit = 1) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, unit * Vector2d(4, 2), 4, 3,
                    element == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear);
  body.element = element;
  body.material = {1000, 0, PlaneState::Stress, 0.5};
  return scene;
}

double largest_difference(const Solution& a, const Solution& b) {
  return (a.displacements[0] - b.displacements[0]).cwiseAbs().maxCoeff() /
         b.displacements[0].cwiseAbs().maxCoeff();
}

}  // namespace

// Pressed by 3 on springs of 20: down by 3/20 at the bottom and by 3 * 2 / 1000 more at the top.
TEST_CASE("a block on springs alone comes down as their stiffness says", "[springs]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible", "q8"}) {
    CAPTURE(element);
    Scene scene = loose_block(element);
    scene.bodies[0].springs = {{"bottom", {20, 20}}};
    scene.bodies[0].loads.edges = {{"top", 3, {}}};
    const auto [model, condensed, solution] = solved(scene, "the block");
    const Mesh& mesh = model.bodies[0].mesh;
    for (Index node = 0; node < mesh.n_nodes(); ++node) {
      const double down = 3.0 / 20 + 3 * mesh.nodes(node, 1) / 1000;
      CHECK(solution.displacements[0](node, 0) == Approx(0).margin(1e-12));
      CHECK(solution.displacements[0](node, 1) == Approx(-down).epsilon(1e-12));
    }
    const NodeArray springs = spring_forces(model, solution);
    CHECK(springs.col(1).sum() == Approx(3 * 4 * 0.5).epsilon(1e-12));
    CHECK(support_forces(model, solution).cwiseAbs().maxCoeff() <= 1e-10);
    CHECK(check_scene(model, solution).worst() <= 1e-12);
  }
}

// Two springs in a row: the body, E t h / l = 250, and the springs, 20 t h.
TEST_CASE("a support moved against springs shares its way with them", "[springs]") {
  Scene scene = loose_block("q4_incompatible");
  scene.bodies[0].supports = {prescribed("left", Axis::X, 0.3), symmetric("bottom")};
  scene.bodies[0].springs = {{"right", {20, 0}}};
  const auto [model, condensed, solution] = solved(scene, "the block");
  const double pressure = 0.3 / (1 / 20.0 + 4 / 1000.0);
  CHECK(spring_forces(model, solution).col(0).sum() == Approx(-pressure).epsilon(1e-12));
  CHECK(support_forces(model, solution).col(0).sum() == Approx(pressure).epsilon(1e-12));
}

TEST_CASE("springs on a support that moves push back on the support", "[springs]") {
  Scene scene = loose_block("q4");
  scene.bodies[0].supports = {prescribed("left", Axis::X, 0.3), prescribed("left", Axis::Y, 0)};
  scene.bodies[0].springs = {{"left", {20, 0}}};
  const auto [model, condensed, solution] = solved(scene, "the block");
  CHECK(spring_forces(model, solution).col(0).sum() == Approx(-20 * 0.3).epsilon(1e-12));
  CHECK(support_forces(model, solution).col(0).sum() == Approx(20 * 0.3).epsilon(1e-12));
}

// The corner is held and its neighbour is not: what springs between them feel of the given displacement is a load.
TEST_CASE("springs beside a support that moves leave no force where nothing holds", "[springs]") {
  for (const char* element : {"q4_incompatible", "q8"}) {
    Scene scene = loose_block(element);
    scene.bodies[0].supports = {prescribed("left", Axis::X, 0.3), prescribed("left", Axis::Y, 0.2)};
    scene.bodies[0].springs = {{"bottom", {200, 300}}};
    const auto [model, condensed, solution] = solved(scene, "the block");
    const BodyModel& body = model.bodies[0];
    const NodeArray springs = spring_forces(model, solution);
    NodeArray support = support_forces(model, solution);
    const double size = springs.cwiseAbs().maxCoeff();
    CHECK((springs + support).colwise().sum().norm() <= 1e-11 * size);
    for (const Index node : boundary_nodes(body.mesh, "left")) support.row(node).setZero();
    CHECK(support.cwiseAbs().maxCoeff() <= 1e-11 * size);
  }
}

TEST_CASE("springs that hardly give are a support", "[springs]") {
  for (const double stiffness : {1e12, 1e15}) {
    Scene held = cantilever("q4_incompatible", 40, 4);
    Scene sprung = held;
    sprung.bodies[0].supports.clear();
    sprung.bodies[0].springs = {
        {"left", stiffness * held.bodies[0].material.youngs_modulus * Vector2d(1, 1)}};
    const SolvedScene one = solved(held, "the beam");
    const SolvedScene two = solved(sprung, "the beam on springs");
    CHECK(largest_difference(two.solution, one.solution) <= 1e-9);
    const Eigen::VectorXd& force = one.solution.contact.force;  // the clamped corner has no pair
    CHECK((two.solution.contact.force.tail(40) - force).norm() <= 1e-9 * force.norm());
    CHECK(two.solution.contact.force(0) == 0);
    CHECK(two.solution.certificate.holds(1e-12));
    const NodeArray clamp = support_forces(one.model, one.solution);
    CHECK((spring_forces(two.model, two.solution) - clamp).norm() <= 1e-9 * clamp.norm());
  }
}

TEST_CASE("springs without stiffness are none", "[springs]") {
  const Scene none = cantilever("q4_incompatible", 20, 2);
  Scene zero = none;
  zero.bodies[0].springs = {{"right", {0, 0}}, {"right", {0, 0}, Vector2d(50, 5)}};
  CHECK(plan(zero).on == plan(none).on);
  CHECK(plan(zero).off == plan(none).off);
  const SolvedScene one = solved(none, "the beam");
  const SolvedScene two = solved(zero, "the beam");
  CHECK(one.solution.displacements[0] == two.solution.displacements[0]);
  CHECK(one.solution.contact.force == two.solution.contact.force);
  CHECK(support_forces(one.model, one.solution) == support_forces(two.model, two.solution));
  CHECK(spring_forces(two.model, two.solution).isZero(0));
}

// What is left of the forces of a rigid motion is rounding of the stiffness; springs must be stiffer than that. 20 rows of 18 entries,
// at most 4/3 (1000 * 1.5 + 500 / 1.5) / 2 = 1222 and so rounded by up to 1.1e-13, push by up to 4e-11 per length; springs of
// 20e-11 over an area of 2 push by 4e-10: a tenth if all roundings agree. They do not: 0.4 % at 1e-11, and ten times less with
// springs ten times as stiff.
TEST_CASE("springs too soft for the digits of a body that they alone hold are noted", "[springs]") {
  const auto down = [](double softness) {
    Scene scene = loose_block("q4");
    scene.bodies[0].springs = {{"bottom", softness * Eigen::Vector2d(20, 20)}};
    scene.bodies[0].loads.edges = {{"top", softness * 3, {}}};
    const Solution solution = solved(scene, "the block").solution;
    const bool noted = std::any_of(
        solution.notes.begin(), solution.notes.end(),
        [](const std::string& note) { return note.find("so soft") != std::string::npos; });
    return std::pair(-solution.displacements[0](0, 1), noted);
  };
  const auto [stiff, silent] = down(1);
  CHECK(stiff == Approx(3.0 / 20).epsilon(1e-12));
  CHECK_FALSE(silent);
  const auto [soft, noted] = down(1e-11);
  CHECK(noted);
  CHECK(soft == Approx(3.0 / 20).epsilon(0.1));
}

// Whatever the units: a spring as soft as can be stops what it resists and nothing else.
TEST_CASE("rigid motions that springs stop are none, the others stay", "[springs]") {
  const auto modes = [](const Spring& spring, double unit) {
    Scene scene = loose_block("q4", unit);
    scene.bodies[0].springs = {spring};
    scene.bodies[0].mesh = moved(scene.bodies[0].mesh, unit * Vector2d(300, -20));
    scene.contacts = {{{"bottom"}, half_plane(unit * Vector2d(0, -20), {0, 1})},
                      {{"left"}, half_plane(unit * Vector2d(300, 0), {1, 0})}};
    return plan(scene).modes;
  };
  for (const double unit : {1e-6, 1.0, 1e6})
    for (const double k : {1e-200, 1e-9, 1.0, 1e9, 1e200}) {
      CAPTURE(unit, k);
      CHECK(modes({"top", {0, 0}}, unit).size() == 3);
      CHECK(modes({"top", {k, 0}}, unit).size() == 2);  // up, and about a point of the top
      CHECK(modes({"top", {0, k}}, unit).size() == 1);
      CHECK(modes({"top", {k, k}}, unit).empty());
      const std::vector<FreeMotion> turns = modes({"top", {k, k}, unit * Vector2d(304, -18)}, unit);
      REQUIRE(turns.size() == 1);
      CHECK_THAT(in_words(turns[0]), ContainsSubstring("turn freely about"));
      CHECK(turns[0].shape.size() - turns[0].shape.nonZeros() >= 2);  // the node of the spring stands still
    }
}

TEST_CASE("a body that contact and springs hold together is solved", "[springs]") {
  for (const double unit : {1e-4, 1.0, 1e5}) {
    Scene scene = loose_block("q4_incompatible", unit);
    scene.bodies[0].springs = {{"right", {40 / unit, 0}}};
    scene.bodies[0].loads.edges = {{"top", 3, {}}};
    scene.bodies[0].loads.points = {{{0, 2 * unit}, {unit, 0}}};
    scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
    const auto [model, condensed, solution] = solved(scene, "the block");
    CHECK(model.modes.size() == 1);
    CHECK(check_scene(model, solution).worst() <= 1e-12);
    CHECK(spring_forces(model, solution).col(0).sum() == Approx(-unit).epsilon(1e-12));
    CHECK(solution.contact.force.sum() == Approx(3 * 4 * 0.5 * unit).epsilon(1e-12));
    CHECK(support_forces(model, solution).cwiseAbs().maxCoeff() <= 1e-11 * unit);
  }
}

TEST_CASE("springs that do not hold a body are not enough", "[springs]") {
  Scene scene = loose_block("q4");
  scene.bodies[0].springs = {{"bottom", {0, 20}}};
  CHECK_THAT(
      problem_message([&] { static_cast<void>(plan(scene)); }),
      ContainsSubstring("can move freely in direction x") && ContainsSubstring("add a support"));
  scene.bodies[0].springs = {{"bottom", {0, -20}}};
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(scene)); }),
             ContainsSubstring("springs at 'bottom' of 'block'"));
}
