// The method of section 2.4 of Lin et al., as chapter 11 runs it, against the condensed method and against equilibrium.
#include "../chapters/ch11_hertz/as_printed.hpp"
#include "catch_compat.hpp"
#include "signorini/scene/readings.hpp"

using namespace signorini;

namespace {

// What the pressures of a run press with, along the normal, which is y for both bodies [N/mm].
double pressed(const PrintedRun& run) { return run.pressure.dot(run.model.pairs.weight); }

}  // namespace

// Exact: with the pressures at nodes, on meshes that meet or do not, (42) has the solution of the condensed problem.
TEST_CASE("(42) line by line ends at the pressures of the condensed method", "[hertz][LinEtAl-42]") {
  HertzCase now;
  now.mesh.plate_cells = GENERATE(16, 13);
  const double q0 = hertz_peak_pressure(now.theory());
  const PrintedRun run = run_as_printed(now, {1, 0, 20});
  const SolvedScene condensed = solved(hertz_scene(now), "Hertz");
  CAPTURE(now.mesh.plate_cells);
  CHECK(run.steps() > 0);
  CHECK(run.steps() <= 16);  // as many as the paper reports
  CHECK((run.pressure - condensed.solution.pressure).cwiseAbs().maxCoeff() <= 1e-8 * q0);
  CHECK(pressed(run) == Approx(now.load / 2).epsilon(1e-9));
}

// Exact: of any solution of (42) the pressures balance the load and press or leave a gap; only here J is regular as printed.
TEST_CASE("(42) at two Gauss points on an edge is balanced and complementary", "[hertz][LinEtAl-42]") {
  const HertzCase now = example_with(2, false);
  const double q0 = hertz_peak_pressure(now.theory());
  const double scaled = hertz_half_width(now.theory()) / now.theory().modulus;  // [mm/MPa]
  const PrintedRun run = run_as_printed(now, {scaled, 0, 25});
  CHECK(run.steps() > 0);
  CHECK(pressed(run) == Approx(now.load / 2).epsilon(1e-9));
  CHECK(run.pressure.minCoeff() >= -1e-8 * q0);
  CHECK(run.gap.minCoeff() >= -1e-10);  // [mm]
  CHECK(run.pressure.cwiseProduct(run.gap).cwiseAbs().maxCoeff() <= 1e-8 * q0);
}
