// Where a scene lies does not matter as long as its coordinates keep their digits there; where they do not, it is
// refused.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/errors.hpp"
#include "support/far.hpp"
#include "support/message.hpp"
#include "support/random_scenes.hpp"
#include "support/sample.hpp"
#include "support/two_bodies.hpp"

using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

constexpr double grid = 0x1p-26;
constexpr double small = 0x1p-10;
const Vector2d shifts[] = {{0x1p20, 0}, {-1e6, 0.75e6}};

/// What became of a scene: why it was refused, or its pairs and its solution.
struct End {
  std::string refused;
  Pairs pairs;
  std::optional<Solution> solution;
};

End end_of(const Scene& scene) {
  try {
    Ledger ledger;
    const Model model = build(scene, ledger);
    return {"", model.pairs, solve(model, condense(model, ledger), std::move(ledger))};
  } catch (const ProblemError& error) {
    return {error.what(), {}, {}};
  }
}

/// How far the pressures of two scenes differ, over the largest. \return infinity if one is not solved
double difference(const Solution& here, const Solution& there) {
  if (there.contact.report.status != here.contact.report.status) return HUGE_VAL;
  if (here.contact.report.status != SolveStatus::Solved || here.pressure.size() == 0) return 0;
  const double largest = here.pressure.cwiseAbs().maxCoeff();
  const double most = (there.pressure - here.pressure).cwiseAbs().maxCoeff();
  return most == 0 ? 0 : most / largest;
}

/// A rule of the search decides between two equal places. Rounding to a grid may end such a tie, which rounding
/// as large as that of coordinates far away then allows again.
bool tie(const Pairs& here, const Pairs& there) {
  return here.normal.rows() != there.normal.rows() ||
         (here.normal - there.normal).cwiseAbs().maxCoeff() > 1e-9;
}

Mesh bent_block(const char* name) {
  return mapped(named_block(name, {0, 0}, {2, 1}, 10, 4), [](const Vector2d& x) -> Vector2d {
    return {x.x(), x.y() + 0.01 * x.x() * x.x() * (1 - x.y())};
  });
}

/// A body with a boundary on an obstacle, pressed by its weight and on another boundary.
Scene on_obstacle(Mesh mesh, const std::string& side, const Obstacle& obstacle,
                  const std::string& pressed, const std::vector<Support>& supports) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = std::move(mesh);
  body.material = {100, 0.3, PlaneState::Strain, 1};
  body.supports = supports;
  body.loads.body_force = [](const Vector2d&) { return Vector2d(0.3, -4); };
  body.loads.edges = {{pressed, 2, {}}};
  scene.contacts = {{{side}, obstacle}};
  return scene;
}

}  // namespace

TEST_CASE("pressures on a plane, a disc and a hole far away are those at the origin", "[far]") {
  DiscSpec round;
  round.order = MeshOrder::Quadratic;
  round.part = DiscPart::Right;
  AnnulusSpec ring;
  ring.cells_angle = 12;
  ring.sector = Sector::Quarter;
  const Mesh block = on_grid(bent_block("block"), grid);
  const Mesh disc_mesh = on_grid(make_disc(round), grid);
  const Mesh annulus = on_grid(make_annulus(ring), grid);
  const auto scenes = [&](const Vector2d& at) {
    const Obstacle plane = half_plane(at - Vector2d(0, small), {0.1, 1});
    const Obstacle below = half_plane(at - Vector2d(0, 1 + small), {0, 1});
    const Obstacle pin = disc(at + Vector2d(0.75, -4), 4 + small);
    const Obstacle around = hole(at, ring.outer_radius + small);
    return std::vector<Scene>{
        on_obstacle(moved(block, at), "bottom", plane, "top", {prescribed("top", Axis::X, 0)}),
        on_obstacle(moved(block, at), "bottom", pin, "top", {prescribed("top", Axis::X, 0)}),
        on_obstacle(moved(disc_mesh, at), "rim", below, "rim", {symmetric("axis")}),
        on_obstacle(moved(annulus, at), "outer", around, "inner",
                    {symmetric("symmetry"), symmetric("symmetry_y")})};
  };
  const std::vector<Scene> here = scenes({0, 0});
  for (const Vector2d& shift : shifts) {
    const std::vector<Scene> there = scenes(shift);
    for (std::size_t k = 0; k < here.size(); ++k) {
      CAPTURE(k, shift.x());
      const Solution solution = solved(here[k], "here").solution;
      REQUIRE(solution.contact.active().size() > 1);
      CHECK(difference(solution, solved(there[k], "there").solution) <= 1e-12);
    }
  }
}

TEST_CASE("pressures of random scenes far away are those at the origin", "[far][random]") {
  for (const RandomScenes kind : {RandomScenes::Frictionless, RandomScenes::Frictional})
    for (const double sizes : {0x1p20, 1e6}) {
      int compared = 0;
      int without_digits = 0;
      int ties = 0;
      int depends = 0;
      for (std::uint64_t seed = 0; seed < 200; seed += sample_step) {
        const RandomScene drawn = random_scene(seed, kind);
        const double size = size_of(drawn.scene);
        const double step = std::exp2(std::ilogb(size) - 24);
        const Scene scene = on_grid(drawn.scene, step);
        const End here = end_of(scene);
        const Vector2d shift = rounded({sizes * size, -0.75 * sizes * size}, step);
        const End there = end_of(moved(scene, shift));
        CAPTURE(seed, sizes, drawn.text, here.refused, there.refused);
        if (there.refused.find("has lost its digits") != std::string::npos) {
          ++without_digits;
          continue;
        }
        const bool both = here.solution && there.solution;
        if (both && tie(here.pairs, there.pairs)) {
          ++ties;
          continue;
        }
        const double off = both ? difference(*here.solution, *there.solution) : 0;
        const bool same = here.solution.has_value() == there.solution.has_value() && off <= 1e-10;
        if (!same && here.refused.empty() && hidden(scene, shift)) {
          ++depends;
          continue;
        }
        CAPTURE(off);
        CHECK(same);
        compared += both ? 1 : 0;
      }
      CHECK(compared >= 170 / sample_step);
      CHECK(without_digits <= 5);
      CHECK(ties <= 4);
      CHECK(depends <= 6);
    }
}

TEST_CASE("a scene whose coordinates have lost their digits is refused", "[far]") {
  Scene scene = two_blocks(named_block("lower", {0, -1}, {2, 1}, 10, 4),
                           named_block("upper", {0, 0}, {2, 1}, 8, 3));
  scene.bodies[1].supports = {prescribed("top", Axis::X, 0), prescribed("top", Axis::Y, -0.01)};
  CHECK(end_of(moved(scene, {1e8, 0})).solution);
  CHECK_THAT(problem_message([&] {
               static_cast<void>(solve(moved(scene, {2e9, 0})));
             }),
             ContainsSubstring("mesh 'lower' has lost its digits") &&
                 ContainsSubstring("Move the bodies near the origin"));
}
