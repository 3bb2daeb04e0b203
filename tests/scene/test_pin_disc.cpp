// A pin in a disc that is so large that it could be an infinite plate.
#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/pin.hpp"
#include "meshes/ring.hpp"
#include "papers/solver_table.hpp"
#include "reference/pin.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/readings.hpp"

using Eigen::Index;
using namespace signorini;

namespace {

const double degree = pi / 180;

/// A pin in a disc of 60 radii, shifted by `shift` clearances. Another shift changes the free gap only.
struct Disc {
  double nu;
  SolvedScene run;
  explicit Disc(double poisson_ratio, double shift) : nu(poisson_ratio), run(make(nu, shift)) {}

  static SolvedScene make(double nu, double shift) {
    AnnulusSpec spec;
    spec.outer_radius = 60;
    spec.cells_angle = 120;
    spec.cells_radius = 70;
    spec.grading = similar_cells(60, 70);
    spec.sector = Sector::Half;
    Scene scene;
    Body& body = scene.bodies[0];
    body.mesh = make_annulus(spec);
    body.element = "q4_bbar";
    body.material = {1, nu, PlaneState::Strain, 1};
    body.supports = {symmetric("symmetry"), prescribed("outer", Axis::X, 0.0)};
    scene.contacts = {{{"inner"}, pin_in_hole({0, 0}, 0.01, {0.01 * shift, 0})}};
    return solved(scene, "the disc");
  }
  [[nodiscard]] double modulus() const { return 1 / (1 - nu * nu); }
  [[nodiscard]] double angle(Index pair) const {
    return std::atan2(run.model.pairs.position(pair, 1), run.model.pairs.position(pair, 0));
  }
  /// The state of another shift, on the same compliance.
  [[nodiscard]] ContactState shifted(double shift) const {
    ContactProblem problem = run.condensed.problem;
    for (Index k = 0; k < problem.free_gap.size(); ++k)
      problem.free_gap(k) = 0.01 * (1 - shift * std::cos(angle(k)));
    return find_solver("primal_dual_active_set").solve(problem, {});
  }
  [[nodiscard]] double force(const ContactState& state) const {
    double sum = 0;
    for (Index k = 0; k < state.force.size(); ++k) sum += 2 * state.force(k) * std::cos(angle(k));
    return sum;
  }
};

}  // namespace

// Angle: one cell of 1.5 degrees. Pressure: 0.2 %, of which 0.05 % is the mesh.
TEST_CASE("a pin in a large incompressible disc is that of the closed form", "[pin][closed-form]") {
  const Disc disc(0.4999, 3);
  for (const double shift : {2.0, 3.0, 5.0}) {
    CAPTURE(shift);
    const ContactState state = disc.shifted(shift);
    const PinInPlate pin{1, 0.01, disc.force(state), disc.modulus(), disc.modulus()};
    CHECK(disc.angle(state.active().front()) ==
          Approx(pin_contact_angle(pin)).margin(1.5 * degree).epsilon(0));
    const Index pole = state.force.size() - 1;
    for (const Index k : {pole, pole - 5, pole - 10})
      CHECK(state.force(k) / disc.run.model.pairs.weight(k) ==
            Approx(pin_pressure(pin, disc.angle(k))).epsilon(0.002));
  }
}

// The compressible plate has no closed form, only the reference's integral equation.
TEST_CASE("a pin in a large compressible disc is that of the integral equation",
          "[pin][reference]") {
  const Disc disc(0.3, 3);
  for (const reference::RigidPin& expected : reference::rigid_pins) {
    if (expected.half_angle < 20 || expected.half_angle > 70) continue;
    CAPTURE(expected.half_angle);
    double low = 1;  // a pin that just touches: no force
    double high = 60;
    for (int step = 0; step < 40; ++step) {
      const double middle = 0.5 * (low + high);
      const double ratio = disc.modulus() * 0.01 / disc.force(disc.shifted(middle));
      (ratio > expected.clearance_over_load ? low : high) = middle;
    }
    const ContactState state = disc.shifted(low);
    const Index pole = state.force.size() - 1;
    CHECK(disc.angle(state.active().front()) / degree ==
          Approx(expected.half_angle).margin(1.5).epsilon(0));
    CHECK(state.force(pole) / disc.run.model.pairs.weight(pole) / disc.force(state) ==
          Approx(expected.pressure).epsilon(0.002));
  }
}
