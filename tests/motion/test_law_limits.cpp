// Where laws of finite strain end: closed forms of a block that is pressed or drawn between walls.
#include "addons/motion/law_limits.hpp"

#include <algorithm>
#include <cmath>

#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "support/message.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

struct Drawn {
  const char* law;
  double poisson_ratio;
  const char* element = "q4";
  PlaneState state = PlaneState::Strain;
};

Scene block_of(const Drawn& of) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {1, 1}, 2, 2);
  body.element = of.element;
  body.material = {1, of.poisson_ratio, of.state, 1};
  body.material.law = find_strain_law(of.law);
  body.supports = {fixed("bottom")};
  scene.path = Path{{1}, {}};
  return scene;
}

/// What is noted of a block whose height becomes a multiple of what it was, between walls that hold its sides.
std::vector<std::string> notes_at(const Drawn& of, double stretch) {
  Ledger ledger;
  const Model model = build(block_of(of), ledger);
  Solution solution;
  const NodeArray& nodes = model.bodies[0].mesh.nodes;
  solution.displacements = {NodeArray::Zero(nodes.rows(), 2)};
  solution.displacements[0].col(1) = (stretch - 1) * nodes.col(1);
  return notes_on_laws(model, solution);
}

/// The stretch at which a law of St Venant and Kirchhoff stops to be strongly elliptic, pressed between walls.
double limit_of_pressing(double nu) {
  const double lambda = nu / ((1 + nu) * (1 - 2 * nu));
  const double mu = 1 / (2 * (1 + nu));
  const auto least = [&](double s) {
    const double k = 1 - s * s;
    const double a = -lambda * k / 2;
    const double b = -mu * k;
    const double A = mu * k * k * (lambda + 2 * mu);
    const double B = b * (2 * a + mu * (1 + s * s)) + (lambda + mu) * (b - a * k);
    const double C = (a + mu * s * s) * (a + lambda + 2 * mu);
    const double y = std::min(1.0, std::max(0.0, -B / (2 * A)));
    return A * y * y + B * y + C;
  };
  double below = 0.3;
  double above = 0.999;
  for (int k = 0; k < 60; ++k) {
    const double middle = (below + above) / 2;
    (least(middle) < 0 ? below : above) = middle;
  }
  return above;
}

}  // namespace

// The determinant of Q is of second order in y, the square of the part of n along the press: its least over y is nothing at the limit. Without
// lateral strain that is 2 - sqrt(2).
TEST_CASE("pressed between walls St Venant and Kirchhoff's law loses its ellipticity where the closed form says",
          "[motion]") {
  CHECK(std::abs(limit_of_pressing(0) - (2 - std::sqrt(2.0))) <= 1e-12);
  for (const char* element : {"q4", "q4_bbar"})
    for (const double nu : {0.0, 0.2, 0.3, 0.32, 0.45}) {
      CAPTURE(element, nu);
      const double limit = limit_of_pressing(nu);
      CHECK(notes_at({"st_venant_kirchhoff", nu, element}, 1.005 * limit).empty());
      const std::vector<std::string> beyond =
          notes_at({"st_venant_kirchhoff", nu, element}, 0.995 * limit);
      REQUIRE(beyond.size() == 1);
      CHECK_THAT(beyond[0], ContainsSubstring("body 'block'") && ContainsSubstring("in 4 cells") &&
                                ContainsSubstring("ellipticity"));
      CHECK(notes_at({"neo_hooke", nu, element}, 0.2).empty());
    }
}

// Across a sheet F^2 = 1 - nu (s^2 - 1)/(1 - nu), which is nothing at s^2 = 1/nu.
TEST_CASE("a sheet of St Venant and Kirchhoff's law is refused where no thickness is left", "[motion]") {
  for (const double nu : {0.2, 0.3, 0.45}) {
    CAPTURE(nu);
    const Drawn sheet{"st_venant_kirchhoff", nu, "q4", PlaneState::Stress};
    CHECK_NOTHROW(notes_at(sheet, 0.99 / std::sqrt(nu)));
    CHECK_THAT(problem_message([&] { static_cast<void>(notes_at(sheet, 1.01 / std::sqrt(nu))); }),
               ContainsSubstring("of 'block'") && ContainsSubstring("no strain across"));
  }
}

TEST_CASE("a solved step tells where its law has ended", "[motion]") {
  Scene scene = block_of({"st_venant_kirchhoff", 0.0});
  scene.bodies[0].supports = {symmetric("bottom"), symmetric("left"),
                              prescribed("top", Axis::Y, -0.43)};
  scene.bodies[0].supports[2].history = "press";
  std::vector<double> noted;
  scene.path = Path{equal_steps(43), {proportional("press")}};
  const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
    for (const std::string& note : step.solution.notes)
      if (note.find("strong ellipticity") != std::string::npos) noted.push_back(step.state.time);
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  REQUIRE(noted.size() == 2);  // 0.58 and 0.57 are below 0.586, and 0.59 is not
  CHECK(noted[1] == 1);
}

