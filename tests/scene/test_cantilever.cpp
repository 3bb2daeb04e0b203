// The main example: a cantilever beam pressed onto a rigid flat foundation.
#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "reference/cantilever.hpp"
#include "signorini/scene/scene.hpp"
#include "support/cantilever.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::cantilever;
using signorini_test::Units;

namespace {

/// A solved scene with the matrices it was solved with.
struct Solved {
  Model model;
  Solution solution;
};

Solved solved(const Scene& scene) {
  static_cast<void>(plan(scene));
  Ledger ledger;
  Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  Solution solution = solve(model, condensed, scene.solver, ledger);
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  return {std::move(model), std::move(solution)};
}

double tip_deflection(const Scene& scene) {
  const Solution solution = solve(scene);
  return solution.displacements[0](boundary_nodes(scene.bodies[0].mesh, "bottom").back(), 1);
}

}  // namespace

// Tolerance 1e-6: the digits of the reference.
TEST_CASE("the cantilever reproduces the mesh-exact forces", "[cantilever][reference]") {
  for (const reference::MeshExact& expected : reference::meshes) {
    CAPTURE(expected.element, expected.cells_x);
    const Solved run = solved(cantilever(expected.element, expected.cells_x, expected.cells_y));
    const ContactState& contact = run.solution.contact;
    CHECK(contact.force.sum() == Approx(expected.total_force).epsilon(1e-8).margin(0));
    REQUIRE(contact.active().size() == static_cast<std::size_t>(expected.closed_pairs));
    CHECK(run.model.pairs.position(contact.active().front(), 0) == Approx(42).epsilon(1e-14));
    CHECK(run.model.pairs.position(contact.active().back(), 0) == Approx(50).epsilon(1e-14));
    if (expected.forces[0] == 0) continue;
    for (std::size_t k = 0; k < expected.forces.size(); ++k)
      CHECK(contact.force(contact.active()[k]) == Approx(expected.forces[k]).epsilon(1e-6).margin(0));
  }
}

TEST_CASE("the cantilever reproduces the mesh-exact energy and free deflection",
          "[cantilever][reference][XuanLi2002-9][XuanLi2002-10][XuanLi2002-12]") {
  for (const reference::MeshExact& expected : reference::meshes) {
    if (expected.potential_energy == 0) continue;
    CAPTURE(expected.element, expected.cells_x);
    Scene scene = cantilever(expected.element, expected.cells_x, expected.cells_y);
    const Solved run = solved(scene);
    const Eigen::VectorXd& u = run.solution.refined.displacement;
    const QuadraticProgramme& programme = run.model.programme;
    const double energy = 0.5 * u.dot(programme.stiffness * u) - programme.load.dot(u);
    CHECK(energy == Approx(expected.potential_energy).epsilon(1e-8).margin(0));
    scene.contacts.clear();
    CHECK(tip_deflection(scene) == Approx(expected.free_tip_deflection).epsilon(1e-7).margin(0));
  }
}

TEST_CASE("finer meshes of every kind come together", "[cantilever]") {
  // What is left at h = 1 cm: shear locking of q4, and the corner at the tip.
  const double total = reference::plane_total_force;
  CHECK(solve(cantilever("q4", 100, 10)).contact.force.sum() ==
        Approx(total).epsilon(0.004).margin(0));
  CHECK(solve(cantilever("q4_incompatible", 100, 10)).contact.force.sum() ==
        Approx(total).epsilon(0.001).margin(0));
  CHECK(solve(cantilever("q8", 50, 5)).contact.force.sum() ==
        Approx(total).epsilon(0.001).margin(0));
}

TEST_CASE("under a light load only the tip touches, as beam theory says", "[cantilever]") {
  const Solution solution = solve(cantilever("q4_incompatible", 100, 10, 1.0));
  CHECK(solution.contact.active().size() == 1);
  CHECK(solution.contact.force.sum() > reference::euler_tip_force * 0.99);
  CHECK(solution.contact.force.sum() < reference::timoshenko_tip_force * 1.01);
}

