// What every member of the element family promises on meshes: patch tests and rates of convergence.
#include <Eigen/LU>
#include <cmath>

#include "catch_compat.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/stress.hpp"
#include "support/chosen.hpp"
#include "support/linear_solve.hpp"
#include "support/meshes.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace signorini;
using signorini_test::block_for;
using signorini_test::chosen;
using signorini_test::distorted;
using signorini_test::given_around;
using signorini_test::solve_body;

namespace {

Mesh distorted_patch(const Element& element) {
  return distorted(block_for(element, {4, 3}, 4, 3), {4, 3}, {1, 1}, 17);
}

double largest_error(const Mesh& mesh, const NodeArray& u, const VectorField& exact) {
  double error = 0;
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    error =
        std::max(error, (u.row(node).transpose() - exact(mesh.nodes.row(node).transpose())).norm());
  return error;
}

void check_uniform(const StressArray& stress, const Vector3d& exact, const Material& material) {
  Eigen::Vector4d all;
  all << exact, stress_across(material, exact);
  for (Index row = 0; row < stress.rows(); ++row)
    CHECK((stress.row(row).transpose() - all).norm() < 1e-11 * all.norm());
}

}  // namespace

TEST_CASE("every element: linear displacements around a distorted patch are linear inside",
          "[conformance][patch]") {
  const VectorField exact = [](const Vector2d& x) {
    return Vector2d(1e-3 + 2e-3 * x.x() - 1e-3 * x.y(), -2e-3 + 3e-3 * x.x() + 1.5e-3 * x.y());
  };
  for (const Element& element : chosen(elements()))
    for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain}) {
      CAPTURE(element.name);
      const Material material{1000, 0.3, state, 0.5};
      const Mesh mesh = distorted_patch(element);
      const NodeArray u = solve_body(mesh, element, material, given_around(exact));
      CHECK(largest_error(mesh, u, exact) < 1e-12 * u.rowwise().norm().maxCoeff());
      const Vector3d stress = elasticity_matrix(material) * Vector3d(2e-3, 1.5e-3, 2e-3);
      check_uniform(nodal_stress(mesh, element, material, u), stress, material);
      check_uniform(cell_stress(mesh, element, material, u), stress, material);
    }
}

TEST_CASE("every element: uniform tractions cause uniform stress in a distorted patch",
          "[conformance][patch]") {
  for (const Element& element : chosen(elements()))
    for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain}) {
      CAPTURE(element.name);
      const Material material{1000, 0.3, state, 0.5};
      const Mesh mesh = distorted_patch(element);
      Loads loads;
      loads.edges.push_back({"right", 0, [](const Vector2d&) { return Vector2d(3, 0); }});
      loads.edges.push_back({"top", 2, {}});
      const NodeArray u =
          solve_body(mesh, element, material, {symmetric("left"), symmetric("bottom")}, loads);
      const Vector3d stress(3, -2, 0);
      const Vector3d strain = elasticity_matrix(material).inverse() * stress;
      const VectorField exact = [&](const Vector2d& x) {
        return Vector2d(strain(0) * x.x(), strain(1) * x.y());
      };
      CHECK(largest_error(mesh, u, exact) < 1e-12 * u.rowwise().norm().maxCoeff());
      check_uniform(nodal_stress(mesh, element, material, u), stress, material);
    }
}

namespace {

/// Displacements (sin(2x + y), cos(x - 2y)) and the body force that holds them, E = 2.5, nu = 0.25.
struct Manufactured {
  static constexpr double lambda = 1;
  static constexpr double mu = 1;
  static Vector2d displacement(const Vector2d& x) {
    return {std::sin(2 * x.x() + x.y()), std::cos(x.x() - 2 * x.y())};
  }
  static Vector2d body_force(const Vector2d& x) {
    const double s = std::sin(2 * x.x() + x.y());
    const double c = std::cos(x.x() - 2 * x.y());
    return {(lambda + 2 * mu) * 4 * s + mu * s - (lambda + mu) * 2 * c,
            (lambda + 2 * mu) * 4 * c + mu * c + (lambda + mu) * 2 * s};
  }
};

/// L2 norm of the error of the displacement on the unit square with n x n smoothly bent cells.
double manufactured_error(const Element& element, Index n) {
  const Mesh mesh = mapped(block_for(element, {1, 1}, n, n), [](const Vector2d& x) {
    const double bend = std::sin(3.14159 * x.x()) * std::sin(3.14159 * x.y());
    return Vector2d(x.x() + 0.08 * bend, x.y() - 0.06 * bend);
  });
  const NodeArray u =
      solve_body(mesh, element, Material{2.5, 0.25, PlaneState::Strain, 1},
                 given_around(Manufactured::displacement), {Manufactured::body_force, {}});
  double square = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const CellNodes nodes = cell_nodes(mesh, cell);
    CellNodes values(element.n_nodes, 2);
    for (Index k = 0; k < element.n_nodes; ++k) values.row(k) = u.row(mesh.cells(cell, k));
    for (const GaussPoint& gauss : gauss_cell(element)) {
      const Shape shape = element.shape(gauss.xi, gauss.eta);
      const Vector2d x = nodes.transpose() * shape.value;
      const Vector2d computed = values.transpose() * shape.value;
      square += gauss.weight * jacobian(shape, nodes).determinant *
                (computed - Manufactured::displacement(x)).squaredNorm();
    }
  }
  return std::sqrt(square);
}

}  // namespace

// An error C h^(d+1) (1 + c (k h)^2) has the rate d + 1 + log2((1 + c (k h)^2) / (1 + c (k h)^2 / 4)). With c = 1, k = pi of the
// bend and h = 1/8, that is 0.15 at degree 2, and 0.04 at degree 1 with h = 1/16. Six elements are off by 0.043 (t6), 0.006 (q8)
// and at most 0.004, and on meshes twice as fine by a third to a quarter of that, as the term says.
TEST_CASE("every element: displacements converge with degree + 1 on bent meshes",
          "[conformance][rate]") {
  for (const Element& element : chosen(elements())) {
    const Index n = element.degree == 1 ? 16 : 8;
    const double coarse = manufactured_error(element, n);
    const double fine = manufactured_error(element, 2 * n);
    CAPTURE(element.name, coarse, fine);
    CHECK(std::log2(coarse / fine) == Approx(element.degree + 1).margin(0.05));
    CHECK(fine < 1e-2);
  }
}

TEST_CASE(
    "every element: a body force is its density times area and thickness, at the centre of area",
    "[conformance]") {
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    const Mesh mesh = distorted(block_for(element, {3, 2}, 3, 2), {3, 2}, {1, 1}, 3);
    Loads loads;
    loads.body_force = [](const Vector2d&) { return Vector2d(2, -7); };
    const NodeArray force =
        nodal_loads(mesh, element, Material{1000, 0.3, PlaneState::Stress, 0.5}, loads);
    CHECK((force.colwise().sum() - Eigen::RowVector2d(6, -21)).norm() < 1e-12);
    const double moment = mesh.nodes.col(0).dot(force.col(1)) - mesh.nodes.col(1).dot(force.col(0));
    CHECK(moment == Approx(1.5 * -21 - 1 * 6).epsilon(1e-13));
  }
}
