// Scenes refined until a goal is as accurate as asked for.
#include <algorithm>
#include <cmath>
#include <limits>

#include "addons/estimate/accuracy.hpp"
#include "addons/estimate/goal_words.hpp"
#include "addons/estimate/mesh_refinement.hpp"
#include "catch_compat.hpp"
#include "closed_form/hertz.hpp"
#include "meshes/block.hpp"
#include "meshes/disc.hpp"
#include "meshes/split.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/hertz.hpp"
#include "support/lining_rings.hpp"
#include "support/message.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

/// Two bodies whose contact the first mesh hardly resolves.
HertzProblem coarse_hertz() {
  HertzProblem problem;
  problem.mesh.core = 5;
  problem.mesh.disc_cells = problem.mesh.plate_cells = 8;
  problem.mesh.disc_rows = problem.mesh.plate_rows = 6;
  problem.mesh.disc_layers = problem.mesh.plate_layers = 6;
  return problem;
}

/// A strip on a floor, held at its left end and pressed down; cells of four nodes.
Scene pressed_strip(Eigen::Index rows) {
  BlockSpec spec;
  spec.size = {4, 1};
  spec.cells_x = 8;
  spec.cells_y = rows;
  Scene scene;
  Body& block = scene.bodies.front();
  block.mesh = make_block(spec);
  block.material = {1000, 0.3, PlaneState::Strain, 1};
  block.supports = {fixed("left")};
  block.loads.edges = {{"top", 1, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

/// A thin strip of triangles above a floor, on rollers at its left end and held at the other: coarse ones are so stiff that
/// they do not reach the floor.
Scene thin_strip(Eigen::Index cells, double gap, double pressure, bool triangles) {
  BlockSpec spec;
  spec.size = {10, cells == 20 ? 0.1 : 0.5};
  spec.cells_x = cells;
  spec.cells_y = cells == 20 ? 1 : 2;
  Scene scene;
  Body& strip = scene.bodies.front();
  strip.mesh = triangles ? split(make_block(spec)) : make_block(spec);
  strip.element = triangles ? "t3" : "q4";
  strip.material = {1e5, 0.3, PlaneState::Strain, 1};
  strip.supports = {symmetric("left"), fixed("right")};
  strip.loads.edges = {{"top", pressure, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, -gap}, {0, 1})}};
  return scene;
}

AccurateSolution accurate(const Scene& scene, const std::string& goal, double target) {
  return solve_to_accuracy(scene, {target, goal_in_words(goal, plan(scene))});
}

}  // namespace

TEST_CASE("Hertz's contact becomes as accurate as asked for from a mesh that hardly has it",
          "[accuracy][closed-form]") {
  const double target = GENERATE(0.01, 0.003);
  const std::string goal = GENERATE("peak", "width");
  CAPTURE(target, goal);
  const HertzProblem problem = coarse_hertz();
  const AccurateSolution result = accurate(scene_of(problem), goal, target);
  REQUIRE(result.met);
  CHECK(result.verdict == "met");
  const double exact =
      goal == "peak" ? hertz_peak_pressure(problem.theory()) : hertz_half_width(problem.theory());
  const AccuracyRound& last = result.rounds.back();
  CHECK(std::abs(last.value - exact) < target * exact);
  CHECK(*last.error <= target * last.value);
  CHECK_FALSE(result.rounds.front().error.has_value());  // contact was not resolved
  CHECK(result.rounds[1].error.has_value());             // the next mesh resolves it
  CHECK(result.rounds.size() <= 8);
  for (std::size_t k = 1; k < result.rounds.size(); ++k)
    CHECK(result.rounds[k].unknowns > result.rounds[k - 1].unknowns);
}

