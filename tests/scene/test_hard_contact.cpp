// A disc on a plate under conditions that break naive programs: stiffness, incompressibility, units, places.
#include <cmath>

#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/hertz_reading.hpp"
#include "support/message.hpp"
#include "support/two_bodies.hpp"

using namespace signorini;
using namespace signorini_test;

// The disc floats on its amplitude, so a stiff one is no worse conditioned than the plate. 0.06 and 0.2 %: the
// mesh, which at a ratio of 1 is off by 0.04 and 0.7 % at half the load (b is then only 8 cells wide).
TEST_CASE("one body a million million times stiffer than the other",
          "[contact][hard][LinEtAl-43]") {
  for (const double ratio : {1e3, 1e6, 1e9, 1e12})
    for (const bool disc : {true, false}) {
      CAPTURE(ratio, disc);
      HertzProblem given;
      (disc ? given.disc_modulus : given.plate_modulus) *= ratio;
      given.load /= 2;  // so that the contact is as wide as with two elastic bodies
      const SolvedScene run = solved(scene_of(given), "the disc");
      CHECK(run.solution.certificate.worst() <= 1e-14);
      CHECK(run.solution.contact.report.iterations <= 16);
      const HertzReading out = read_hertz(given, run);
      CHECK(std::abs(out.peak_error) <= 6e-4);
      CHECK(std::abs(out.width_error) <= 2e-3);
      CHECK(run.solution.contact.force.sum() == Approx(given.load / 2).epsilon(1e-12));
    }
}

// Both elements with a mended volumetric strain keep the accuracy they have at 0.3. The sum of the forces is only
// as good as the rows of K add up to zero, and their entries grow with 1 / (1 - 2 nu).
TEST_CASE("nearly incompressible bodies in contact", "[contact][hard][LinEtAl-43]") {
  for (const double ratio : {0.3, 0.49, 0.499, 0.4999, 0.49999})
    for (const char* element : {"q4_bbar", "q4_incompatible"}) {
      CAPTURE(ratio, element);
      HertzProblem given;
      given.element = element;
      given.poisson_ratio = ratio;
      const SolvedScene run = solved(scene_of(given), "the disc");
      const HertzReading out = read_hertz(given, run);
      CHECK(std::abs(out.peak_error) <= (given.element == "q4_bbar" ? 1.2e-4 : 4e-4));
      CHECK(std::abs(out.width_error) <= 2.5e-3);
      CHECK(run.solution.contact.report.iterations <= 10);
      CHECK(run.solution.contact.force.sum() ==
            Approx(given.load / 2).epsilon(1e-14 / (1 - 2 * ratio) + 1e-12));
    }
}

// What the plain elements do instead: the bilinear one is too stiff everywhere, the quadratic one with 3 x 3
// points keeps the mean but lets the pressure of neighbours oscillate.
TEST_CASE("plain elements fail near incompressibility, and the plan says so of q4",
          "[contact][hard]") {
  HertzProblem given;
  given.element = "q4";
  given.poisson_ratio = 0.499;
  const Scene scene = scene_of(given);
  CHECK_THAT(plan(scene).notes.front(), ContainsSubstring("locks"));
  CHECK(read_hertz(given, solved(scene, "q4")).peak_error == Approx(0.161).epsilon(0.02));
  given.element = "q8";
  given.mesh.disc_cells = given.mesh.plate_cells = 9;
  given.mesh.disc_rows = given.mesh.plate_rows = 7;
  given.mesh.disc_layers = given.mesh.plate_layers = 9;
  given.mesh.layer_grading = 1;
  const SolvedScene run = solved(scene_of(given), "q8");
  CHECK(std::abs(read_hertz(given, run).peak_error) <= 2e-3);
  CHECK(run.solution.pressure.maxCoeff() / hertz_peak_pressure(given.theory()) >= 1.03);
}

