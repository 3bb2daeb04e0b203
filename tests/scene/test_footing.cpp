// A rigid strip footing on soil, Lin et al., section 3.3.
#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/moduli.hpp"
#include "signorini/core/rounding.hpp"
#include "support/footing.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

const double a = footing_half, load = 2 * footing_load * footing_half;
const double soil_plane = plane_strain_modulus(soil_modulus, 0.25);

SolvedScene settled(const Scene& scene) { return solved(scene, "the footing"); }

EdgeBlockSpec soil_142() { return soil_spec(7, 9, 5, 4, 10 * a); }

}  // namespace

// Limits: what these meshes give, rounded up; 5.5, 0.6 and 0.25 % are asked for. The resultant is one sum
// of forces that are all positive.
TEST_CASE("nodes inside of 0.8 a carry their shares of the closed form", "[footing][LinEtAl-46]") {
  const auto [soil, rows, nodes, limit] = GENERATE(table<EdgeBlockSpec, Index, Index, double>(
      {std::make_tuple(soil_142(), 4, 142, 0.025),
       std::make_tuple(soil_spec(30, 40, 34, 64, 40 * a), 12, 2888, 0.002),
       std::make_tuple(soil_spec(60, 72, 66, 64, 40 * a), 16, 9948, 0.0015)}));
  const Scene scene = footing_on(soil, {2, rows});
  CHECK(scene.bodies[0].mesh.n_nodes() + scene.bodies[1].mesh.n_nodes() == nodes);
  const SolvedScene run = settled(scene);
  const Ground ground = ground_of(run);
  CHECK(worst_inside(ground.position, ground.force) < limit);
  CHECK(ground.force.sum() == Approx(load / 2).epsilon(1e-12).margin(0));
  CHECK(run.solution.contact.report.iterations <= 3);
  CHECK(run.solution.certificate.holds());
}

// No edge-graded mesh resolves the edge itself: the last node has too much, its neighbour too little, by
// parts that depend on the grading only, while its pressure grows with the root of the number of cells.
TEST_CASE("at the edge forces converge to a wrong part and pressures to none", "[footing]") {
  double before = 0;
  for (const Index k : {1, 2, 4, 8}) {
    CAPTURE(k);
    const RigidRest rest = rigid_on(soil_spec(8 * k, 10 * k, 9 * k, 4, 40 * a));
    const Index n = rest.force.size();
    const VectorXd off = against_46(rest.position, rest.force);
    CHECK(off(n - 1) == Approx(0.175).margin(0.006));
    CHECK(off(n - 2) == Approx(-0.073).margin(0.006));
    const double pressure = rest.force(n - 1) / (a - rest.position(n - 2)) * 2;
    if (k > 1) CHECK(pressure / before == Approx(std::sqrt(2)).epsilon(0.015));
    before = pressure;
  }
}

// A footing of modulus M times the soil's is off the rigid one by a part of 1.32 / M: 1e-3 of that for
// terms of higher order, and rounding of the forces, which counts at 1e12.
TEST_CASE("a stiffer footing tends to the rigid one as one over its modulus", "[footing]") {
  const RigidRest rigid = rigid_on(soil_142());
  for (int power = 3; power <= 12; ++power) {
    CAPTURE(power);
    const double ratio = std::pow(10, power);
    const SolvedScene run = settled(footing_on(soil_142(), {2, 4, ratio * soil_modulus}));
    const VectorXd difference = ground_of(run).force.head(8) - rigid.force;
    CHECK(difference.norm() / rigid.force.norm() ==
          Approx(1.32 / ratio).epsilon(5e-3).margin(1e-14));
    CHECK(run.solution.certificate.holds());
    CHECK(run.solution.contact.report.iterations <= 3);
  }
}

// REFERENCE: finer meshes of another program, four and three digits, its last pressure limited by its mesh.
TEST_CASE("a finite soil carries more in the middle and sinks less", "[footing][reference]") {
  const double sizes[] = {3, 5, 10, 20, 40};
  const double middle[] = {1.0726, 1.0270, 1.0063, 1.0011, 0.9997};
  const double settlement[] = {1.90, 2.52, 3.42, 4.35, 5.27};  // [mm]
  double before = 0;
  for (int k = 0; k < 5; ++k) {
    CAPTURE(sizes[k]);
    const RigidRest rest = rigid_on(soil_spec(40, 40, 44, 16, sizes[k] * a));
    const double off = against_46(rest.position, rest.force)(0);
    CHECK(1 + off == Approx(middle[k]).epsilon(0).margin(3e-4));
    CHECK(off == Approx(0.65 / (sizes[k] * sizes[k])).epsilon(0).margin(1.1e-3));
    CHECK(1e3 * rest.settlement == Approx(settlement[k]).epsilon(0).margin(0.01));
    if (k > 2)  // (2 P / pi E*) ln 2 for twice the size, of an infinite soil
      CHECK(rest.settlement - before ==
            Approx(2 * load / (pi * soil_plane) * std::log(2)).epsilon(0.012));
    before = rest.settlement;
  }
}

// Plates have no shear and the body has: 1 %.
TEST_CASE("thin footings bend as plates on a half-plane", "[footing][closed-form]") {
  const EdgeBlockSpec soil = soil_spec(24, 26, 28, 64, 40 * a);
  const double rigid = rigid_on(soil).force(0);
  double before = rigid;
  for (const FlexibleStrip& plate : flexible_strips) {
    if (plate.softness == 0) continue;
    CAPTURE(plate.softness);
    const double stiffness = plane_strain_modulus(2e7, 0.25) / 12;
    const double thickness = a * std::cbrt(soil_plane / stiffness / plate.softness);
    const Ground ground = ground_of(settled(footing_on(soil, {thickness, 10})));
    const double pressure = ground.force(0) / (ground.position(1) / 2) / footing_load;
    CHECK(pressure == Approx(plate.pressure).epsilon(0.01));
    CHECK(ground.force(0) > before);
    before = ground.force(0);
  }
}

// Per cent over the rigid footing: the body of 1 or 2 m still bends a little, always the same way.
TEST_CASE("the thickness that counts as rigid is one metre", "[footing]") {
  const EdgeBlockSpec soil = soil_spec(24, 26, 28, 64, 40 * a);
  const double rigid = rigid_on(soil).force(0);
  const double thickness[] = {0.25, 0.5, 1, 2}, more[] = {0.1055, 0.0159, 0.0026, 0.0009};
  for (int k = 0; k < 4; ++k) {
    const Ground ground = ground_of(settled(footing_on(soil, {thickness[k], 10})));
    CHECK(ground.force(0) / rigid - 1 == Approx(more[k]).epsilon(0).margin(5e-4));
  }
}
