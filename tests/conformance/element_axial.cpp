// What every member of the element family promises in axial symmetry: x is the radius, and forces are of the whole
// circle.
#include <Eigen/LU>
#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/rings.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/stress.hpp"
#include "support/chosen.hpp"
#include "support/linear_solve.hpp"
#include "support/meshes.hpp"
#include "support/spheres.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector4d;
using namespace signorini;
using namespace signorini_test;

namespace {

Material axial(double poisson_ratio, double youngs_modulus = 1000) {
  return {youngs_modulus, poisson_ratio, PlaneState::Axial, 1};
}

CellMatrix stiffness_of(const Element& element, const CellNodes& nodes, const Material& material) {
  return cell_stiffness(element, cell_body(nodes, elasticity_matrix(material), depth_of(material)));
}

/// A block whose left side has the given radius, distorted inside.
Mesh distorted_patch(const Element& element, double radius) {
  return moved(distorted(block_for(element, {4, 3}, 4, 3), {4, 3}, {1, 1}, 17), {radius, 0});
}

void check_state(const Mesh& mesh, const Element& element, const Material& material,
                 const NodeArray& u, const VectorField& exact, const Vector4d& stress) {
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    CHECK((u.row(node).transpose() - exact(mesh.nodes.row(node).transpose())).norm() <
          1e-12 * u.rowwise().norm().maxCoeff());
  for (const StressArray& all :
       {nodal_stress(mesh, element, material, u), cell_stress(mesh, element, material, u)})
    for (Index row = 0; row < all.rows(); ++row)
      CHECK((all.row(row).transpose() - stress).norm() < 1e-11 * stress.norm());
}

/// What remains of a displacement, and how large it is: integrals over the body of the squares.
double relative_error(const Mesh& mesh, const Element& element, const NodeArray& u,
                      const VectorField& exact) {
  double square = 0;
  double whole = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const CellNodes nodes = cell_nodes(mesh, cell);
    CellNodes values(element.n_nodes, 2);
    for (Index k = 0; k < element.n_nodes; ++k) values.row(k) = u.row(mesh.cells(cell, k));
    for (const GaussPoint& gauss : gauss_cell(element)) {
      const Shape shape = element.shape(gauss.xi, gauss.eta);
      const Vector2d x = nodes.transpose() * shape.value;
      const double volume = gauss.weight * jacobian(shape, nodes).determinant * x.x();
      square += volume * (values.transpose() * shape.value - exact(x)).squaredNorm();
      whole += volume * exact(x).squaredNorm();
    }
  }
  return std::sqrt(square / whole);
}

/// A tube 0.5 < x < 1.5 of bent cells between two planes, with a pressure of 1 inside.
double tube_error(const Element& element, Index n, double poisson_ratio) {
  const Mesh mesh = mapped(block_for(element, {1, 1}, n, n), [](const Vector2d& x) {
    const double bend = std::sin(pi * x.x()) * std::sin(pi * x.y());
    return Vector2d(0.5 + x.x() + 0.08 * bend, x.y() - 0.06 * bend);
  });
  const Material material = axial(poisson_ratio);
  const NodeArray u = solve_body(mesh, element, material, {symmetric("bottom"), symmetric("top")},
                                 {{}, {{"left", 1, {}}}});
  const double nu = poisson_ratio;
  const Ring ring{0.5, 1.5, 1000 / (1 - nu * nu), nu / (1 - nu)};
  return relative_error(mesh, element, u, [&](const Vector2d& x) {
    return Vector2d(ring_displacement(ring, {1, 0}, std::min(1.5, x.x())), 0);
  });
}

/// A hollow sphere 1 < r < 2 that reaches the axis, with a pressure of 1 inside.
double sphere_error(const Element& element, Index n, double poisson_ratio) {
  AnnulusSpec spec;
  spec.cells_angle = 2 * n;
  spec.cells_radius = n;
  spec.sector = Sector::Quarter;
  spec.order = order_of(element);
  const Mesh mesh = fitting(make_annulus(spec), element);
  const NodeArray u = solve_body(mesh, element, axial(poisson_ratio), {symmetric("symmetry")},
                                 {{}, {{"inner", 1, {}}}});
  const HollowSphere sphere{0.9, 2, 1000, poisson_ratio};    // cells are a little inside of the arc
  const double p = 1 / (0.9 * 0.9 * 0.9) * (8 - 0.729) / 7;  // that makes the same field
  return relative_error(mesh, element, u, [&](const Vector2d& x) {
    return Vector2d(sphere_displacement(sphere, {p, 0}, std::min(2.0, x.norm())) * x.normalized());
  });
}

}  // namespace

TEST_CASE("every element: a cell of a body of revolution has one motion without energy",
          "[conformance][axial]") {
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    CellNodes nodes = distorted_cell(element);
    nodes.col(0).array() += 0.4;
    const CellMatrix K = stiffness_of(element, nodes, axial(0.3));
    CHECK(K == K.transpose());
    const Eigen::VectorXd values = symmetric_eigenvalues(K);
    const double largest = values(values.size() - 1);
    CHECK(std::abs(values(0)) < 1e-13 * largest);
    CHECK(values(1) > 1e-3 * largest);
    CellVector along = CellVector::Zero(2 * element.n_nodes);
    for (Index k = 0; k < element.n_nodes; ++k) along(2 * k + 1) = 1;
    CHECK((K * along).norm() < 1e-13 * K.norm());
  }
}