TEST_CASE("one ring in another becomes as accurate as asked for", "[accuracy][closed-form]") {
  const double target = GENERATE(0.01, 0.003, 0.001);
  CAPTURE(target);
  const AccurateSolution result = accurate(lining_rings(9, 5), "normal_force", target);
  REQUIRE(result.met);
  CHECK(result.rounds.size() >= 2);  // a second mesh confirms
  CHECK(result.rounds.back().value == Approx(lining_force()).epsilon(target).margin(0));
}

TEST_CASE(
    "meshes are fine where it counts: of as many cells of one size the error is many times as "
    "large",
    "[accuracy][closed-form]") {
  const HertzProblem problem = coarse_hertz();
  const double exact = hertz_half_width(problem.theory());
  const AccurateSolution result = accurate(scene_of(problem), "width", 0.003);
  REQUIRE(result.met);
  Scene even = scene_of(problem);
  for (int k = 0; k < 2; ++k)
    for (Body& body : even.bodies) body.mesh = refined_mesh(body.mesh);
  const SolvedScene run = solved(even, "even");
  REQUIRE(run.model.unknowns.count > result.rounds.back().unknowns);
  const double uniform = value(run.model, run.solution, {"width", HalfWidth{}});
  CHECK(std::abs(uniform - exact) > 5 * std::abs(result.rounds.back().value - exact));
  // Each round costs several times the one before, so that all together are hardly more than the last.
  Eigen::Index all = 0;
  for (const AccuracyRound& round : result.rounds) all += round.unknowns;
  CHECK(all < 3 * result.rounds.back().unknowns);
}

TEST_CASE("a mesh that nearly meets the target is not followed by one twice as fine",
          "[accuracy]") {
  const AccurateSolution result =
      accurate(cantilever("q4_incompatible", 20, 3), "normal_force", 0.001);
  REQUIRE(result.met);
  REQUIRE(result.rounds.size() > 2);
  const AccuracyRound& before = result.rounds[result.rounds.size() - 2];
  CHECK(*before.error < 0.002 * std::abs(before.value));
  CHECK(result.rounds.back().unknowns < 2 * before.unknowns);
}

TEST_CASE("two meshes that hardly differ do not confirm each other", "[accuracy]") {
  // The floor reaches the corner where the block is held, of which coarse meshes know little.
  Scene scene = pressed_strip(3);
  scene.bodies[0].mesh = split(scene.bodies[0].mesh);
  scene.bodies[0].element = "t3";
  const double reference = accurate(scene, "normal_force", 1e-3).rounds.back().value;
  const double target = GENERATE(0.02, 0.01, 0.005);
  CAPTURE(target);
  const AccurateSolution result = accurate(scene, "normal_force", target);
  REQUIRE(result.met);
  CHECK(result.rounds.back().value == Approx(reference).epsilon(target).margin(0));
}

TEST_CASE("a mesh too stiff for contact to close confirms nothing", "[accuracy]") {
  const bool thin = GENERATE(true, false);
  const Scene scene = thin ? thin_strip(20, 0.5, 0.05, true) : thin_strip(10, 0.7, 8, true);
  const std::string goal = "displacement:top.y";
  const double reference = accurate(scene, goal, 0.01).rounds.back().value;
  const AccurateSolution result = accurate(scene, goal, 0.05);
  REQUIRE(result.met);
  REQUIRE(result.rounds.size() > 2);
  CHECK(std::any_of(result.rounds.begin(), result.rounds.end(), [](const AccuracyRound& round) {
    return !round.error.has_value();  // contact closed, and was not resolved
  }));
  CHECK(result.rounds[result.rounds.size() - 2].error.has_value());
  // As accurate as asked for; the reference is five times as accurate.
  CHECK(result.rounds.back().value == Approx(reference).epsilon(0.05).margin(0));
}

