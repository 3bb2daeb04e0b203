// The Brazilian disc between two elastic plates, Lin et al., section 3.2: three bodies, two contacts,
// a disc and a plate that only contact holds.
#include <cmath>

#include "../chapters/ch12_brazilian_disc/from_gmsh.hpp"
#include "../chapters/ch12_brazilian_disc/reading.hpp"
#include "catch_compat.hpp"
#include "closed_form/hertz_fit.hpp"

using Eigen::Index;
using namespace signorini;
using namespace ch12;

namespace {

Eigen::Vector3d exact(double depth) { return plate_loaded_disc_stress(plate, R, 0, depth - R); }

/// Largest difference of the two contacts, over the largest pressure.
double difference(const SolvedScene& run) {
  const Contact low = contact_of(run, false), high = contact_of(run, true);
  REQUIRE(low.x.size() == high.x.size());
  double worst = 0, peak = 0;
  for (std::size_t k = 0; k < low.x.size(); ++k) {
    CHECK(low.x[k] == high.x[k]);
    worst = std::max(worst, std::abs(low.pressure[k] - high.pressure[k]));
    peak = std::max(peak, low.pressure[k]);
  }
  return worst / peak;
}

}  // namespace

// 2P/(pi d) is itself 0.0525 % more than a disc between plates has.
TEST_CASE("Brazilian disc: 0.05 % of the tension in the middle with 5000 nodes",
          "[brazilian][LinEtAl-44]") {
  const SolvedScene run = solve_disc(for_middle);
  REQUIRE(nodes_of(run) <= 5000);
  CHECK(run.solution.certificate.holds());
  CHECK(middle(run)[0] == Approx(exact(R)[0]).epsilon(5e-4).margin(0));
  CHECK(middle(run)[0] == Approx(strength).epsilon(5e-4).margin(0));
  CHECK(middle(run)[1] == Approx(exact(R)[1]).epsilon(5e-4).margin(0));
  CHECK(exact(R)[0] / strength - 1 == Approx(-5.25e-4).epsilon(1e-3).margin(0));
  // not by chance: a quarter with half of the cells' size
  const double coarse = middle(solve_disc(for_middle, 0.5))[0] / exact(R)[0] - 1;
  CHECK(coarse / (middle(run)[0] / exact(R)[0] - 1) == Approx(4.2).margin(0.5));
}

TEST_CASE("Brazilian disc: the loaded diameter between plates, and where tension begins",
          "[brazilian][LinEtAl-45]") {
  const SolvedScene run = solve_disc(for_axis);
  const Diameter axis = diameter_of(run);
  int beyond = 0;
  for (Index k = 0; k < axis.depth.size(); ++k) {
    const double depth = axis.depth(k);
    if (depth < 2 * b || depth > 2 * R - 2 * b) continue;
    ++beyond;
    CAPTURE(depth);
    CHECK(axis.stress(k, 0) == Approx(exact(depth)[0]).margin(0.01 * strength).epsilon(0));
  }
  CHECK(beyond > 100);
  CHECK(sign_change(axis) == Approx(2.95).margin(0.1).epsilon(0));
  CHECK(sign_change(axis) == Approx(tension_depth(plate, R)).margin(0.02).epsilon(0));
}

TEST_CASE("Brazilian disc: every cut carries the load", "[brazilian]") {
  const SolvedScene run = solve_disc(for_middle, 0.5);
  REQUIRE(run.model.modes.size() == 2);  // disc and upper plate rise and sink freely
  for (const double height : {1.5, 3., 10., 25., 49.9, 50.1, 80., 98.5})
    CHECK(force_across(run, height) == Approx(P / 2).epsilon(1e-11).margin(0));
  for (const bool upper : {false, true}) {
    double sum = 0;
    for (const double force : contact_of(run, upper).force) sum += force;
    CHECK(sum == Approx(P / 2).epsilon(1e-11).margin(0));
  }
}

TEST_CASE("Brazilian disc: a mesh of Gmsh in place of our own", "[brazilian][gmsh]") {
  const std::string chapter = SIGNORINI_TEST_DATA "/../../chapters/ch12_brazilian_disc/";
  const SolvedScene run = solved(disc_of_file(chapter + "disc.msh"), "the disc of Gmsh");
  CHECK(force_across(run, 30) == Approx(P / 2).epsilon(1e-11).margin(0));
  CHECK(middle(run)[0] == Approx(exact(R)[0]).epsilon(5e-3).margin(0));
  for (const bool upper : {false, true}) {
    const Contact contact = contact_of(run, upper);
    CHECK(fit_hertz(contact.x, contact.pressure).peak_pressure ==
          Approx(hertz_peak_pressure(plate)).epsilon(5e-3).margin(0));
  }
}

TEST_CASE("Brazilian disc: the two contacts are alike, and equal if the plates are held alike",
          "[brazilian]") {
  Scene scene = disc_between_plates(for_middle);
  const SolvedScene loaded = solved(scene, "the disc under a load");
  CHECK(difference(loaded) < 1e-3);  // one base is held, the other carries a uniform pressure
  for (const bool upper : {false, true}) {
    const Contact contact = contact_of(loaded, upper);
    CHECK(fit_hertz(contact.x, contact.pressure).peak_pressure ==
          Approx(hertz_peak_pressure(plate)).epsilon(1e-3).margin(0));
    CHECK(half_width_of_forces(contact.x, contact.force) == Approx(b).epsilon(2e-3).margin(0));
  }
  scene.bodies[2].loads = {};
  scene.bodies[2].supports.push_back(prescribed("base", Axis::X, 0));
  scene.bodies[2].supports.push_back(prescribed("base", Axis::Y, -0.0845));
  const SolvedScene held = solved(scene, "the disc under a press");
  REQUIRE(held.model.modes.size() == 1);
  CHECK(difference(held) < 1e-9);
}
