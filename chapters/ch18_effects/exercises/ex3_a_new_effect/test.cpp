#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "meshes/disc.hpp"
#include "meshes/ring.hpp"
#include "signorini/fem/stress.hpp"

using ex18_3::plan_spinning;
using ex18_3::present;
using ex18_3::solve_spinning;
using ex18_3::Spin;
using ex18_3::SpinningScene;
using namespace signorini;
using Eigen::Index;

namespace {

constexpr double R = 100, E = 210e3, nu = 0.3, rho = 7.85e-9, omega = 1000;  // mm, N, t, s

SpinningScene disc_of_steel() {
  DiscSpec spec;
  spec.radius = R;
  spec.core_cells = spec.layers = 12;
  spec.part = DiscPart::LowerRight;
  spec.order = MeshOrder::Quadratic;
  SpinningScene spinning;
  Body& body = spinning.scene.bodies[0];
  body.mesh = make_disc(spec);
  body.material = {E, nu, PlaneState::Stress, 1};
  body.supports = {symmetric("axis"), symmetric("middle")};
  spinning.spin = {Spin{rho, omega}};
  return spinning;
}

Index node_at(const Mesh& mesh, double x, double y) {
  Index node = 0;
  (mesh.nodes.rowwise() - Eigen::RowVector2d(x, y)).rowwise().squaredNorm().minCoeff(&node);
  return node;
}

StressArray stress_of(const SolvedScene& run) {
  const BodyModel& body = run.model.bodies[0];
  return nodal_stress(body.mesh, body.element, body.material, run.solution.displacements[0]);
}

}  // namespace

// (3 + nu)/8 rho omega^2 R^2 = 32.38 MPa in the middle, where all directions are alike; the rim moves by
// (1 - nu)/4 rho omega^2 R^3 / E. The mesh may be wrong by 1e-3.
TEST_CASE("ex18.3 a thin disc that spins", "[ex18.3]") {
  const SolvedScene run = solve_spinning(disc_of_steel());
  const Mesh& mesh = run.model.bodies[0].mesh;
  const Eigen::Vector4d middle = stress_of(run).row(node_at(mesh, 0, 0)).transpose();
  CHECK(middle(0) == Approx(32.38125).epsilon(1e-3));
  CHECK(middle(1) == Approx(32.38125).epsilon(1e-3));
  const Index rim = node_at(mesh, R, 0);
  CHECK(run.solution.displacements[0](rim, 0) ==
        Approx((1 - nu) / 4 * rho * omega * omega * R * R * R / E).epsilon(1e-4));
}

// Hoop stress at the bore: (3 + nu)/4 rho omega^2 (c^2 + (1 - nu)/(3 + nu) a^2).
TEST_CASE("ex18.3 a ring that spins", "[ex18.3]") {
  SpinningScene spinning = disc_of_steel();
  AnnulusSpec spec;
  spec.inner_radius = 40;
  spec.outer_radius = R;
  spec.cells_angle = spec.cells_radius = 20;
  spec.sector = Sector::Quarter;
  spec.order = MeshOrder::Quadratic;
  spinning.scene.bodies[0].mesh = make_annulus(spec);
  spinning.scene.bodies[0].supports = {symmetric("symmetry"), symmetric("symmetry_y")};
  const SolvedScene run = solve_spinning(spinning);
  const Index bore = node_at(run.model.bodies[0].mesh, 40, 0);
  const double hoop = (3 + nu) / 4 * rho * omega * omega * (R * R + (1 - nu) / (3 + nu) * 40 * 40);
  CHECK(stress_of(run)(bore, 1) == Approx(hoop).epsilon(2e-3));
  CHECK(run.solution.displacements[0](bore, 0) == Approx(40 * hoop / E).epsilon(1e-4));
}

TEST_CASE("ex18.3 the plan has its line, and no unknown or row more", "[ex18.3]") {
  SpinningScene spinning = disc_of_steel();
  REQUIRE(present(spinning));
  const Plan with = plan_spinning(spinning);
  const Plan without = plan(spinning.scene);
  REQUIRE(with.on.size() == without.on.size() + 1);
  CHECK(with.on.back().find("'disc'") != std::string::npos);
  CHECK(with.off == without.off);
  CHECK(with.unknowns.count == without.unknowns.count);
}

TEST_CASE("ex18.3 absent it is named as off and changes no bit", "[ex18.3]") {
  SpinningScene spinning = disc_of_steel();
  spinning.scene.bodies[0].loads.edges = {{"rim", -10, {}}};
  const Solution plain = solve(spinning.scene);
  for (const std::optional<Spin>& none : {std::optional<Spin>(), std::optional<Spin>(Spin{rho, 0}),
                                          std::optional<Spin>(Spin{0, 7})}) {
    spinning.spin = {none};
    CHECK_FALSE(present(spinning));
    CHECK(plan_spinning(spinning).off.back() == "spin");
    CHECK(plan_spinning(spinning).on == plan(spinning.scene).on);
    CHECK(solve_spinning(spinning).solution.displacements[0] == plain.displacements[0]);
  }
}

TEST_CASE("ex18.3 loads and spin add up", "[ex18.3]") {
  SpinningScene spinning = disc_of_steel();
  const auto moved = [](const SpinningScene& s) {
    return solve_spinning(s).solution.displacements[0];
  };
  const NodeArray spin = moved(spinning);
  spinning.scene.bodies[0].loads.edges = {{"rim", -10, {}}};
  const NodeArray both = moved(spinning);
  spinning.spin = {std::nullopt};
  const NodeArray pull = moved(spinning);
  CHECK((both - spin - pull).norm() <= 1e-10 * both.norm());
}

// Half of a disc pulls at the other half with rho omega^2 A x_s = 2 rho omega^2 R^3 / 3.
TEST_CASE("ex18.3 supports bear what the spin pulls", "[ex18.3]") {
  const SolvedScene run = solve_spinning(disc_of_steel());
  const NodeArray force = support_forces(run.model, run.solution);
  const double quarter = rho * omega * omega * R * R * R / 3;
  CHECK(force.col(0).sum() == Approx(-quarter).epsilon(1e-4));
  CHECK(force.col(1).sum() == Approx(quarter).epsilon(1e-4));
}

// About another centre the same forces, and the mass times the way of the centre besides.
TEST_CASE("ex18.3 the centre of a spin need not be the origin", "[ex18.3]") {
  const SpinningScene about_origin = disc_of_steel();
  SpinningScene about_rim = about_origin;
  about_rim.spin[0]->centre = {-R, 0};
  const auto pulls = [](const SpinningScene& s) {
    const SolvedScene run = solve_spinning(s);
    return Eigen::RowVector2d(support_forces(run.model, run.solution).colwise().sum());
  };
  const double mass = rho * std::acos(-1.0) * R * R / 4;  // of the quarter, of thickness 1
  CHECK(pulls(about_rim)(0) - pulls(about_origin)(0) ==
        Approx(-mass * omega * omega * R).epsilon(1e-3));
}
