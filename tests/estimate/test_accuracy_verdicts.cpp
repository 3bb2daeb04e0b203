// Where refinement to an accuracy ends, and what it carries from mesh to mesh.
#include <cmath>

#include "addons/estimate/accuracy.hpp"
#include "addons/estimate/goal_words.hpp"
#include "addons/estimate/limiting_cause.hpp"
#include "catch_compat.hpp"
#include "closed_form/moduli.hpp"
#include "closed_form/rings.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "meshes/ring.hpp"
#include "meshes/split.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

using namespace signorini;

namespace {

/// A block 2 x 1 of cells of four nodes, pressed down by 1.
Scene pressed_block(Eigen::Index cells, const std::vector<Support>& supports) {
  BlockSpec spec;
  spec.size = {2, 1};
  spec.cells_x = cells;
  spec.cells_y = cells / 2;
  Scene scene;
  Body& block = scene.bodies.front();
  block.mesh = make_block(spec);
  block.element = "q4";
  block.material = {1000, 0.3, PlaneState::Strain, 1};
  block.supports = supports;
  block.loads.edges = {{"top", 1, {}}};
  return scene;
}

/// A body of rectangular cells, or of triangles.
Body block_of(const Mesh& mesh, const char* element, const Material& material,
              const std::vector<Support>& supports) {
  Body body;
  body.mesh = std::string(element) == "t3" ? split(mesh) : mesh;
  body.element = element;
  body.material = material;
  body.supports = supports;
  return body;
}

/// A short thick plate pushed onto a soft block, of triangles.
Scene stamp() {
  Scene scene;
  scene.bodies = {
      block_of(block("a", {1, 2}, {2, 1}, 2, 2), "t3", {2739.22, 0.45, PlaneState::Stress, 1},
               {prescribed("top", Axis::X, 0), prescribed("top", Axis::Y, -0.02724)}),
      block_of(block("s", {0, 0}, {4, 2}, 4, 2), "t3", {1000, 0.3, PlaneState::Stress, 1},
               {fixed("bottom")})};
  scene.contacts = {{{"bottom", "a"}, Side{"top", "s"}}};
  return scene;
}

/// Half of a footing that rubs on the ground, of squares.
Scene rubbing_footing() {
  Scene scene;
  scene.bodies = {
      block_of(block("f", {0, 2}, {2, 1}, 2, 1), "q4", {5000, 0.3, PlaneState::Strain, 1},
               {symmetric("left")}),
      block_of(block("s", {0, 0}, {4, 2}, 4, 2), "q4", {1000, 0.3, PlaneState::Strain, 1},
               {fixed("bottom"), symmetric("left")})};
  scene.bodies[0].loads.edges = {{"top", 10, {}}};
  scene.contacts = {{{"bottom", "f"}, Side{"top", "s"}}};
  scene.contacts[0].friction = Friction{0.3};
  return scene;
}

/// A cantilever pressed onto a block on which it slides, of triangles.
Scene sliding_cantilever() {
  Scene scene;
  scene.bodies = {block_of(block("a", {0, 0}, {4, 0.5}, 4, 2), "t3",
                           {1000, 0.1, PlaneState::Stress, 1}, {fixed("left")}),
                  block_of(block("s", {1, -1.005}, {4, 1}, 5, 2), "t3",
                           {700, 0.3, PlaneState::Stress, 1}, {fixed("bottom")})};
  scene.bodies[0].loads.edges = {{"top", 6, {}}};
  scene.contacts = {{{"bottom", "a"}, Side{"top", "s"}}};
  scene.contacts[0].friction = Friction{0.5};
  return scene;
}

AccurateSolution accurate(const Scene& scene, const std::string& goal, double target) {
  return solve_to_accuracy(scene, {target, goal_in_words(goal, plan(scene))});
}

}  // namespace

TEST_CASE("a peak of pressure that is no peak ends refinement", "[accuracy]") {
  // A flat block on a hardly curved hill presses nowhere as Hertz's cylinder does, however fine its cells are.
  Scene scene = pressed_block(8, {symmetric("left")});
  scene.contacts = {
      {{"bottom"},
       profile([](double x) { return 0.01 - x * x / 200; }, [](double x) { return -x / 100; })}};
  const AccurateSolution result = accurate(scene, "peak", 0.001);
  CHECK_FALSE(result.met);
  CHECK_THAT(result.verdict, ContainsSubstring("the reading is most of the error"));
  const AccuracyRound& last = result.rounds.back();
  CHECK(*last.error > 0.5 * *result.rounds.front().error);
  CHECK(last.of_estimate < 0.001 * std::abs(last.value));
}

