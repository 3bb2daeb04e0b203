// Rings in rings: without gap, pressed in, and with meshes that are turned against each other.
#include <cmath>

#include "catch_compat.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/scene/readings.hpp"
#include "support/lining.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::closed_form;
using signorini_test::Lining;
using signorini_test::scene_of;

namespace {

StressArray stress_of(const SolvedScene& run, std::size_t body) {
  const BodyModel& model = run.model.bodies[body];
  return cell_stress(model.mesh, model.element, model.material, run.solution.displacements[body]);
}

/// Radial and hoop stress of a cell whose middle is at `x`.
RingStress polar(const Eigen::RowVector2d& x, const Eigen::RowVector4d& stress) {
  const Eigen::RowVector2d e = x.normalized();
  const double radial =
      stress(0) * e.x() * e.x() + stress(1) * e.y() * e.y() + 2 * stress(2) * e.x() * e.y();
  return {radial, stress(0) + stress(1) - radial};
}

/// Code_Aster SSNP152 and SSNP167 without the part that varies: pressed from outside, no gap [m, Pa].
Lining aster(Index times) {
  Lining rings;
  const double radii[] = {0.2, 0.6, 0.6, 1};
  std::copy(radii, radii + 4, rings.radii);
  rings.inside = 0;
  rings.outside = 1e7;
  rings.youngs_modulus = 1e9;
  rings.poisson_ratio = 0.2;
  rings.cells_angle = 9 * times;
  rings.cells_radius = 8 * times;
  return rings;
}

/// The lining in a rock whose mesh is turned by half a cell.
Scene turned(const Lining& lining) {
  Scene scene = scene_of(lining);
  const Index n = lining.cells_angle;
  const double cell = std::acos(0.0) / static_cast<double>(n);
  AnnulusSpec rock;
  rock.name = "rock";
  rock.inner_radius = lining.radii[2];
  rock.outer_radius = lining.radii[3];
  rock.cells_angle = n + 1;
  rock.cells_radius = lining.cells_radius;
  rock.rays = Eigen::VectorXd::LinSpaced(n + 2, -0.5, static_cast<double>(n) + 0.5) * cell;
  rock.rays(0) = 0;
  rock.rays(n + 1) = std::acos(0.0);
  rock.sector = Sector::Quarter;
  if (lining.element == "q8") rock.order = MeshOrder::Quadratic;
  scene.bodies[1].mesh = make_annulus(rock);
  return scene;
}

Scene swapped(Scene scene) {
  std::swap(scene.contacts[0].source, std::get<Side>(scene.contacts[0].target));
  return scene;
}

}  // namespace

// Nothing slides in a ring, so contact without friction and glue do the same.
TEST_CASE("two rings without gap are the ring of their joined meshes", "[rings]") {
  for (const char* gap_operator : {"node_to_segment", "gauss_points", "mortar"}) {
    CAPTURE(gap_operator);
    Lining rings = aster(1);
    rings.gap_operator = gap_operator;
    const Scene scene = scene_of(rings);
    const SolvedScene two = solved(scene, "the rings");
    Scene glued;
    glued.bodies[0] = scene.bodies[1];
    glued.bodies[0].mesh = joined(scene.bodies[0].mesh, "outer", scene.bodies[1].mesh, "inner");
    const StressArray whole = stress_of(solved(glued, "the glued ring"), 0);
    StressArray parts(whole.rows(), 4);
    parts << stress_of(two, 0), stress_of(two, 1);
    CHECK((parts - whole).norm() < 1e-12 * whole.norm());
  }
}

TEST_CASE("two rings without gap have the stress of one, to 0.05 % on a fine mesh",
          "[rings][closed-form]") {
  const Lining rings = aster(4);
  const SolvedScene run = solved(scene_of(rings), "the rings");
  CHECK(run.solution.pressure.mean() == Approx(9.259259e6).epsilon(5e-5));
  const NestedRings exact = closed_form(rings);
  const Ring whole{0.2, 1, exact.inner.modulus, exact.inner.ratio};
  for (const std::size_t body : {0, 1}) {
    const Mesh& mesh = run.model.bodies[body].mesh;
    const StressArray stress = stress_of(run, body);
    for (Index cell = 0; cell < mesh.cells.rows(); ++cell) {
      Eigen::RowVector2d middle(0, 0);
      for (Index k = 0; k < 4; ++k) middle += mesh.nodes.row(mesh.cells(cell, k)) / 4;
      const RingStress expected = ring_stress(whole, {0, 1e7}, middle.norm());
      const RingStress now = polar(middle, stress.row(cell));
      CHECK(now.radial == Approx(expected.radial).epsilon(0).margin(5e3));  // 0.05 % of the load
      CHECK(now.hoop == Approx(expected.hoop).epsilon(0).margin(5e3));
    }
  }
}