TEST_CASE("coarse meshes that are too stiff are no reason to give up", "[accuracy]") {
  // Nothing closes on the first mesh that is estimated; of triangles one pair does, however fine its sides are.
  const bool triangles = GENERATE(true, false);
  CAPTURE(triangles);
  const Scene scene = thin_strip(20, 0.5, 0.05, triangles);
  const AccurateSolution result = accurate(scene, "normal_force", 0.05);
  INFO(result.verdict);
  REQUIRE(result.met);
  Scene fine = thin_strip(20, 0.5, 0.05, false);
  BlockSpec spec;
  spec.size = {10, 0.1};
  spec.cells_x = 400;
  spec.cells_y = 8;
  fine.bodies[0].mesh = make_block(spec);
  fine.bodies[0].element = "q4_incompatible";
  const SolvedScene run = solved(fine, "fine");
  const double reference = value(run.model, run.solution, {"normal_force", NormalForce{}});
  // As accurate as asked for: cells half as long change the reference by .0001.
  CHECK(result.rounds.back().value == Approx(reference).epsilon(0.05).margin(0));
}

TEST_CASE("a width and a peak of a whole rim are read where it touches",
          "[accuracy][closed-form]") {
  const DiscPart part = GENERATE(DiscPart::Right, DiscPart::Full);
  const std::string goal = GENERATE("peak", "width");
  CAPTURE(part, goal);
  Scene scene;
  Body& disc = scene.bodies.front();
  DiscSpec spec;
  spec.centre = {0, 1};
  spec.part = part;
  disc.mesh = make_disc(spec);
  disc.element = "q4_incompatible";
  disc.material = {1000, 0.3, PlaneState::Strain, 1};
  if (part == DiscPart::Right)
    disc.supports = {symmetric("axis")};
  else
    disc.supports = {prescribed_at("rim", {0, 0}, Axis::X, 0),
                     prescribed_at("rim", {0, 2}, Axis::X, 0)};
  disc.loads.body_force = [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, -3); };
  scene.contacts = {{{"rim"}, half_plane({0, 0}, {0, 1})}};
  const AccurateSolution result = accurate(scene, goal, 0.01);
  INFO(result.verdict);
  REQUIRE(result.met);
  const LineContact theory{1, 1000 / (1 - 0.09), 3 * pi};
  const double exact = goal == "peak" ? hertz_peak_pressure(theory) : hertz_half_width(theory);
  // Hertz's bodies are half planes: a disc differs by less than the square of half-width over radius, 0.011. Asked for 0.2 % peaks
  // end 0.3 % above Hertz's and widths 0.4 % below; together with the 1 % that is asked for here that is less than 2 %.
  CHECK(result.rounds.back().value == Approx(exact).epsilon(0.02).margin(0));
}

TEST_CASE("triangles and quadratic cells are refined as well", "[accuracy][closed-form]") {
  HertzProblem problem = coarse_hertz();
  problem.element = GENERATE("t3", "t6", "q8", "q4_bbar");
  CAPTURE(problem.element);
  const AccurateSolution result = accurate(scene_of(problem), "peak", 0.02);
  REQUIRE(result.met);
  CHECK(result.rounds.back().value ==
        Approx(hertz_peak_pressure(problem.theory())).epsilon(0.02).margin(0));
}

TEST_CASE("neither units nor repetition change the meshes", "[accuracy][units]") {
  HertzProblem problem = coarse_hertz();
  const AccurateSolution first = accurate(scene_of(problem), "peak", 0.01);
  const AccurateSolution again = accurate(scene_of(problem), "peak", 0.01);
  CHECK(first.rounds.back().value == again.rounds.back().value);
  CHECK(first.scene.bodies[0].mesh.nodes == again.scene.bodies[0].mesh.nodes);
  problem.length = 1 / 1024.0;
  problem.force = 1024;
  const AccurateSolution other = accurate(scene_of(problem), "peak", 0.01);
  REQUIRE(other.rounds.size() == first.rounds.size());
  CHECK(other.scene.bodies[0].mesh.cells == first.scene.bodies[0].mesh.cells);
  CHECK(*other.rounds.back().error / other.rounds.back().value ==
        Approx(*first.rounds.back().error / first.rounds.back().value).epsilon(1e-9).margin(0));
}

