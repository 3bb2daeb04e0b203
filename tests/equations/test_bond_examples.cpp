// The scene files in examples/ that have bonds, and a curved seat: closed forms, laws and mirrors.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "addons/equations/equations.hpp"
#include "addons/files/scene_file.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/scene/readings.hpp"

using namespace signorini;
using Eigen::Index;

namespace {

Scene scene_of(const std::string& name) {
  const std::filesystem::path root = std::filesystem::path(SIGNORINI_TEST_DATA) / ".." / "..";
  return read_scene(root / "examples" / (name + ".toml")).scene;
}

SolvedScene run_of(const std::string& name) { return solved(scene_of(name), name); }

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

// The bolt is three times as stiff as the sleeve, E A / h = 420000 and 140000 in plane stress: it bears 0.04 * 105000 = 4200 and three
// quarters of what pulls.
TEST_CASE("the bolt of the examples bears its preload and a share of the load", "[relations][examples]") {
  const SolvedScene run = run_of("preloaded_bolt");
  CHECK(bond_forces(run.model, run.solution)[0].force.y() == Approx(-(4200 + 0.75 * 8000)).epsilon(1e-10));
  CHECK(run.solution.contact.force.sum() == Approx(4200 - 0.25 * 8000).epsilon(1e-10));
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

// Coulomb's law for all of the pad: 0.4 times 60, at the end of a drag that begins with all of it at rest.
TEST_CASE("the stamp of the examples drags with its force times the coefficient of friction", "[rigid-sides][examples][steps]") {
  const Scene scene = scene_of("pressed_stamp");
  double sticking = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    const ContactState& contact = step.solution.contact;
    CHECK(contact.force.sum() == Approx(60).epsilon(1e-10));
    CHECK(bond_forces(model, step.solution)[0].force.x() == Approx(-contact.friction.sum()).margin(1e-10 * 60));
    if (step.state.time == 1.1)
      sticking = static_cast<double>(
          std::count(contact.contact_status.begin(), contact.contact_status.end(), ContactStatus::Stick));
    if (step.state.time == 2) CHECK(contact.friction.sum() == Approx(-24).epsilon(1e-10));
  });
  CHECK(end.status == SolveStatus::Solved);
  CHECK(sticking > 0);
}

// All of it slides from the second step on: friction is 0.2 of what presses, and the spring of 400 N/mm bears what its ends have come
// apart.
TEST_CASE("the slider of the examples is held by friction and its spring", "[ties][examples]") {
  const std::filesystem::path root = std::filesystem::path(SIGNORINI_TEST_DATA) / ".." / "..";
  const Scene scene = read_scene(root / "examples" / "drawer.toml").scene;
  Index slides = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    const Resultants sum = resultants(model, step.solution);
    if (step.state.steps > 1) {
      CHECK(sum.force.x() == Approx(-0.2 * sum.force.y()).epsilon(1e-10));
      ++slides;
    }
    const auto moved = [&](std::size_t body, double x, double y) {
      const NodeArray& nodes = model.bodies[body].mesh.nodes;
      Index node = 0;
      (nodes.rowwise() - Eigen::RowVector2d(x, y)).rowwise().squaredNorm().minCoeff(&node);
      return step.solution.displacements[body](node, 0);
    };
    const BondForces spring = bond_forces(model, step.solution).front();
    const double apart = moved(1, 30, 10) - moved(0, 60, 6);
    CHECK(spring.force.x() == Approx(-400 * apart).epsilon(1e-10).margin(1e-12));
  });
  CHECK(end.status == SolveStatus::Solved);
  CHECK(slides == 4);
}

// The seat and the pad are their own mirrors.
TEST_CASE("the pad of the examples is pressed by its seat as its mirror is", "[examples]") {
  const SolvedScene run = run_of("curved_seat");
  const Eigen::VectorXd& p = run.solution.pressure;
  Index closed = 0;
  for (Index k = 0; k < p.size(); ++k) {
    CHECK(p(k) == Approx(p(p.size() - 1 - k)).margin(1e-10 * p.maxCoeff()));
    closed += p(k) > 0 ? 1 : 0;
  }
  CHECK(closed == 19);
  Index highest = 0;
  p.maxCoeff(&highest);
  CHECK(highest == p.size() / 2);
}
