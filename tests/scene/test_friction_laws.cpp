// The laws of friction by name, and friction that cannot be meant.
#include <algorithm>

#include "catch_compat.hpp"
#include "signorini/contact/friction_laws.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/scene.hpp"
#include "support/message.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

/// A block pressed on the ground by 10 and dragged along by 2 at its top.
Scene dragged(Friction friction) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {4, 1}, 8, 2);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.loads.edges = {{"top", 10, [](const Eigen::Vector2d&) { return Eigen::Vector2d(2, 0); }}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = std::move(friction);
  return scene;
}

std::string complaint(const Scene& scene) {
  return problem_message([&] { static_cast<void>(plan(scene)); });
}

}  // namespace

TEST_CASE("every law is a line over the force that presses a pair", "[friction][laws]") {
  const double weight = 0.25;
  for (const FrictionLawMember& law : friction_laws()) {
    CAPTURE(law.name);
    Friction friction{0, 2, law.name};
    if (std::string(law.name) == "coulomb") friction.coefficient = 0.3;
    const FrictionBound bound = find_friction_law(law.name).bound(friction, weight);
    CHECK(bound.slope == friction.coefficient);
    CHECK(bound.offset == 2 * weight);
  }
  CHECK(Friction().law == "coulomb");
  CHECK_THROWS_WITH(find_friction_law("treska"), ContainsSubstring("did you mean 'tresca'"));
}

// A scene has both parts of the bound that a law gives, whichever of the two numbers is there.
TEST_CASE("a plan takes from every law the bound that the law has", "[friction][laws]") {
  for (const FrictionLawMember& law : friction_laws())
    for (const Friction& friction :
         {Friction{0.3, 0, law.name}, Friction{0, 2, law.name}, Friction{0.3, 2, law.name}}) {
      CAPTURE(law.name, friction.coefficient, friction.cohesion);
      const Scene scene = dragged(friction);
      const std::string refused =
          problem_message([&] { static_cast<void>(law.bound(friction, 1)); });
      CHECK_THAT(complaint(scene), ContainsSubstring(refused));
      if (!refused.empty()) continue;
      const Plan made = plan(scene);
      REQUIRE(made.law.pair.size() == 9);
      for (Eigen::Index k = 0; k < 9; ++k) {
        const double weight = made.gaps.pairs.weight(made.law.pair[static_cast<std::size_t>(k)]);
        const FrictionBound bound = law.bound(friction, weight);
        CHECK(made.law.coefficient(k) == bound.slope);
        CHECK(made.law.cohesion(k) == bound.offset);
      }
    }
  for (const FrictionLawMember& law : friction_laws()) {
    Scene bare = dragged({0, 0, law.name});
    bare.bodies[0].supports = {prescribed("left", Axis::X, 0)};
    CHECK(plan(bare).law.pair.empty());
  }
}

// Half of what Coulomb's law would hold: the shear bound is the same under all of the base, whatever presses.
TEST_CASE("Tresca's law in a scene: no coefficient, and the bound is the cohesion",
          "[friction][laws]") {
  const Solution tresca = solve(dragged({0, 2.5, "tresca"}));
  REQUIRE(tresca.contact.report.status == SolveStatus::Solved);
  const Solution coulomb = solve(dragged({0, 2.5}));
  CHECK(tresca.contact.friction == coulomb.contact.friction);
  CHECK(tresca.contact.contact_status == coulomb.contact.contact_status);
  Eigen::Index at_bound = 0;
  const Model model = [] {
    Ledger ledger;
    return build(dragged({0, 2.5, "tresca"}), ledger);
  }();
  for (Eigen::Index k = 0; k < tresca.contact.friction.size(); ++k) {
    const double bound = 2.5 * model.pairs.weight(model.law.pair[static_cast<std::size_t>(k)]);
    CHECK(std::abs(tresca.contact.friction(k)) <= bound * (1 + 1e-14));
    if (tresca.contact.contact_status[static_cast<std::size_t>(k)] == ContactStatus::SlipBackward ||
        tresca.contact.contact_status[static_cast<std::size_t>(k)] == ContactStatus::SlipForward)
      ++at_bound;
  }
  CHECK(at_bound > 0);
  const auto said = [](const Scene& scene) {
    const std::vector<std::string> on = plan(scene).on;
    return std::count_if(on.begin(), on.end(), [](const std::string& line) {
      return line.find(": 2.5, law 'tresca': ") != line.npos;
    });
  };
  CHECK(said(dragged({0, 2.5, "tresca"})) == 1);
  CHECK(said(dragged({0, 2.5})) == 0);
  CHECK(tresca.contact.friction.sum() == Approx(-8).epsilon(1e-12).margin(0));
}

TEST_CASE("friction that cannot be meant is refused with the way out", "[friction][laws][input]") {
  CHECK(complaint(dragged({0.3, 0})).empty());
  CHECK_THAT(complaint(dragged({0.3, 2, "tresca"})),
             ContainsSubstring("'bottom' of 'block'") &&
                 ContainsSubstring("no coefficient of friction, got 0.3") &&
                 ContainsSubstring("'coulomb'"));
  CHECK_THAT(
      complaint(dragged({0.3, 0, "stribeck"})),
      ContainsSubstring("unknown friction law 'stribeck'") && ContainsSubstring("coulomb, tresca"));
  CHECK_THAT(complaint(dragged({-0.3, 0})), ContainsSubstring(">= 0, got -0.3"));
  CHECK_THAT(complaint(dragged({0.3, -1})), ContainsSubstring(">= 0, got -1"));
  Scene needle = dragged({0.3, 0});
  needle.contacts[0].target = Obstacle{"needle", [](const Eigen::Vector2d& x) {
                                         return ObstacleContact{x.y(), Eigen::Vector2d::Zero()};
                                       }};
  CHECK_THAT(complaint(needle), ContainsSubstring("'needle'") && ContainsSubstring("normal") &&
                                    ContainsSubstring("must have length 1, got 0"));
}

TEST_CASE("friction along supports does nothing, and a note says so", "[friction][laws]") {
  for (const Friction& friction : {Friction{0.3, 0}, Friction{0, 1}, Friction{0.3, 1}}) {
    Scene scene = dragged(friction);
    CHECK(plan(scene).notes.empty());
    scene.bodies[0].supports = {prescribed("bottom", Axis::X, 0)};
    const std::vector<std::string> notes = plan(scene).notes;
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], ContainsSubstring("'bottom' of 'block'") &&
                             ContainsSubstring("friction does nothing"));
  }
}