TEST_CASE("what stands in the way is named", "[accuracy]") {
  const Scene scene = cantilever("q4_incompatible", 20, 2);
  Accuracy wanted{1e-4, {"normal_force", NormalForce{}}, 2000};
  const AccurateSolution few = solve_to_accuracy(scene, wanted);
  CHECK_FALSE(few.met);
  CHECK(few.solution.contact.report.status == SolveStatus::Solved);
  CHECK_THAT(few.verdict, ContainsSubstring("budget of unknowns") && ContainsSubstring("2000"));
  wanted = {1e-19, {"normal_force", NormalForce{}}};
  const AccurateSolution exact = solve_to_accuracy(scene, wanted);
  CHECK_FALSE(exact.met);
  CHECK_THAT(exact.verdict, ContainsSubstring("algebraic"));
  Scene open = scene;
  open.bodies[0].loads.edges.clear();
  wanted = {0.01, {"normal_force", NormalForce{}}};
  CHECK_THAT(solve_to_accuracy(open, wanted).verdict, ContainsSubstring("no contact closes"));
}

TEST_CASE("the answer is the value on the mesh and what the estimate says is missing",
          "[accuracy][closed-form]") {
  const AccurateSolution result = accurate(lining_rings(9, 5), "normal_force", 0.001);
  const AccuracyRound& last = result.rounds.back();
  const Estimate& estimated = *result.estimate;
  CHECK(last.of_mesh == value(result.model, result.solution, {"normal_force", NormalForce{}}));
  CHECK(last.value == Approx(last.of_mesh + estimated.error).epsilon(1e-14).margin(0));
  CHECK(std::abs(last.value - lining_force()) < std::abs(last.of_mesh - lining_force()));
}

TEST_CASE("an estimate without a sign corrects nothing, and counts twice", "[accuracy]") {
  const std::string goal = GENERATE("peak", "width");
  CAPTURE(goal);
  const AccurateSolution result = accurate(scene_of(coarse_hertz()), goal, 0.01);
  const AccuracyRound& last = result.rounds.back();
  CHECK(last.value == last.of_mesh);
  CHECK(*last.error >= 2 * result.estimate->error);
  const ErrorParts& parts = last.parts;
  CHECK(*last.error >= std::abs(parts.interior) + std::abs(parts.gap) +
                           std::abs(parts.quadrature_error) + std::abs(parts.free_boundary));
}

TEST_CASE("a finer mesh that gives no answer leaves the one before, and the reason", "[accuracy]") {
  const int kind = GENERATE(0, 1);  // what happens: an error, or a problem without a solution
  CAPTURE(kind);
  Scene scene = pressed_strip(3);
  if (kind == 1) scene.bodies[0].supports = {symmetric("left")};
  bool spoilt = false;
  scene.bodies[0].loads.body_force = [&](const Eigen::Vector2d&) -> Eigen::Vector2d {
    if (spoilt && kind == 0) throw ProblemError("no force is known here");
    return {0, spoilt ? 1e3 : -1.0};
  };
  const Goal goal = {"tip", Displacement{"", Axis::Y, "right"}};
  std::size_t estimated = 0;
  const AccurateSolution result =
      solve_to_accuracy(scene, {1e-6, goal}, [&](const AccuracyRound& round) {
        estimated += round.error ? 1 : 0;
        spoilt = estimated == 2;
      });
  CHECK_FALSE(result.met);
  CHECK_THAT(result.verdict, kind == 0 ? ContainsSubstring("no force is known here")
                                       : ContainsSubstring("not solved on the next mesh"));
  REQUIRE(result.solution.contact.report.status == SolveStatus::Solved);
  REQUIRE(result.estimate);
  CHECK(result.rounds.size() == estimated);
  CHECK(result.rounds.back().of_mesh == value(result.model, result.solution, goal));
  CHECK(result.scene.bodies[0].mesh.n_cells() == result.model.bodies[0].mesh.n_cells());
  // Of the first mesh an error is the caller's.
  if (kind == 0) CHECK_THROWS_AS(solve_to_accuracy(scene, {1e-6, goal}), ProblemError);
}