TEST_CASE("refinement that still moves the value goes on", "[accuracy]") {
  // A block that stands on one node sinks by as much with each halving of the cells there.
  const Scene scene =
      pressed_block(4, {symmetric("left"), prescribed_at("bottom", {0, 0}, Axis::Y, 0)});
  const Accuracy wanted{0.02, goal_in_words("displacement:top.y", plan(scene)), 5000};
  const AccurateSolution result = solve_to_accuracy(scene, wanted);
  CHECK_THAT(result.verdict, ContainsSubstring("budget of unknowns: the next mesh would have"));
  CHECK(result.rounds.back().unknowns > 16 * result.rounds.front().unknowns);
}

TEST_CASE("parts of an estimate that cancel do not make an answer that still moves accurate",
          "[accuracy]") {
  // Truths of finer and finer cells of eight and of six nodes. Estimates are below these targets on meshes whose answers are
  // 5 %, 1.6 % and 4.6 % off.
  struct Known {
    const char* goal;
    Scene scene;
    double target, truth;
  };
  for (const Known& known :
       {Known{"displacement:a.right.x", stamp(), 0.004, 0.0020014},
        Known{"displacement:s.right.x", rubbing_footing(), 0.005, 0.0022733},
        Known{"displacement:a.right.x", sliding_cantilever(), 0.01, -0.000780}}) {
    const AccurateSolution result = accurate(known.scene, known.goal, known.target);
    CAPTURE(known.goal, known.target, result.rounds.size());
    REQUIRE(result.met);
    const AccuracyRound& last = result.rounds.back();
    CHECK(last.value == Approx(known.truth).epsilon(known.target).margin(0));
    // What is still to come if answers go on as from the mesh before.
    const AccuracyRound& before = result.rounds[result.rounds.size() - 2];
    const double left = static_cast<double>(before.unknowns) / static_cast<double>(last.unknowns);
    CHECK(last.to_come ==
          Approx(std::abs(last.value - before.value) * left / (1 - left)).epsilon(1e-12).margin(0));
    CHECK(*last.error >= last.to_come);
  }
}

TEST_CASE("a value that symmetry makes 0 is not refined for", "[accuracy]") {
  const Scene scene = pressed_block(4, {fixed("left"), fixed("right")});
  const AccurateSolution result = accurate(scene, "displacement:top.x", 0.02);
  CHECK_FALSE(result.met);
  CHECK(result.rounds.size() == 1);
  CHECK_THAT(result.verdict,
             ContainsSubstring("the value is 0, which no error can be compared with"));
  const Goal across = goal_in_words("displacement:top.x", plan(scene));
  const Goal down = goal_in_words("displacement:top.y", plan(scene));
  const double terms = terms_of(result.model, result.solution, across);
  CHECK(terms == terms_of(result.model, result.solution, down));
  CHECK(terms >= std::abs(value(result.model, result.solution, down)));
  CHECK(terms < 1.1 * std::abs(value(result.model, result.solution, down)));
}

TEST_CASE("what no finer mesh mends ends refinement by its name", "[accuracy]") {
  const Scene scene = pressed_block(4, {fixed("left")});
  Accuracy wanted{0.02, goal_in_words("displacement:top.y", plan(scene))};
  CHECK(solve_to_accuracy(scene, wanted).met);
  wanted.warnings = [](const Model& model, const Solution& solution) {
    CHECK(solution.displacements[0].rows() == model.bodies[0].mesh.n_nodes());
    return std::vector<std::string>{"a pillar stands on a needle"};
  };
  const AccurateSolution result = solve_to_accuracy(scene, wanted);
  CHECK_FALSE(result.met);
  CHECK(result.verdict == "a pillar stands on a needle");
  CHECK(result.rounds.back().error.has_value());
}

TEST_CASE("a finer mesh that cannot be forecast leaves the answer, and the reason", "[accuracy]") {
  const Scene scene = pressed_block(4, {fixed("left")});
  Accuracy wanted{1e-6, goal_in_words("displacement:top.y", plan(scene))};
  wanted.most_seconds = 1e-9;
  wanted.forecast = [](const Scene&) -> double { throw ProblemError("no side has an area"); };
  const AccurateSolution result = solve_to_accuracy(scene, wanted);
  CHECK_FALSE(result.met);
  CHECK_THAT(result.verdict, ContainsSubstring("the next mesh gives no answer") &&
                                 ContainsSubstring("no side has an area"));
  CHECK(result.rounds.size() == 1);
  CHECK(result.solution.contact.report.status == SolveStatus::Solved);
}