TEST_CASE("below the first touch there is no force and the foundation is not felt",
          "[cantilever]") {
  Scene scene = cantilever("q4_incompatible", 50, 5, 0.27);
  const Solution with = solve(scene);
  scene.contacts.clear();
  const Solution without = solve(scene);
  CHECK(with.contact.active().empty());
  CHECK(with.contact.force.norm() == 0);
  CHECK(with.contact.gap.minCoeff() > 0);
  CHECK((with.displacements[0] - without.displacements[0]).norm() <
        1e-10 * without.displacements[0].norm());
  CHECK(without.contact.force.size() == 0);
  CHECK(without.certificate.holds());
}

TEST_CASE("every solution of the cantilever is certified", "[cantilever][certificate]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible", "q8"})
    for (const double pressure : {0.1, 0.3, 1.0, 3.6, 20.0}) {
      CAPTURE(element, pressure);
      const Solution solution = solve(cantilever(element, 50, 5, pressure));
      CHECK(solution.contact.report.status == SolveStatus::Solved);
      CHECK(solution.certificate.worst() <= 1e-12);
      CHECK(solution.contact.force.minCoeff() >= -1e-13 * solution.contact.force.maxCoeff());
    }
}

TEST_CASE("the clamp carries what the foundation does not, in force and moment",
          "[cantilever][equilibrium]") {
  const Scene scene = cantilever("q4_incompatible", 50, 5);
  const Solved run = solved(scene);
  const Mesh& mesh = scene.bodies[0].mesh;
  // Reactions of all nodes: the whole stiffness matrix times all displacements, minus the loads.
  const Unknowns all = number_unknowns(mesh, {});
  const LinearSystem whole = assemble(mesh, run.model.bodies[0].element, scene.bodies[0].material,
                                      all, scene.bodies[0].loads);
  Eigen::VectorXd u(all.count);
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    u.segment<2>(2 * node) = run.solution.displacements[0].row(node).transpose();
  const Eigen::VectorXd reaction = whole.stiffness * u - whole.load;
  Vector2d clamp(0, 0);
  double moment = 0;
  for (const Index node : boundary_nodes(mesh, "left")) {
    const Vector2d force = reaction.segment<2>(2 * node);
    clamp += force;
    moment += mesh.nodes(node, 0) * force.y() - mesh.nodes(node, 1) * force.x();
  }
  const Pairs& pairs = run.model.pairs;
  const Eigen::VectorXd& force = run.solution.contact.force;
  // 1e-9: rounding of K u, which is about 1e6 times larger than the load in a slender beam.
  CHECK(clamp.x() == Approx(0).margin(180e-9));
  CHECK(clamp.y() + force.sum() == Approx(180).epsilon(1e-9));
  CHECK(moment + force.dot(pairs.position.col(0)) == Approx(180 * 25).epsilon(1e-9));
}

TEST_CASE("centimetres, millimetres and metres give the same answer", "[cantilever][units]") {
  const Solution cm = solve(cantilever("q4_incompatible", 50, 5));
  for (const Units& units : {Units{10, 1e3}, Units{0.01, 1e3}, Units{1e-8, 1e6}}) {
    CAPTURE(units.length);
    const Solution other = solve(cantilever("q4_incompatible", 50, 5, 3.6, units));
    CHECK(other.contact.active() == cm.contact.active());
    CHECK(other.contact.report.iterations == cm.contact.report.iterations);
    const auto close = [](const auto& a, const auto& b) {
      return (a - b).norm() <= 1e-10 * b.norm();
    };
    CHECK(close(other.contact.force / units.force, cm.contact.force));
    CHECK(close(other.contact.gap / units.length, cm.contact.gap));
    CHECK(close(other.displacements[0] / units.length, cm.displacements[0]));
    CHECK(close(other.pressure * (units.length * units.length / units.force), cm.pressure));
    CHECK(other.certificate.holds());
  }
}