TEST_CASE("what is one cell thick is halved before anything is estimated", "[accuracy]") {
  const std::string element = GENERATE("q4", "q4_incompatible", "t3");
  CAPTURE(element);
  const auto strip = [&](Eigen::Index rows) {
    Scene scene = pressed_strip(rows);
    if (element == "t3") scene.bodies[0].mesh = split(scene.bodies[0].mesh);
    scene.bodies[0].element = element;
    return scene;
  };
  const double reference = accurate(strip(3), "normal_force", 2e-3).rounds.back().value;
  const AccurateSolution thin = accurate(strip(1), "normal_force", 0.01);
  REQUIRE(thin.met);
  CHECK_FALSE(thin.rounds.front().error.has_value());
  CHECK(thin.rounds.back().value == Approx(reference).epsilon(0.01).margin(0));
  // A single cell has no edge inside.
  Scene single = strip(1);
  BlockSpec spec;
  single.bodies[0].mesh = make_block(spec);
  single.bodies[0].element = "q4";
  CHECK(accurate(single, "normal_force", 0.02).met);
}

TEST_CASE("a source that ends where its body is held is named", "[accuracy]") {
  Scene scene = pressed_strip(3);
  const AccurateSolution result =
      solve_to_accuracy(scene, {1e-3, {"normal_force", NormalForce{}}, 300});
  CHECK_FALSE(result.met);
  CHECK_THAT(result.verdict, ContainsSubstring("budget of unknowns") &&
                                 ContainsSubstring("'bottom'") && ContainsSubstring("(0, 0)"));
}

TEST_CASE("a budget too small for an estimate says so", "[accuracy]") {
  const AccurateSolution result =
      solve_to_accuracy(scene_of(coarse_hertz()), {0.01, {"width", HalfWidth{}}, 600});
  CHECK_FALSE(result.met);
  CHECK_THAT(result.verdict, ContainsSubstring("600") && ContainsSubstring("too coarse"));
}

TEST_CASE("a peak that is not Hertz's is not met", "[accuracy]") {
  Scene scene = pressed_strip(6);
  Body& block = scene.bodies[0];
  block.supports = {symmetric("left")};
  block.loads.edges = {{"top", 0, [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
                          return {0, -std::exp(-x.x() * x.x())};
                        }}};
  // Of a floor that is flat, the contact has no middle.
  CHECK_THAT(problem_message([&] { (void)goal_in_words("peak", plan(scene)); }),
             ContainsSubstring("no middle") && ContainsSubstring("does not press as Hertz's does"));
  scene.contacts[0].target =
      profile([](double x) { return -1e-6 * x * x; }, [](double x) { return -2e-6 * x; });
  const AccurateSolution result = accurate(scene, "peak", 0.005);
  CHECK_FALSE(result.met);
  CHECK_THAT(result.verdict, ContainsSubstring("does not press as Hertz's"));
  const AccuracyRound& last = result.rounds.back();
  CHECK(last.model_error > 0.005 * last.value);
  // Hertz's own is, and its misfit vanishes.
  const AccuracyRound hertz = accurate(scene_of(coarse_hertz()), "peak", 0.003).rounds.back();
  CHECK(hertz.model_error < 0.002 * hertz.value);
}