TEST_CASE("a layer one cell thick is halved across", "[accuracy]") {
  // Stresses of its cells are recovered with those of no others, and nothing is known of them across.
  Scene scene;
  Body& strip = scene.bodies.front();
  strip.mesh = block("strip", {0, 0}, {4, 1}, 4, 2, MeshOrder::Quadratic);
  for (Eigen::Index cell = 4; cell < 8; ++cell) strip.mesh.regions["skin"].push_back(cell);
  strip.material = {1000, 0.3, PlaneState::Strain, 1};
  strip.layers = {{"skin", {20000, 0.3, PlaneState::Strain, 1}}};
  strip.supports = {fixed("left")};
  strip.loads.edges = {{"top", 0.5, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, -0.002}, {0, 1})}};
  const AccurateSolution result = accurate(scene, "normal_force", 0.01);
  REQUIRE(result.met);
  CHECK_FALSE(result.rounds.front().error.has_value());
  // Of eight times as many cells each way it is 0.992.
  CHECK(result.rounds.back().value == Approx(0.992).epsilon(0.01).margin(0));
}

TEST_CASE("a contact that touches at a point is given up by that name", "[accuracy]") {
  Scene scene = pressed_block(8, {fixed("top")});
  Body& block = scene.bodies[0];
  block.mesh = mapped(block.mesh, [](const auto& x) {
    return Eigen::Vector2d(x.x() - x.y(), x.x() + x.y());  // stands on a corner
  });
  block.loads.edges.clear();
  block.loads.body_force = [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, -1); };
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  const AccurateSolution result = accurate(scene, "normal_force", 0.05);
  CHECK_FALSE(result.met);
  CHECK_THAT(result.verdict, ContainsSubstring("touches at points"));
  CHECK(result.solution.contact.active().size() == 1);
}

TEST_CASE("a body of two layers becomes as accurate as asked for", "[accuracy][closed-form]") {
  // A ring of two materials under pressure from inside is two rings that meet without a gap.
  AnnulusSpec spec;
  spec.inner_radius = 60;
  spec.outer_radius = 76;
  spec.cells_angle = 18;
  spec.cells_radius = 4;
  spec.sector = Sector::Quarter;
  Scene scene;
  Body& ring = scene.bodies.front();
  ring.mesh = make_annulus(spec);
  for (Eigen::Index cell = 0; cell < ring.mesh.n_cells(); ++cell)
    if (ring.mesh.nodes(ring.mesh.cells.row(cell), Eigen::all).rowwise().norm().mean() > 68)
      ring.mesh.regions["outside"].push_back(cell);
  const Material soft = {1000, 0.3, PlaneState::Strain, 1},
                 stiff = {9000, 0.2, PlaneState::Strain, 1};
  ring.material = soft;
  ring.layers = {{"outside", stiff}};
  ring.supports = {symmetric("symmetry"), symmetric("symmetry_y")};
  ring.loads.edges = {{"inner", 2, {}}};
  const AccurateSolution result = accurate(scene, "displacement:inner.x", 0.01);
  REQUIRE(result.met);
  REQUIRE(result.rounds.size() > 1);
  CHECK(result.scene.bodies[0].layers.size() == 1);
  const auto of = [](double inside, double outside, const Material& m) {
    return Ring{inside, outside, plane_strain_modulus(m.youngs_modulus, m.poisson_ratio),
                plane_strain_ratio(m.poisson_ratio)};
  };
  const NestedRings rings{of(60, 68, soft), of(68, 76, stiff), 2};
  const double opens = ring_displacement(rings.inner, nested_pressure(rings).inner, 60);
  // The mean of cos over a quarter; sides of 5 degrees miss a fifth of the square of their angle.
  CHECK(result.rounds.back().value == Approx(opens * 2 / pi).epsilon(0.012).margin(0));
}

TEST_CASE("answers that still change are the cause that is named", "[accuracy]") {
  AccurateSolution run;
  run.rounds.emplace_back();
  AccuracyRound& last = run.rounds.back();
  last.of_estimate = last.parts.interior = 0.1;
  last.error = last.to_come = 2;
  CHECK_THAT(limiting_cause(run), ContainsSubstring("answers still change from mesh to mesh"));
}

TEST_CASE("gaps and their reading are one part of the error", "[accuracy]") {
  AccurateSolution run;
  run.rounds.emplace_back();
  AccuracyRound& last = run.rounds.back();
  last.error = last.of_estimate = 2.2;
  last.parts.interior = -1;
  last.parts.gap = 0.6;
  last.parts.quadrature_error = -0.6;
  CHECK_THAT(limiting_cause(run),
             ContainsSubstring("gaps between the nodes of the contact are most"));
}
