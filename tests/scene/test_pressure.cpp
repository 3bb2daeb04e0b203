// The contact pressure of the cantilever on a fine mesh, and the tip force between two beam theories.
#include "catch_compat.hpp"
#include "closed_form/beam.hpp"
#include "signorini/report/pressure_table.hpp"
#include "support/cantilever.hpp"

using namespace signorini;

TEST_CASE("200 x 20 cells: contact begins at 42 cm and peaks at 11.5 kN/cm2", "[cantilever]") {
  const Scene scene = signorini_test::cantilever("q4_incompatible", 200, 20);
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  const Solution solution = solve(model, condensed, scene.solver, ledger);
  require_solved(solution, "the cantilever");
  const double h = 0.25;  // cell width [cm]
  const double touchdown = model.pairs.position(solution.contact.active().front(), 0);
  CHECK(touchdown >= 42 - h);
  CHECK(touchdown <= 42 + h);
  CHECK(resultants(model, solution).peak_pressure == Approx(11.5).epsilon(0.02).margin(0));
  CHECK(solution.certificate.holds());
}

TEST_CASE("quadratic cells reach the limit of the total force on 100 x 10", "[cantilever]") {
  const Solution solution = solve(signorini_test::cantilever("q8", 100, 10));
  CHECK(solution.contact.force.sum() == Approx(71.626).epsilon(1e-3).margin(0));
}

TEST_CASE("load 1: the tip force lies between the two beam theories", "[cantilever]") {
  const BeamOnFoundation beam{50, 5, 1, 2.1e4, 0.29, 1, 1};
  const double force =
      solve(signorini_test::cantilever("q4_incompatible", 100, 10, 1.0)).contact.force.sum();
  CHECK(force > euler_bernoulli(beam).total_force);
  CHECK(force < timoshenko(beam).total_force);
  CHECK(force > 13.50);
  CHECK(force < 13.59);
}