TEST_CASE("a cell that inverts is named, after steps that were halved", "[motion]") {
  Scene scene = block_of({"neo_hooke", 0.3});
  scene.bodies[0].supports = {fixed("bottom"), prescribed("top", Axis::Y, -1.2)};
  scene.bodies[0].supports[1].history = "press";
  scene.path = Path{equal_steps(4), {proportional("press")}};
  scene.path->halvings = 3;
  const PathEnd end = solve_steps(scene);
  CHECK(end.status != SolveStatus::Solved);
  CHECK(end.halvings > 0);
  CHECK(end.state.time > 0.5);
  CHECK_THAT(end.reason, ContainsSubstring("cell ") && ContainsSubstring("of 'block'") &&
                             ContainsSubstring("inverts") &&
                             ContainsSubstring("the last good state is that of time"));
}

// A bar gives way at 0.385/2 of its modulus; the load goes on.
TEST_CASE("a tangent that stays indefinite is named with its body, its law and its strain", "[motion]") {
  Scene scene = block_of({"st_venant_kirchhoff", 0.0});
  scene.bodies[0].supports = {symmetric("bottom"), symmetric("left")};
  scene.bodies[0].loads.edges = {{"top", 0.25, {}, "press"}};
  scene.path = Path{equal_steps(5), {proportional("press")}};
  scene.path->halvings = 4;
  const PathEnd end = solve_steps(scene);
  CHECK(end.status != SolveStatus::Solved);
  CHECK(end.state.time > 0.7);
  CHECK(end.state.time < 0.1925 / 0.25);
  CHECK_THAT(end.reason, ContainsSubstring("the last good state is that of time"));
  CHECK_THAT(end.reason, ContainsSubstring("lost its stability") && ContainsSubstring("'block' (st_venant_kirchhoff) is 0."));
}

// Held at both ends, a column of height L and width h buckles at the strain pi^2 h^2 / (3 L^2), which shear of its sections
// lowers by some 3 % here: 0.164 of 20, or a little less.
TEST_CASE("a column above Euler's load stands straight and is noted", "[motion][closed-form]") {
  for (const double press : {0.15, 0.17}) {
    CAPTURE(press);
    Scene scene;
    Body& column = scene.bodies[0];
    column.mesh = block("column", {0, 0}, {1, 20}, 2, 40, MeshOrder::Quadratic);
    column.element = "q8";
    column.material = {1000, 0.3, PlaneState::Strain, 1};
    column.material.law = find_strain_law("st_venant_kirchhoff");
    column.supports = {fixed("bottom"), prescribed("top", Axis::X, 0),
                       prescribed("top", Axis::Y, -press)};
    column.supports[2].history = "press";
    scene.path = Path{{1}, {proportional("press")}};
    std::vector<std::string> notes;
    Eigen::Index springs = 0;
    const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
      notes = step.solution.notes;
      for (const LedgerEntry& entry : step.solution.ledger.entries())
        for (const auto& [what, count] : entry.counts)
          if (what == "held by springs") springs += Eigen::Index(count);
    });
    REQUIRE(end.status == SolveStatus::Solved);
    CHECK((springs > 0) == (press > 0.16));  // the ledger says so
    const bool unstable = std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.find("the equilibrium is unstable") == 0 && note.find("'column'") != std::string::npos;
    });
    CHECK(unstable == (press > 0.16));
  }
}

// A step without a new load begins where it ends, with a tangent that does not know yet which pairs press.
TEST_CASE("rubber that is held under a plate is not said to be unstable", "[motion]") {
  Scene scene = block_of({"neo_hooke", 0.45});
  scene.bodies.resize(2);
  Body& plate = scene.bodies[1];
  plate.mesh = block("plate", {-0.5, 1}, {2, 0.5}, 4, 1);
  plate.material = {1000, 0.3, PlaneState::Strain, 1};
  plate.supports = {prescribed("top", Axis::X, 0), prescribed("top", Axis::Y, -0.4)};
  plate.supports[1].history = "press";
  scene.contacts = {{{"top", "block"}, Side{"bottom", "plate"}}};
  scene.contacts[0].friction = Friction{1, 0};
  scene.path = Path{{0.5, 1, 2, 3}, {{"press", {0, 1, 3}, {0, 1, 1}}}};
  int steps = 0;
  const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
    ++steps;
    CHECK(!step.solution.contact.active().empty());
    for (const std::string& note : step.solution.notes) CHECK(note.find("unstable") == std::string::npos);
  });
  INFO(end.reason);
  CHECK(end.status == SolveStatus::Solved);
  CHECK(steps == 4);
}