TEST_CASE("a width that is not Hertz's is not met", "[accuracy]") {
  // The pressure of a wedge is infinite in the middle, and the moment of its forces is not that of an ellipse.
  Scene scene = pressed_strip(2);
  Body& block = scene.bodies[0];
  block.supports = {prescribed("top", Axis::X, 0), prescribed("top", Axis::Y, -0.05)};
  block.loads.edges.clear();
  scene.contacts[0].target = profile([](double x) { return -0.75 * std::abs(x - 2); },
                                     [](double x) { return x < 2 ? 0.75 : -0.75; });
  const AccurateSolution result = accurate(scene, "width", 0.02);
  CHECK_FALSE(result.met);
  CHECK_THAT(result.verdict, ContainsSubstring("does not press as Hertz's"));
  const AccuracyRound& last = result.rounds.back();
  CHECK(last.model_error > 0.2 * last.value);
  // Hertz's own is, of whole and half models, and its misfit vanishes.
  const AccuracyRound hertz = accurate(scene_of(coarse_hertz()), "width", 0.003).rounds.back();
  CHECK(hertz.model_error < 0.001 * hertz.value);
}

TEST_CASE("triangles that the arc of a curved side would leave are named", "[accuracy]") {
  Scene scene =
      lining_rings(3, 1);  // sides of 30 degrees, whose arcs soon rise by more than a cell
  for (Body& body : scene.bodies) body.mesh = split(body.mesh);
  scene.contacts.clear();
  scene.bodies.resize(1);
  const AccurateSolution result = accurate(scene, "displacement:inner.x", 1e-3);
  CHECK_FALSE(result.met);
  INFO(result.verdict);
  CHECK_THAT(result.verdict, ContainsSubstring("geometry"));
}

TEST_CASE("what cannot be meant is refused by name", "[accuracy]") {
  const Scene scene = cantilever("q4", 10, 2);
  const Goal force{"normal_force", NormalForce{}};
  for (const double target : {0.0, -0.1, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THAT(problem_message([&] {
                 (void)solve_to_accuracy(scene, {target, force});
               }),
               ContainsSubstring("target above 0"));
  Scene steps = scene;
  steps.path = Path{};
  CHECK_THAT(problem_message([&] {
               (void)solve_to_accuracy(steps, {0.01, force});
             }),
             ContainsSubstring("load steps"));
  const Plan planned = plan(scene);
  const auto words = [&](const std::string& word) {
    return problem_message([&] { (void)goal_in_words(word, planned); });
  };
  CHECK_THAT(words("forse"), ContainsSubstring("force"));
  CHECK_THAT(words("force:beam.top"), ContainsSubstring("beam.bottom on half plane"));
  CHECK_THAT(words("displacement:top"), ContainsSubstring("displacement:BODY.boundary.x"));
  CHECK_THAT(words("displacement:beam.tip.y"), ContainsSubstring("no boundary 'tip'"));
  CHECK_THAT(words("displacement:bean.top.y"), ContainsSubstring("bean"));
}

TEST_CASE("a width is that of Hertz's contact or none", "[accuracy]") {
  // Even pressure on a half-model: the ellipse of its second moment is wider than the block.
  BlockSpec spec;
  spec.cells_x = spec.cells_y = 10;
  Scene scene;
  Body& block = scene.bodies.front();
  block.mesh = make_block(spec);
  block.material = {1000, 0.3, PlaneState::Strain, 1};
  block.supports = {symmetric("left")};
  block.loads.edges = {{"top", 1, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  CHECK_THAT(problem_message([&] { (void)accurate(scene, "width", 0.01); }),
             ContainsSubstring("does not press as Hertz's does"));
}

TEST_CASE("the usual goal is the contact force unless equilibrium says what that is",
          "[accuracy]") {
  const Scene held = cantilever("q4", 10, 2);
  const DefaultGoal force = default_goal(held, plan(held));
  CHECK(force.goal.name == "normal_force");
  CHECK(force.why.empty());
  const Scene floating = scene_of(coarse_hertz());
  const DefaultGoal moved = default_goal(floating, plan(floating));
  CHECK(moved.goal.name == "displacement:disc.middle.y");
  CHECK_THAT(moved.why, ContainsSubstring("equilibrium"));
  Scene alone = held;
  alone.contacts.clear();
  CHECK(default_goal(alone, plan(alone)).goal.name == "displacement:beam.top.y");
}
