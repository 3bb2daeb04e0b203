// Spheres pressed together: the case SSNV104 of Code_Aster, two hemispheres of radius 50 mm.
#include <Eigen/LU>
#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/moduli.hpp"
#include "meshes/disc.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/readings.hpp"
#include "support/spheres.hpp"

using Eigen::Index;
using namespace signorini;
using namespace signorini_test;

namespace {

constexpr double R = 50, E = 20000, nu = 0.3;  // [mm, N]

/// A hemisphere that rests on its pole, the origin, fine where it will touch: up to 1.25 times `a`.
Body hemisphere(const char* name, double a, Index columns, bool quadratic) {
  PressedDiscSpec spec;
  spec.name = name;
  spec.radius = R;
  spec.core = {1.25 * a, 1.25 * a};
  spec.core_columns = spec.core_rows = quadratic ? columns / 2 : columns;
  spec.layers = quadratic ? 14 : 20;
  spec.layer_grading = 3;
  spec.order = quadratic ? MeshOrder::Quadratic : MeshOrder::Linear;
  Body body;
  body.mesh = make_pressed_disc(spec);
  body.element = quadratic ? "q8" : "q4_incompatible";
  body.material = {E, nu, PlaneState::Axial, 1};
  return body;
}

/// Radius and peak of the ellipse through the pressures that are not at its edge.
struct Ellipse {
  double radius;
  double peak;
};

Ellipse ellipse_of(const SolvedScene& run, double a) {
  Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (Index pair = 0; pair < run.solution.pressure.size(); ++pair) {
    const double r = run.model.pairs.position(pair, 0);
    if (r > 0.9 * a || r == 0) continue;
    const Eigen::Vector2d term(1, -r * r);
    sums += term * term.transpose();
    right += term * run.solution.pressure(pair) * run.solution.pressure(pair);
  }
  const Eigen::Vector2d fit = sums.inverse() * right;  // p^2 = fit(0) - fit(1) r^2
  return {std::sqrt(fit(0) / fit(1)), std::sqrt(fit(0))};
}

// Half a percent is two errors. Hertz's bodies are half spaces: with cells that shrink radius and peak end at .0005 a and -.0007 a
// [mm], which is .001 and -.0015 at a = 2 and half at a = 1. And cells of h = a/32 err in the largest pressure, that beside the axis,
// by .1 h/a = .003 (.0060, .0026 and .0011 with 20, 40 and 80 columns at a = 0.5), and less in the ellipse. Seen: at most .0038.
void check_hertz(const SolvedScene& run, const PointContact& theory) {
  Index nodes = 0;
  for (const BodyModel& body : run.model.bodies) nodes += body.mesh.n_nodes();
  CHECK(nodes <= 5000);
  CHECK(contact_forces(run.model, run.solution).col(1).sum() ==
        Approx(theory.force).epsilon(1e-10));
  const double a = hertz_radius(theory);
  const Ellipse ellipse = ellipse_of(run, a);
  CHECK(ellipse.radius == Approx(a).epsilon(0.002));
  CHECK(ellipse.peak == Approx(hertz_peak_pressure(theory)).epsilon(0.002));
  CHECK(run.solution.pressure.maxCoeff() == Approx(hertz_peak_pressure(theory)).epsilon(0.005));
}

}  // namespace

TEST_CASE("a sphere on a rigid plane has Hertz's radius and peak pressure to 0.5 %",
          "[axial][hertz][closed-form]") {
  for (const bool quadratic : {false, true})
    for (const double a : {1.0, 2.0}) {
      CAPTURE(quadratic, a);
      const double modulus = plane_strain_modulus(E, nu);
      const PointContact theory{R, modulus, 4 * modulus * a * a * a / (3 * R)};
      Scene scene;
      scene.bodies = {hemisphere("sphere", a, 40, quadratic)};
      scene.bodies[0].loads.edges = {{"middle", theory.force / (pi * R * R), {}}};
      scene.contacts = {{{"rim"}, half_plane({0, 0}, {0, 1})}};
      const SolvedScene run = solved(scene, "the sphere");
      check_hertz(run, theory);
      // The end of a side of three nodes on the axis has no share of the surface, and so no pair.
      CHECK((run.model.pairs.position.row(0).x() == 0) != quadratic);
    }
}

TEST_CASE("two spheres have Hertz's radius and peak pressure to 0.5 %",
          "[axial][hertz][closed-form]") {
  const double a = 2;
  const double modulus = plane_strain_modulus(E, nu) / 2;
  const PointContact theory{R / 2, modulus, 4 * modulus * a * a * a / (3 * R / 2)};
  Scene scene;
  scene.bodies = {hemisphere("upper", a, 32, false), hemisphere("lower", a, 27, false)};
  scene.bodies[1].mesh = mirrored(scene.bodies[1].mesh, MirrorLine::Level);
  scene.bodies[0].loads.edges = {{"middle", theory.force / (pi * R * R), {}}};
  scene.bodies[1].supports = {symmetric("middle")};
  scene.contacts = {{{"rim", "upper"}, Side{"rim", "lower"}}};
  check_hertz(solved(scene, "the spheres"), theory);
}
