// An elastic cylinder on an elastic plate, Lin et al., section 3.1.
#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/stress.hpp"
#include "support/hertz_reading.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::HertzProblem;
using signorini_test::HertzReading;
using signorini_test::read_hertz;
using signorini_test::scene_of;
using signorini_test::touching_node;

namespace {

HertzProblem not_matching() {
  HertzProblem problem;
  problem.mesh.plate_cells = 13;
  return problem;
}

/// Root mean square of the error of the pressures with x < 0.7 b, in percent of the largest.
double pressure_error(const HertzProblem& problem) {
  const HertzReading out = read_hertz(problem, solved(scene_of(problem), "Hertz"));
  const LineContact theory = problem.theory();
  double sum = 0;
  std::size_t k = 0;
  for (; out.x[k] < 0.7 * hertz_half_width(theory); ++k)
    sum += std::pow(out.pressure[k] - hertz_pressure(theory, out.x[k]), 2);
  return 100 * std::sqrt(sum / static_cast<double>(k)) / hertz_peak_pressure(theory);
}

}  // namespace

TEST_CASE("Hertz: 1399 nodes give pressure to 0.1 % and half-width to 0.2 % in 10 iterations",
          "[hertz][LinEtAl-43]") {
  for (const char* solver : {"primal_dual_active_set", "fischer_burmeister"}) {
    HertzProblem problem;
    problem.solver = find_solver(solver);
    CAPTURE(solver);
    const SolvedScene run = solved(scene_of(problem), "Hertz");
    const HertzReading out = read_hertz(problem, run);
    CHECK(std::abs(out.peak_error) <= 1e-3);
    CHECK(std::abs(out.width_error) <= 2e-3);
    CHECK(run.solution.contact.report.iterations <= 10);
    CHECK(run.solution.certificate.holds());
  }
  CHECK(signorini_test::n_nodes(HertzMeshSpec()) <= 1412);
}

// On 8-node cells the sum of f x^2 needs no correction.
TEST_CASE("Hertz: quadratic cells reach the same accuracy", "[hertz]") {
  HertzProblem problem;
  problem.element = "q8";
  problem.mesh.order = MeshOrder::Quadratic;
  problem.mesh.disc_cells = problem.mesh.plate_cells = 9;
  problem.mesh.disc_rows = problem.mesh.plate_rows = 7;
  problem.mesh.disc_layers = problem.mesh.plate_layers = 9;
  problem.mesh.layer_grading = 1;
  CHECK(signorini_test::n_nodes(problem.mesh) <= 1412);
  const HertzReading out = read_hertz(problem, solved(scene_of(problem), "Hertz"));
  CHECK(std::abs(out.peak_error) <= 1e-3);
  CHECK(std::abs(out.width_error) <= 2e-3);
}

TEST_CASE("Hertz: triangles of 6 nodes reach 0.15 % on fewer than 2000 nodes", "[hertz]") {
  HertzProblem problem;
  problem.element = "t6";
  problem.mesh.disc_cells = problem.mesh.plate_cells = 9;
  problem.mesh.disc_rows = problem.mesh.plate_rows = 7;
  problem.mesh.disc_layers = problem.mesh.plate_layers = 9;
  problem.mesh.layer_grading = 1;
  const SolvedScene run = solved(scene_of(problem), "Hertz");
  const HertzReading out = read_hertz(problem, run);
  CHECK(std::abs(out.peak_error) <= 1.5e-3);
  CHECK(std::abs(out.width_error) <= 1.5e-3);
  CHECK(run.solution.certificate.holds());
  CHECK(run.model.bodies[0].mesh.n_nodes() + run.model.bodies[1].mesh.n_nodes() < 2000);
}

// The load acts on half of the disc. Along y only the contact holds it: no support takes a share.
TEST_CASE("Hertz: contact carries the load on both bodies, whoever is the source", "[hertz]") {
  for (const bool plate_is_source : {false, true})
    for (const HertzProblem& base : {HertzProblem{}, not_matching()}) {
      HertzProblem problem = base;
      problem.plate_is_source = plate_is_source;
      CAPTURE(plate_is_source, problem.mesh.plate_cells);
      const SolvedScene run = solved(scene_of(problem), "Hertz");
      const NodeArray disc = contact_forces(run.model, run.solution, 0);
      const NodeArray plate = contact_forces(run.model, run.solution, 1);
      CHECK(disc.col(1).sum() == Approx(20.88).epsilon(1e-12));
      CHECK(plate.col(1).sum() == Approx(-20.88).epsilon(1e-12));
      CHECK(std::abs(disc.col(0).sum() + plate.col(0).sum()) < 1e-12 * 20.88);
    }
}

