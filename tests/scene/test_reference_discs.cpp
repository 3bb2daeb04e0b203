// Published contacts of rollers: two on each other, where both sides are curved, and one on a block.
#include <cmath>

#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "reference/published.hpp"
#include "support/hertz_reading.hpp"

using Eigen::Index;
using namespace signorini;
using namespace signorini_test;

namespace {

/// The cylinders of ANSYS' case VM191: R = 10 and 13, E = 30000 and 29120, nu = 0.25 and 0.3, 3200 N/mm.
Scene cylinders(Index cells) {
  PressedDiscSpec spec;
  spec.name = "upper";
  spec.radius = 10;
  spec.core.x() = 1.5;
  spec.core.y() = 1.5;
  spec.core_columns = cells;
  spec.core_rows = cells;
  spec.layers = cells;
  Scene scene;
  scene.bodies.resize(2);
  Body& upper = scene.bodies[0];
  Body& lower = scene.bodies[1];
  upper.mesh = make_pressed_disc(spec);
  spec.name = "lower";
  spec.radius = 13;
  spec.core_columns = cells + 3;  // so that nodes do not face each other
  lower.mesh = mirrored(make_pressed_disc(spec), MirrorLine::Level);
  upper.material = {30000, 0.25, PlaneState::Strain, 1};
  lower.material = {29120, 0.3, PlaneState::Strain, 1};
  upper.supports = {symmetric("axis")};
  lower.supports = {symmetric("axis"), fixed("middle")};
  upper.loads.edges = {{"middle", 3200 / 2 / 10.0, {}}};
  scene.contacts = {{{"rim", "upper"}, Side{"rim", "lower"}}};
  return scene;
}

}  // namespace

// Plane strain, although the published page says plane stress: b = 1.20 is that of E / (1 - nu^2); the program
// there found 1.1609. 0.5 %: b/R is 0.12, and finer meshes change little.
TEST_CASE("the half-width of VM191's two cylinders", "[reference][hertz]") {
  const double modulus =
      contact_modulus(plane_strain_modulus(30000, 0.25), plane_strain_modulus(29120, 0.3));
  const LineContact theory{1 / (1 / 10.0 + 1 / 13.0), modulus, 3200};
  CHECK(hertz_half_width(theory) == Approx(1.19971).epsilon(1e-5));
  for (const Index cells : {16, 32}) {
    CAPTURE(cells);
    const SolvedScene run = solved(cylinders(cells), "the cylinders");
    const HertzReading out = read_hertz(run, theory);
    CHECK(std::abs(out.width_error) <= 5e-3);
    CHECK(std::abs(out.peak_error) <= 5e-3);
  }
}

// NAFEMS' roller R = 50 on a square block of 200, 35 kN/mm. Pressure and width are Hertz's although a/R is 0.12.
// The published displacement under the roller, -1.307 (8-node cells -1.308), comes from programs that let the
// mesh move; small displacements give -1.281, 2 % less: strains are up to 5 % (p/E of the block) there.
TEST_CASE("the roller of NAFEMS' first contact benchmark", "[reference][hertz]") {
  for (const char* element : {"q4_incompatible", "q8"}) {
    CAPTURE(element);
    HertzMeshSpec spec;
    spec.plate = {100, 200};
    spec.core = 8;
    spec.disc_cells = spec.plate_cells = 20;
    spec.disc_layers = spec.plate_layers = 14;
    spec.layer_grading = 2;
    const bool quadratic = std::string(element) == "q8";
    if (quadratic) spec.order = MeshOrder::Quadratic;
    Scene scene = hertz(spec, element);
    scene.bodies[0].material = {210e3, 0.3, PlaneState::Strain, 1};
    scene.bodies[1].material = {70e3, 0.3, PlaneState::Strain, 1};
    scene.bodies[0].loads.edges = {{"middle", 35000 / 2 / 50.0, {}}};
    const SolvedScene run = solved(scene, "the roller");
    const LineContact theory{
        50, contact_modulus(plane_strain_modulus(210e3, 0.3), plane_strain_modulus(70e3, 0.3)),
        35000};
    CHECK(hertz_half_width(theory) == Approx(reference::roller_half_width).epsilon(1e-6));
    CHECK(hertz_peak_pressure(theory) == Approx(reference::roller_peak).epsilon(1e-6));
    const HertzReading out = read_hertz(run, theory, quadratic ? Trace::Quadratic : Trace::Linear);
    CHECK(std::abs(out.peak_error) <= 5e-4);
    CHECK(std::abs(out.width_error) <= 4e-3);
    const std::vector<Index> nodes = boundary_nodes(scene.bodies[1].mesh, "surface");
    const double under = run.solution.displacements[1](nodes.back(), 1);
    CHECK(scene.bodies[1].mesh.nodes(nodes.back(), 0) == 0);
    CHECK(under ==
          Approx(-1.281).epsilon(quadratic ? 1e-3 : 8e-3));  // q4 still sinks on finer meshes
    const double published =
        quadratic ? reference::roller_displacement_q8 : reference::roller_displacement;
    CHECK(under / published == Approx(0.98).epsilon(0.01));
  }
}