TEST_CASE("every element: even stretches along the axis and the radius pass a distorted patch",
          "[conformance][axial][patch]") {
  const VectorField exact = [](const Vector2d& x) {
    return Vector2d(2e-3 * x.x(), 1e-3 - 3e-3 * x.y());
  };
  for (const Element& element : chosen(elements()))
    for (const double radius : {0.0, 0.7, 30.0}) {
      CAPTURE(element.name, radius);
      const Material material = axial(0.3);
      const Mesh mesh = distorted_patch(element, radius);
      const NodeArray u = solve_body(mesh, element, material, given_around(exact));
      const Vector4d stress = elasticity_matrix(material) * Vector4d(2e-3, -3e-3, 0, 2e-3);
      check_state(mesh, element, material, u, exact, stress);
    }
}

TEST_CASE("every element: uniform pressures around cause a uniform stress, on the axis too",
          "[conformance][axial][patch]") {
  for (const Element& element : chosen(elements()))
    for (const double radius : {0.0, 0.7}) {
      CAPTURE(element.name, radius);
      const Material material = axial(0.3);
      const Mesh mesh = distorted_patch(element, radius);
      Loads loads;
      loads.edges = {{"right", 2, {}}, {"top", 5, {}}};
      if (radius > 0) loads.edges.push_back({"left", 2, {}});
      const NodeArray u = solve_body(mesh, element, material, {symmetric("bottom")}, loads);
      const Vector4d stress(-2, -5, 0, -2);
      const Vector4d strain = Eigen::Matrix4d(elasticity_matrix(material)).inverse() * stress;
      const VectorField exact = [&](const Vector2d& x) {
        return Vector2d(strain(0) * x.x(), strain(1) * x.y());
      };
      check_state(mesh, element, material, u, exact, stress);
    }
}

TEST_CASE("every element: far from the axis a body of revolution is in plane strain",
          "[conformance][axial]") {
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    const CellNodes nodes = distorted_cell(element);
    const CellMatrix plane = stiffness_of(element, nodes, {1000, 0.3, PlaneState::Strain, 1});
    for (const double radius : {1e4, 1e8}) {
      CellNodes there = nodes;
      there.col(0).array() += radius;
      const CellMatrix ring = stiffness_of(element, there, axial(0.3)) / (2 * pi * radius);
      CHECK((ring - plane).norm() < 4 / radius * plane.norm());
    }
  }
}

TEST_CASE("every element: Lame's tube and hollow sphere converge with degree + 1",
          "[conformance][axial][rate][closed-form]") {
  for (const Element& element : chosen(elements()))
    for (const auto error : {tube_error, sphere_error}) {
      const double coarse = error(element, 8, 0.3);
      const double fine = error(element, 16, 0.3);
      CAPTURE(element.name, error == tube_error, coarse, fine);
      CHECK(std::log2(coarse / fine) > element.degree + 1 - 0.2);
      CHECK(fine < 1e-2);
    }
}

TEST_CASE("tube and sphere are as good where they are nearly incompressible",
          "[conformance][axial][closed-form]") {
  for (const char* name : {"q4_bbar", "q4_incompatible"}) {
    if (chosen(elements()).empty()) return;
    const Element& element = find_element(name);
    for (const auto error : {tube_error, sphere_error}) {
      const double coarse = error(element, 8, 0.4999);
      const double fine = error(element, 16, 0.4999);
      CAPTURE(name, error == tube_error, coarse, fine);
      CHECK(std::log2(coarse / fine) > 1.8);
      CHECK(fine < 1e-2);
    }
  }
}

TEST_CASE("every element: loads on a body of revolution are those of the whole circle",
          "[conformance][axial]") {
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    const Mesh mesh = distorted_patch(element, 0.5);  // 0.5 < x < 4.5, 0 < y < 3
    Loads loads;
    loads.body_force = [](const Vector2d&) { return Vector2d(0, -7); };
    const double volume = pi * (4.5 * 4.5 - 0.25) * 3;
    NodeArray force = nodal_loads(mesh, element, axial(0.3), loads);
    CHECK(force.col(1).sum() == Approx(-7 * volume).epsilon(1e-13));
    CHECK(force.col(0).isZero(0));
    loads = {{}, {{"top", 2, {}}}};
    force = nodal_loads(mesh, element, axial(0.3), loads);
    CHECK(force.col(1).sum() == Approx(-2 * pi * (4.5 * 4.5 - 0.25)).epsilon(1e-13));
    loads = {{}, {{"right", 0, [](const Vector2d&) { return Vector2d(0, 3); }}}};
    force = nodal_loads(mesh, element, axial(0.3), loads);
    CHECK(force.col(1).sum() == Approx(3 * 2 * pi * 4.5 * 3).epsilon(1e-13));
    const Eigen::VectorXd weights = boundary_weights(mesh, "bottom", depth_of(axial(0.3)));
    CHECK(weights.sum() == Approx(pi * (4.5 * 4.5 - 0.25)).epsilon(1e-13));
  }
}