TEST_CASE("a ring pressed into another presses by its interference", "[rings][closed-form]") {
  Lining fit;
  const double radii[] = {60, 68.05, 68, 76};
  std::copy(radii, radii + 4, fit.radii);
  fit.inside = 0;
  double before = 0;
  for (const Index times : {1, 2, 4}) {
    CAPTURE(times);
    fit.cells_angle = 9 * times;
    fit.cells_radius = 5 * times;
    const SolvedScene run = solved(scene_of(fit), "the press fit");
    const double p = nested_pressure(closed_form(fit)).inner.outside;
    CHECK(run.model.pairs.initial_gap.maxCoeff() < -0.0498);
    const double deviation = std::abs(run.solution.pressure.mean() / p - 1);
    CHECK(deviation < 1e-4);
    if (times > 1) CHECK(before / deviation == Approx(4).epsilon(0.02));
    before = deviation;
  }
  fit.inside = 5;  // loads add up: it stays closed
  const SolvedScene loaded = solved(scene_of(fit), "the loaded press fit");
  CHECK(loaded.solution.pressure.mean() ==
        Approx(nested_pressure(closed_form(fit)).inner.outside).epsilon(1e-5));
}

// A node above the middle of a side is nearer to it than to the circle: c cos(half a cell) - b.
TEST_CASE("turned meshes of the lining: nodes begin inside the other ring's chords", "[rings]") {
  Lining lining;
  lining.gap_operator = "node_to_segment";
  const Scene scene = turned(lining);
  Ledger ledger;
  const Eigen::VectorXd inside = build(scene, ledger).pairs.initial_gap;
  const double half_cell = pi / 36;
  for (Index k = 1; k < 9; ++k)
    CHECK(inside(k) == Approx(68.15 * std::cos(half_cell) - 68).epsilon(1e-9));
  const Eigen::VectorXd outside = build(swapped(scene), ledger).pairs.initial_gap;
  for (Index k = 1; k < 10; ++k)
    CHECK(outside(k) == Approx(68.15 - 68 * std::cos(half_cell)).epsilon(1e-9));
}

// On nine straight sides, what the source is called moves the displacement by more than half with pairs of nodes;
// weighted gaps keep the largest to one percent. Curved sides are round to 1e-4 cm: 0.01 %.
TEST_CASE("turned meshes of the lining: weighted gaps hold, and curved sides do", "[rings]") {
  const auto largest = [](const Lining& lining, bool swap) {
    const Scene scene = turned(lining);
    const SolvedScene run = solved(swap ? swapped(scene) : scene, "the turned lining");
    return run.solution.displacements[0].rowwise().norm().maxCoeff();
  };
  Lining lining;
  for (const bool swap : {false, true})
    CHECK(largest(lining, swap) == Approx(0.29189).epsilon(0.01));
  lining.gap_operator = "node_to_segment";
  CHECK(largest(lining, false) < 0.19);
  CHECK(largest(lining, true) > 0.40);
  lining.gap_operator = "mortar";
  lining.element = "q8";
  for (const bool swap : {false, true})
    CHECK(largest(lining, swap) == Approx(0.291893).epsilon(1e-4));
}

// The rotation moves gaps by rounding alone: 1e-17 where its terms are 1.
TEST_CASE("a ring that can turn on its pin is refused", "[rings]") {
  for (const Eigen::Index cells : {12, 16, 22}) {
    CAPTURE(cells);
    AnnulusSpec spec;
    spec.inner_radius = 0.75;
    spec.outer_radius = 1.5;
    spec.cells_angle = cells;
    Scene scene;
    Body& ring = scene.bodies[0];
    ring.mesh = make_annulus(spec);
    ring.supports = {prescribed_at("outer", {1.5, 0}, Axis::X)};
    ring.loads.edges = {{"outer", 0.01, {}}};
    scene.contacts = {{{"inner"}, disc({0, 0}, 0.75)}};
    CHECK_THROWS_WITH(plan(scene), ContainsSubstring("can turn freely about (0, 0)") &&
                                       ContainsSubstring("no contact stops that"));
  }
}