// 25 combinations; a factor that is no power of two changes the rounding, so 1e-12 and not 0.
TEST_CASE("units change neither forces nor iterations", "[contact][hard]") {
  const SolvedScene base = solved(scene_of({}), "the disc");
  for (const char* solver : {"primal_dual_active_set", "fischer_burmeister", "quasi_active_set"}) {
    Eigen::Index iterations = 0;
    for (const double length : {1.0, 1e-6, 1e-3, 1e3, 1e6})
      for (const double force : {1.0, 1e-6, 1e-3, 1e3, 1e6}) {
        CAPTURE(solver, length, force);
        HertzProblem given;
        given.length = length;
        given.force = force;
        Scene scene = scene_of(given);
        scene.solver = find_solver(solver);
        const SolvedScene run = solved(scene, "the disc");
        if (iterations == 0) iterations = run.solution.contact.report.iterations;
        CHECK(run.solution.contact.report.iterations == iterations);
        CHECK((run.solution.contact.force / force - base.solution.contact.force)
                  .lpNorm<Eigen::Infinity>() <= 1e-12 * base.solution.contact.force.maxCoeff());
      }
  }
}

// The lift goes into the amplitude and nowhere else.
TEST_CASE("where a body that only contact holds begins does not matter", "[contact][hard]") {
  const SolvedScene base = solved(scene_of({}), "the disc");
  const double largest = base.solution.contact.force.maxCoeff();
  const Scene resting = scene_of({});
  const double side = support_forces(base.model, base.solution, 0).cwiseAbs().maxCoeff();
  for (const double lift : {1e-6, 1e-3, 0.1, 1.0, 10.0, 1000.0, -1e-6, -1e-4, -1e-3, -0.01, -0.1}) {
    CAPTURE(lift);
    HertzProblem given;
    given.lift = lift;
    const Scene scene = scene_of(given);
    const SolvedScene run = solved(scene, "the disc");
    // Positions and so gaps of a lifted disc are rounded to the lift.
    const double rounding = 1e-11 + 1e-12 * std::abs(lift);
    CHECK((run.solution.contact.force - base.solution.contact.force).lpNorm<Eigen::Infinity>() <=
          rounding * largest);
    CHECK(run.solution.contact.report.iterations == base.solution.contact.report.iterations);
    CHECK(run.solution.contact.amplitude(0) + lift ==
          Approx(base.solution.contact.amplitude(0)).margin(1e-13 + 1e-15 * std::abs(lift)));
    CHECK(
        (support_forces(run.model, run.solution, 0) - support_forces(base.model, base.solution, 0))
            .cwiseAbs()
            .maxCoeff() <= rounding * side);
  }
}

// Ten millimetres are more than a cell of the disc is deep: then nothing tells a point inside from one far
// outside on the other side, and the library asks. With deeper cells it is solved.
TEST_CASE("deep overlap is solved or refused, by the depth of the cells", "[contact][hard]") {
  HertzProblem given;
  given.lift = -10;
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(scene_of(given))); }),
             ContainsSubstring("deeper than the cell"));
  double stiffness = 0;
  for (const double overlap : {1e-6, 1e-3, 0.1, 1.0, 10.0}) {
    CAPTURE(overlap);
    Scene scene = two_blocks(named_block("lower", {-50, -100}, {100, 100}, 11, 6),
                             named_block("upper", {-40, -overlap}, {80, 100}, 8, 6));
    scene.bodies[1].supports = {fixed("top")};
    const SolvedScene run = solved(scene, "the blocks");
    CHECK(run.solution.contact.report.iterations <= 11);
    if (stiffness == 0) stiffness = run.solution.contact.force.sum() / overlap;
    // The pairs of weights are the same, the force is linear in the overlap.
    CHECK(run.solution.contact.force.sum() == Approx(stiffness * overlap).epsilon(1e-9));
  }
}

// No pair needs a force, so no pair says where the body is; it is put where nothing overlaps.
TEST_CASE("a body without load is pushed out of overlap by nothing", "[contact][hard]") {
  for (const char* solver :
       {"primal_dual_active_set", "quasi_active_set", "goldfarb_idnani", "lemke"}) {
    CAPTURE(solver);
    Scene scene = two_blocks(named_block("lower", {-2, -2}, {4, 2}, 11, 4),
                             named_block("upper", {-1, -0.01}, {2, 1}, 8, 4));
    scene.bodies[1].supports = {prescribed_at("top", {-1, 0.99}, Axis::X)};
    scene.solver = find_solver(solver);
    const SolvedScene run = solved(scene, "the block");
    CHECK(run.solution.contact.force.cwiseAbs().maxCoeff() <= 1e-15);
    CHECK(run.solution.contact.gap.minCoeff() >= -1e-16);
    CHECK(run.solution.displacements[1].col(1).minCoeff() == Approx(0.01).margin(1e-4));
  }
}
