// What chords cut off round bodies: the estimate of it, and answers that have it.
#include <cmath>

#include "addons/estimate/accuracy.hpp"
#include "addons/estimate/goal_words.hpp"
#include "addons/estimate/mesh_refinement.hpp"
#include "addons/prediction/prediction.hpp"
#include "addons/steps/steps_limit.hpp"
#include "catch_compat.hpp"
#include "meshes/half_space.hpp"
#include "support/lining_rings.hpp"
#include "support/round_bodies.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

struct Answer {
  Estimate estimate;
  double corrected;
};

Answer answer(const Scene& scene, const Goal& goal) {
  const SolvedScene run = solved(scene, goal.name);
  Ledger unused;
  Estimate one = estimate(run.model, run.condensed, run.solution, goal, unused);
  const double corrected = one.value + one.error;
  return {std::move(one), corrected};
}

/// A ring in a ring of other cells, with so many sides on the quarters that face each other, and its answers in closed form.
Scene two_rings(Eigen::Index inside, Eigen::Index outside, double clearance, double pressure) {
  Scene scene = lining_rings(inside, 8);
  for (std::size_t b = 0; b < 2; ++b) {
    AnnulusSpec spec;
    spec.name = b == 0 ? "lining" : "rock";
    spec.inner_radius = b == 0 ? 40 : 68 + clearance;
    spec.outer_radius = b == 0 ? 68 : 100;
    spec.cells_angle = b == 0 ? inside : outside;
    spec.cells_radius = 16;
    spec.sector = Sector::Quarter;
    scene.bodies[b].mesh = make_annulus(spec);
  }
  scene.bodies[0].loads.edges = {{"inner", pressure, {}}};
  return scene;
}

/// Hertz's ball on an obstacle, or on a block of its own material.
Scene ball_on(bool meshed, const std::string& element, PointContact& theory) {
  Scene scene = round_bodies::balls().front().scene(element, 1);
  theory = {50, round_bodies::modulus / (1 - 0.09), 0};
  if (meshed) theory.modulus /= 2;
  theory.force = 4 * theory.modulus * 0.125 / 150;  // of the half-width 0.5
  scene.bodies[0].loads.edges = {{"middle", theory.force / (round_bodies::pi * 2500), {}}};
  if (!meshed) return scene;
  HalfSpaceSpec spec;
  spec.name = "plate";
  spec.width = spec.depth = 50;
  spec.core = {2, 2};
  spec.core_columns = spec.core_rows = 7;
  spec.layers = 6;
  const Element& cell = find_element(element);
  spec.order = order_of(cell);
  Body plate = scene.bodies[0];
  plate.mesh = fitting(make_half_space(spec), cell);
  plate.supports = {fixed("base")};
  plate.loads = {};
  scene.bodies.push_back(plate);
  scene.contacts = {{{"rim", scene.bodies[0].mesh.name}, Side{"surface", "plate"}}};
  return scene;
}

}  // namespace

TEST_CASE("the answers of round bodies have what their chords cut off", "[outline][closed-form]") {
  for (const RoundBody& body : all_round_bodies()) {
    if (!body.truth || std::holds_alternative<PeakPressure>(body.goal.quantity) ||
        std::holds_alternative<HalfWidth>(body.goal.quantity))
      continue;
    CAPTURE(body.name, body.goal.name);
    const Answer one = answer(body.scene("q4_incompatible", 4), body.goal);
    const double truth = *body.truth;
    CHECK(std::abs(one.estimate.parts.outline) > 2e-4 * std::abs(truth));
    CHECK(one.corrected == Approx(truth).epsilon(1e-3).margin(0));
    CHECK(std::abs(one.estimate.value - truth) > 4 * std::abs(one.corrected - truth));
  }
}

TEST_CASE("the weight of a body is that of its slivers too", "[outline][closed-form]") {
  // A rigid motion tells how much a load counts: nothing but the outline is missing.
  for (const RoundBody& body : round_bodies::weights()) {
    if (!body.truth) continue;
    CAPTURE(body.name);
    double before = 1;
    for (const Eigen::Index times : {2, 4, 8}) {
      const Answer one = answer(body.scene("q4", times), body.goal);
      const double left = std::abs(one.corrected / *body.truth - 1);
      CHECK(left < before / 7);  // of the third order at least
      CHECK(left < 0.02 * std::abs(one.estimate.value / *body.truth - 1));
      before = left;
    }
  }
}