TEST_CASE("Hertz: the nodes that touch first move together to 1e-12 mm", "[hertz]") {
  const SolvedScene run = solved(scene_of(HertzProblem{}), "Hertz");
  const Index disc = touching_node(run.model.bodies[0].mesh);
  const Index plate = touching_node(run.model.bodies[1].mesh);
  REQUIRE(run.model.bodies[0].mesh.nodes.row(disc).isZero());
  REQUIRE(run.model.bodies[1].mesh.nodes.row(plate).isZero());
  const double down = -run.solution.displacements[0](disc, 1);
  CHECK(std::abs(down + run.solution.displacements[1](plate, 1)) <= 1e-12);
  CHECK(down == Approx(0.0296).epsilon(0.002));  // as published for this plate, 0.0291 +- 2 %
}

// The same pairs close after the same number of iterations; forces agree to what rounding leaves.
TEST_CASE("Hertz: lengths and forces in units of 1e-6 to 1e6 change nothing", "[hertz]") {
  const SolvedScene base = solved(scene_of(HertzProblem{}), "Hertz");
  for (const double length : {1e-6, 1.0, 1e6})
    for (const double force : {1e-6, 1e6}) {
      HertzProblem problem;
      problem.length = length;
      problem.force = force;
      CAPTURE(length, force);
      const SolvedScene run = solved(scene_of(problem), "Hertz");
      CHECK(run.solution.contact.active() == base.solution.contact.active());
      CHECK(run.solution.contact.report.iterations == base.solution.contact.report.iterations);
      const double difference =
          (run.solution.contact.force / force - base.solution.contact.force).norm();
      CHECK(difference < 1e-11 * base.solution.contact.force.norm());
    }
}

// First order in b/R: radial normals change the half-width by
// -(4 / 3 pi) (1 - 2 nu) (1 + nu) (1/E_disc - 1/E_plate) q0, by nothing between equal bodies.
TEST_CASE("Hertz: the normal may be either body's if they are equal, and else costs first order",
          "[hertz]") {
  for (const auto& [disc, plate] : {std::pair(4e3, 4e3), {4e3, 4e9}, {4e9, 4e3}, {4e3, 1.2e4}}) {
    HertzProblem problem;
    problem.disc_modulus = disc;
    problem.plate_modulus = plate;
    problem.mesh.core *=
        hertz_half_width(problem.theory()) / hertz_half_width(HertzProblem().theory());
    CAPTURE(disc, plate);
    const double flat = read_hertz(problem, solved(scene_of(problem), "Hertz")).width_error;
    problem.plate_is_source = true;
    const double round = read_hertz(problem, solved(scene_of(problem), "Hertz")).width_error;
    const double drift =
        0.3 * 1.35 * (1 / disc - 1 / plate) * hertz_peak_pressure(problem.theory());
    const double expected = -4 / (3 * pi) * drift;
    CHECK(round - flat == Approx(expected).epsilon(0).margin(2e-4));  // 15e-4 at most; mesh: 1.4e-4
  }
}

// Where meshes match, every node faces a node and the two operators state the same gaps.
TEST_CASE("Hertz: mortar keeps the pressure where meshes do not match, points do not", "[hertz]") {
  for (const bool match : {true, false}) {
    HertzProblem mortar = match ? HertzProblem{} : not_matching();
    HertzProblem points = mortar;
    points.gap_operator = "node_to_segment";
    CAPTURE(match);
    CHECK(pressure_error(mortar) < (match ? 0.1 : 0.3));
    if (match)
      CHECK(pressure_error(points) < 0.1);
    else
      CHECK(pressure_error(points) > 2);
  }
}

// 1 % of the load makes a contact of a tenth of the width, for which the bodies are nearly half-planes;
// at the full load the bodies' size shows: 1.4 % in the plate.
TEST_CASE("Hertz: the largest shear below the surface is M'Ewen's for a narrow contact",
          "[hertz]") {
  for (const double part : {1.0, 0.01}) {
    HertzProblem problem;
    problem.load *= part;
    problem.mesh.core *= std::sqrt(part);
    const SolvedScene run = solved(scene_of(problem), "Hertz");
    for (std::size_t body = 0; body < 2; ++body) {
      CAPTURE(part, body);
      const BodyModel& model = run.model.bodies[body];
      const StressArray stress =
          nodal_stress(model.mesh, model.element, model.material, run.solution.displacements[body]);
      double largest = 0;
      for (const Index node : boundary_nodes(model.mesh, "axis"))
        largest = std::max(largest, (stress(node, 0) - stress(node, 1)) / 2);
      const double exact = hertz_largest_shear(problem.theory()).stress;
      CHECK(largest == Approx(exact).epsilon(part < 1 ? 0.006 : 0.02));
    }
  }
}
