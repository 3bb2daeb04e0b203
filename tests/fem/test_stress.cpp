#include <cmath>

#include "catch_compat.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/fem/von_mises.hpp"
#include "support/meshes.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using namespace signorini;
using signorini_test::block_for;

namespace {

NodeArray sampled(const Mesh& mesh, const VectorField& field) {
  NodeArray u(mesh.n_nodes(), 2);
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    u.row(node) = field(mesh.nodes.row(node).transpose()).transpose();
  return u;
}

}  // namespace

TEST_CASE("the stress of a quadratic displacement on rectangles is exact at the nodes",
          "[stress]") {
  // u = (x^2 + 2 x y, y^2 - 3 x y): strain (2x + 2y, 2y - 3x, 2x - 3y).
  const Material material{10, 0.3, PlaneState::Strain, 1};
  const Mesh mesh = block_for(q8(), {3, 2}, 3, 2);
  const NodeArray u = sampled(mesh, [](const Vector2d& x) {
    return Vector2d(x.x() * x.x() + 2 * x.x() * x.y(), x.y() * x.y() - 3 * x.x() * x.y());
  });
  const StressArray stress = nodal_stress(mesh, q8(), material, u);
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const double x = mesh.nodes(node, 0);
    const double y = mesh.nodes(node, 1);
    const Vector3d exact =
        elasticity_matrix(material) * Vector3d(2 * x + 2 * y, 2 * y - 3 * x, 2 * x - 3 * y);
    CAPTURE(x, y);
    CHECK((stress.row(node).head<3>().transpose() - exact).norm() < 1e-11);
    CHECK(stress(node, 3) == Approx(0.3 * (exact(0) + exact(1))).epsilon(0).margin(1e-11));
  }
}

TEST_CASE("the bending stress of q4_incompatible is exact at the nodes", "[stress]") {
  const Material material{10, 0.3, PlaneState::Stress, 1};
  const Mesh mesh = mapped(block_for(q4_incompatible(), {6, 2}, 3, 1),
                           [](const Vector2d& x) { return Vector2d(x.x(), x.y() - 1); });
  const NodeArray u = sampled(mesh, [](const Vector2d& x) {
    return Vector2d(-x.x() * x.y(), (x.x() * x.x() + 0.3 * x.y() * x.y()) / 2);
  });
  const StressArray stress = nodal_stress(mesh, q4_incompatible(), material, u);
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    CHECK((stress.row(node) - Eigen::RowVector4d(-10 * mesh.nodes(node, 1), 0, 0, 0)).norm() <
          1e-12);
}

TEST_CASE("the mean stress of a cell weights its points by area", "[stress]") {
  // On this trapezium sigma = E (y, 0, 0) has the mean E times the height of the centre of area.
  Mesh mesh;
  mesh.nodes.resize(4, 2);
  mesh.nodes << 0, 0, 4, 0, 3, 3, 1, 3;
  mesh.cells.resize(1, 4);
  mesh.cells << 0, 1, 2, 3;
  const Element element = q4();
  const Material material{1, 0, PlaneState::Stress, 1};
  const NodeArray u = sampled(mesh, [](const Vector2d& x) { return Vector2d(x.x() * x.y(), 0); });
  const StressArray stress = cell_stress(mesh, element, material, u);
  // The integral of du/dx over the cell by the divergence theorem, sides between nodes being linear.
  double integral = 0;
  for (int k = 0; k < 4; ++k) {
    const Index a = mesh.cells(0, k);
    const Index b = mesh.cells(0, (k + 1) % 4);
    integral += 0.5 * (u(a, 0) + u(b, 0)) * (mesh.nodes(b, 1) - mesh.nodes(a, 1));
  }
  CHECK(stress(0, 0) == Approx(integral / 9).epsilon(1e-13));
}

TEST_CASE("von Mises stress of uniaxial, shear and equal biaxial states", "[stress][closed-form]") {
  CHECK(von_mises(Vector4d(-4, 0, 0, 0)) == Approx(4).epsilon(1e-14));
  CHECK(von_mises(Vector4d(0, 0, 0, 4)) == Approx(4).epsilon(1e-14));
  CHECK(von_mises(Vector4d(0, 0, 2, 0)) == Approx(2 * std::sqrt(3.0)).epsilon(1e-14));
  CHECK(von_mises(Vector4d(5, 5, 0, 0)) == Approx(5).epsilon(1e-14));
  CHECK(von_mises(Vector4d::Zero()) == 0);
  const Vector4d stress(3, -1, 2, 0.5);
  for (const int power : {-1000, -600, 600, 1000})  // whose squares are no doubles
    CHECK(von_mises(std::ldexp(1, power) * stress) == std::ldexp(von_mises(stress), power));
  CHECK(von_mises(Vector4d(5, 5, 0, 3)) == Approx(2).epsilon(1e-14));
  CHECK(von_mises(Vector4d(5, 5, 0, 5)) == 0);
}

TEST_CASE(
    "strain energy: of an even strain by hand, half of u K u on every element, and blind to "
    "turning",
    "[stress][closed-form]") {
  const Vector3d even(0.02, -0.01, 0.03);
  for (const Element& element : elements()) {
    CAPTURE(element.name);
    const Mesh mesh = block_for(element, {3, 2}, 3, 2);
    MaterialField material(Material{10, 0.3, PlaneState::Stress, 0.5, 1});
    material.eigenstrain = [](const Material&, const Vector2d&) {
      return Vector4d(7, 7, 0, 7);  // not looked at
    };
    const NodeArray stretched = sampled(mesh, [&](const Vector2d& x) {
      return Vector2d(even(0) * x.x() + even(2) * x.y(), even(1) * x.y());
    });
    const double volume = 3 * 2 * 0.5;
    const double exact = 0.5 * volume * even.dot(elasticity_matrix(material.base) * even);
    CHECK(strain_energy(mesh, element, material, stretched) == Approx(exact).epsilon(1e-13));
    material.eigenstrain = {};
    for (const PlaneState state : {PlaneState::Strain, PlaneState::Axial}) {
      material.base.state = state;
      material.base.thickness = 1;
      const NodeArray bent = sampled(mesh, [](const Vector2d& x) {
        return Vector2d(x.x() * x.y() * x.y(), std::sin(x.x()) - x.y());
      });
      const double work =
          0.5 * internal_forces(mesh, element, material, bent).cwiseProduct(bent).sum();
      CHECK(strain_energy(mesh, element, material, bent) == Approx(work).epsilon(1e-12));
    }
    // Turned a million times as far as it is stretched, in numbers that add up exactly.
    material.base.state = PlaneState::Strain;
    const auto energy = [&](double turned) {
      return strain_energy(mesh, element, material, sampled(mesh, [&](const Vector2d& x) {
                             return Vector2d(0x1p-20 * x.x() - turned * x.y(), turned * x.x());
                           }));
    };
    CHECK(energy(1) == Approx(energy(0)).epsilon(1e-8));
  }
}

TEST_CASE("displacements of the wrong size are refused", "[stress]") {
  const Mesh mesh = block_for(q4(), {1, 1}, 1, 1);
  const NodeArray u = NodeArray::Zero(3, 2);
  CHECK_THROWS_AS(nodal_stress(mesh, q4(), {}, u), std::invalid_argument);
  CHECK_THROWS_AS(cell_stress(mesh, q4(), {}, u), std::invalid_argument);
  CHECK_THROWS_AS(strain_energy(mesh, q4(), {}, u), std::invalid_argument);
}