TEST_CASE("sides that do not meet end to end leave gaps that are known", "[outline][closed-form]") {
  const double modulus = plane_strain_modulus(210e3, 0.3), ratio = plane_strain_ratio(0.3);
  for (const double clearance : {0.0, 1.5})
    for (const auto& [inside, outside] : {std::pair{12, 24}, {12, 17}, {24, 35}}) {
      CAPTURE(clearance, inside, outside);
      const double pressure = clearance > 0 ? 18000 : 1800;
      const NestedRings rings{
          {40, 68, modulus, ratio}, {68 + clearance, 100, modulus, ratio}, pressure};
      const double truth = nested_pressure(rings).inner.outside * 68 * round_bodies::pi / 2;
      const Answer one =
          answer(two_rings(inside, outside, clearance, pressure), {"normal_force", NormalForce{}});
      CHECK(truth - one.estimate.value > 2e-3 * truth);
      CHECK(one.estimate.error / (truth - one.estimate.value) == Approx(1).margin(0.05));
    }
}

TEST_CASE("a straight outline cuts off nothing", "[outline]") {
  Scene scene = lining_rings(4, 2);
  scene.bodies.resize(1);
  BlockSpec spec;
  spec.cells_x = spec.cells_y = 4;
  scene.bodies[0].mesh = make_block(spec);
  scene.bodies[0].supports = {symmetric("left"), symmetric("bottom")};
  scene.bodies[0].loads.edges = {{"right", 2, {}}};
  scene.contacts.clear();
  const Answer one = answer(scene, {"top", Displacement{"", Axis::Y, "top", {}}});
  CHECK(one.estimate.parts.outline == 0);
  CHECK(one.estimate.of_sides.front().empty());
}

TEST_CASE("round bodies under load become as accurate as asked for", "[accuracy][outline]") {
  const std::string element = GENERATE("q4_incompatible", "t3", "q8");
  for (const RoundBody& body : all_round_bodies()) {
    CAPTURE(element, body.name, body.goal.name);
    const AccurateSolution result = solve_to_accuracy(body.scene(element, 1), {0.01, body.goal});
    INFO(result.verdict);
    CHECK(result.met);
    CHECK(result.rounds.back().value == Approx(truth_of(body, 4)).epsilon(0.01).margin(0));
  }
}

TEST_CASE("peak and width of a contact around the axis are those of Hertz's ball",
          "[goal][axial][closed-form]") {
  const bool meshed = GENERATE(false, true);
  const std::string element = GENERATE("t3", "q4_incompatible", "t6", "q8");
  const std::string goal = GENERATE("peak", "width");
  CAPTURE(meshed, element, goal);
  PointContact theory{};
  const Scene scene = ball_on(meshed, element, theory);
  const AccurateSolution result =
      solve_to_accuracy(scene, {0.01, goal_in_words(goal, plan(scene))});
  INFO(result.verdict);
  REQUIRE(result.met);
  const double truth = goal == "peak" ? hertz_peak_pressure(theory) : hertz_radius(theory);
  CHECK(result.rounds.back().value == Approx(truth).epsilon(0.01).margin(0));
}

TEST_CASE("a mesh that takes longer than allowed is asked about before", "[accuracy][price]") {
  const RoundBody body = round_bodies::rings().front();
  Accuracy wanted{1e-4, body.goal};
  wanted.most_seconds = 1e-9;
  int asked = 0;
  int solved_there = 0;
  if (GENERATE(false, true)) {
    wanted.forecast = [&asked](const Scene& scene) {
      ++asked;
      return predict(plan(scene)).amount(all_phases, "seconds");
    };
    wanted.solve = [&solved_there](const Scene& scene, const Model& model,
                                   const Condensed& condensed, Ledger ledger) {
      ++solved_there;
      return solve_to_limit(scene, model, condensed, std::move(ledger));
    };
  }
  const AccurateSolution result = solve_to_accuracy(body.scene("q4", 1), wanted);
  CHECK_FALSE(result.met);
  CHECK(result.rounds.size() == 1);
  CHECK(asked == (wanted.forecast ? 2 : 0));  // of the next mesh and of the last
  CHECK(solved_there == (wanted.solve ? 1 : 0));
  CHECK(result.too_dear > result.rounds.back().unknowns);
  CHECK_THAT(result.verdict, ContainsSubstring("price") && ContainsSubstring("forecast") &&
                                 ContainsSubstring(std::to_string(result.too_dear)));
  CHECK(result.solution.contact.report.status == SolveStatus::Solved);
  wanted.target = 0.01;
  wanted.most_seconds = 3600;
  CHECK(solve_to_accuracy(body.scene("q4", 1), wanted).too_dear == 0);
}