TEST_CASE("the numbering of cells and nodes does not matter", "[cantilever]") {
  const Scene scene = cantilever("q4_incompatible", 50, 5);
  Scene shuffled = scene;
  signorini_test::Random random(99);
  const auto permutation = [&](Index n) {
    std::vector<Index> list;
    for (Index k = 0; k < n; ++k) list.push_back(k);
    for (int k = static_cast<int>(n) - 1; k > 0; --k)
      std::swap(list[static_cast<std::size_t>(k)],
                list[static_cast<std::size_t>(random.whole(0, k))]);
    return list;
  };
  const std::vector<Index> new_node = permutation(scene.bodies[0].mesh.n_nodes());
  const std::vector<Index> new_cell = permutation(scene.bodies[0].mesh.n_cells());
  for (Index node = 0; node < scene.bodies[0].mesh.n_nodes(); ++node)
    shuffled.bodies[0].mesh.nodes.row(new_node[static_cast<std::size_t>(node)]) =
        scene.bodies[0].mesh.nodes.row(node);
  for (Index cell = 0; cell < scene.bodies[0].mesh.n_cells(); ++cell)
    for (Index k = 0; k < 4; ++k)
      shuffled.bodies[0].mesh.cells(new_cell[static_cast<std::size_t>(cell)], k) =
          new_node[static_cast<std::size_t>(scene.bodies[0].mesh.cells(cell, k))];
  for (auto& [name, sides] : shuffled.bodies[0].mesh.boundaries)
    for (CellSide& side : sides) side.cell = new_cell[static_cast<std::size_t>(side.cell)];
  const Solution first = solve(scene);
  const Solution second = solve(shuffled);
  CHECK(second.contact.active() == first.contact.active());  // pairs come in the order of the boundary
  CHECK((second.contact.force - first.contact.force).norm() < 1e-11 * first.contact.force.norm());
}

TEST_CASE("a beam clamped at the other end is the mirror image", "[cantilever]") {
  const Scene scene = cantilever("q4_incompatible", 50, 5);
  Scene mirrored = scene;
  mirrored.bodies[0].supports = {fixed("right")};
  const Solution first = solve(scene);
  const Solution second = solve(mirrored);
  REQUIRE(second.contact.force.size() == first.contact.force.size());
  CHECK((second.contact.force.reverse() - first.contact.force).norm() <
        1e-11 * first.contact.force.norm());
}

TEST_CASE("turning the whole scene turns the solution", "[cantilever]") {
  const Scene scene = cantilever("q4_incompatible", 50, 5);
  const double angle = 0.7;
  Eigen::Matrix2d R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  Scene turned = scene;
  turned.bodies[0].mesh =
      mapped(scene.bodies[0].mesh, [&](const Vector2d& x) { return Vector2d(R * x); });
  turned.contacts[0].target = half_plane(R * Vector2d(0, -1), R * Vector2d(0, 1));
  const Solution first = solve(scene);
  const Solution second = solve(turned);
  CHECK(second.contact.active() == first.contact.active());
  // The nodes themselves are rounded when they are turned; the slender beam magnifies this.
  CHECK((second.contact.force - first.contact.force).norm() < 1e-9 * first.contact.force.norm());
  CHECK((second.displacements[0] - first.displacements[0] * R.transpose()).norm() <
        1e-9 * first.displacements[0].norm());
  CHECK(second.certificate.holds());
}

TEST_CASE("a second run gives the same bits", "[cantilever]") {
  const Solution first = solve(cantilever("q8", 40, 4));
  const Solution second = solve(cantilever("q8", 40, 4));
  CHECK(first.displacements[0] == second.displacements[0]);
  CHECK(first.contact.force == second.contact.force);
  CHECK(first.contact.gap == second.contact.gap);
  CHECK(first.certificate.worst() == second.certificate.worst());
}

TEST_CASE("loads and gap in proportion give displacements and forces in proportion",
          "[cantilever][units]") {
  const Solution first = solve(cantilever("q4_incompatible", 50, 5));
  Scene doubled = cantilever("q4_incompatible", 50, 5, 7.2);
  doubled.contacts[0].target = half_plane({0, -2}, {0, 1});
  const Solution second = solve(doubled);
  CHECK(second.contact.active() == first.contact.active());
  CHECK((second.contact.force - 2 * first.contact.force).norm() <
        1e-12 * second.contact.force.norm());
}
