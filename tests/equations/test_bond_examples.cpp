// The scene files in examples/ that have bonds, against closed forms.
#include <cmath>
#include <filesystem>

#include "addons/equations/equations.hpp"
#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "signorini/scene/readings.hpp"

using namespace signorini;
using Eigen::Index;

namespace {

SolvedScene run_of(const std::string& name) {
  const std::filesystem::path root = std::filesystem::path(SIGNORINI_TEST_DATA) / ".." / "..";
  return solved(read_scene(root / "examples" / (name + ".toml")).scene, name);
}

}  // namespace

// Kept from bending, both layers stretch by the same e: with E' = E / (1 - nu^2) and the free strain s = (1 + nu) alpha T of the
// coating, E1' h1 e = E2' h2 (s - e), and that force pulls at the line of symmetry of the base. The free end is four heights of
// that half of a strip away, which leaves exp(-2.1 * 4) = 2e-4 of what it changes.
TEST_CASE("the coating of the examples pushes as that of a long strip", "[ties][examples]") {
  const SolvedScene run = run_of("glued_layers");
  const double base = 2.1e5 / (1 - 0.3 * 0.3) * 8;
  const double coating = 7e4 / (1 - 0.33 * 0.33) * 2;
  const double push = base * coating / (base + coating) * 1.33 * 2.3e-5 * 100;
  const std::vector<BondForces> sums = bond_forces(run.model, run.solution);
  REQUIRE(sums.size() == 1);
  CHECK(sums[0].force.x() == Approx(-push).epsilon(2e-4));
  CHECK(sums[0].force.y() == Approx(0).margin(1e-9 * push));
}

// Nothing hinders the layers from growing thinner alike, so that each has the stress E e.
TEST_CASE("the periodic cell of the examples bears what its layers bear", "[relations][examples]") {
  const SolvedScene run = run_of("periodic_cell");
  const BondForces sum = bond_forces(run.model, run.solution).front();
  CHECK(sum.force.x() == Approx((3 * 2000 + 70000) * 0.001).epsilon(1e-10));
}

// As test_rigid_sides.cpp has it: -F / A - F e x / I, times the height over E.
TEST_CASE("the plate of the examples tilts by F e h / (E I)", "[rigid-sides][examples]") {
  const SolvedScene run = run_of("tilting_plate");
  const NodeArray& u = run.solution.displacements[0];
  const double inertia = 10 * std::pow(80, 3) / 12;
  const std::vector<Index> top = boundary_nodes(run.model.bodies[0].mesh, "top");
  const double fall = std::abs(u(top.back(), 1) - u(top.front(), 1));
  CHECK(fall == Approx(80.0 * 100 * 5 * 20 / (5 * inertia)).epsilon(1e-9));
}
