// What every member of the element family promises for one cell. A new member joins by its line in elements.cpp.
#include <cmath>
#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"
#include "support/chosen.hpp"
#include "support/meshes.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::chosen;
using signorini_test::distorted_cell;

namespace {

const Material steel{21000, 0.29, PlaneState::Strain, 1};

CellMatrix stiffness_of(const Element& element, const CellNodes& nodes,
                        const Material& material = steel) {
  return cell_stiffness(element, cell_body(nodes, elasticity_matrix(material), depth_of(material)));
}

/// Displacements of a cell's nodes under u = a + F x.
CellVector linear_motion(const CellNodes& nodes, const Eigen::Vector2d& a,
                         const Eigen::Matrix2d& F) {
  CellVector u(2 * nodes.rows());
  for (Index k = 0; k < nodes.rows(); ++k) u.segment<2>(2 * k) = a + F * nodes.row(k).transpose();
  return u;
}

}  // namespace

TEST_CASE("every element has a name, a fitting node count and a degree", "[conformance]") {
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    CHECK(find_element(element.name).shape == element.shape);
    CHECK(std::string(element.summary).size() > 10);
    const int n = element.corners();
    CHECK((element.n_nodes == n || element.n_nodes == 2 * n));
    CHECK(element.degree == element.n_nodes / n);
  }
}

TEST_CASE("every element: shape functions are 1 at their node, 0 at the others, and sum to 1",
          "[conformance]") {
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    const CellNodes at = reference_nodes(element);
    for (int k = 0; k < element.n_nodes; ++k) {
      const CellScalars N = element.shape(at(k, 0), at(k, 1)).value;
      REQUIRE(N.size() == element.n_nodes);
      for (int j = 0; j < element.n_nodes; ++j) CHECK(std::abs(N(j) - (j == k ? 1 : 0)) < 1e-15);
    }
    signorini_test::Random random(11);
    for (int sample = 0; sample < 20; ++sample) {
      const Shape shape = element.shape(random.uniform(-1, 1), random.uniform(-1, 1));
      CHECK(shape.value.sum() == Approx(1).epsilon(1e-14).margin(0));
      CHECK(shape.slope.colwise().sum().norm() < 1e-14);
    }
  }
}

TEST_CASE("every element: slopes of the shape functions equal central differences",
          "[conformance]") {
  const double h = 1e-5;  // truncation h^2 = 1e-10, rounding 1e-16 / h = 1e-11
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    for (const double xi : {-0.7, 0.1, 0.9})
      for (const double eta : {-0.8, 0.3}) {
        const CellNodes slope = element.shape(xi, eta).slope;
        const CellScalars along_xi =
            (element.shape(xi + h, eta).value - element.shape(xi - h, eta).value) / (2 * h);
        const CellScalars along_eta =
            (element.shape(xi, eta + h).value - element.shape(xi, eta - h).value) / (2 * h);
        CHECK((slope.col(0) - along_xi).norm() < 1e-9);
        CHECK((slope.col(1) - along_eta).norm() < 1e-9);
      }
  }
}

TEST_CASE("every element: rigid motions cause no strain anywhere in a distorted cell",
          "[conformance]") {
  Eigen::Matrix2d turn;
  turn << 0, -1, 1, 0;
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    const CellNodes nodes = distorted_cell(element);
    StrainPoints points;
    element.strain(cell_body(nodes, elasticity_matrix(steel), depth_of(steel)), points);
    REQUIRE(points.size > 0);
    const CellVector rigid[] = {linear_motion(nodes, {1, 0}, Eigen::Matrix2d::Zero()),
                                linear_motion(nodes, {0, 1}, Eigen::Matrix2d::Zero()),
                                linear_motion(nodes, {0, 0}, turn)};
    for (int i = 0; i < points.size; ++i)
      for (const CellVector& motion : rigid)
        CHECK((points.point[static_cast<std::size_t>(i)].B * motion).norm() < 1e-14);
  }
}

TEST_CASE("every element: a linear displacement has its exact strain and area over a cell",
          "[conformance]") {
  Eigen::Matrix2d F;
  F << 0.3, -0.2, 0.5, 0.7;
  const Eigen::Vector3d exact(0.3, 0.7, 0.3);
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    // Straight sides: the area is that of the polygon of the corners.
    CellNodes nodes = distorted_cell(element);
    const int n = element.corners();
    for (int side = 0; side < n && element.n_nodes > n; ++side)
      nodes.row(n + side) = 0.5 * (nodes.row(side) + nodes.row((side + 1) % n));
    double area = 0;
    for (int k = 0; k < n; ++k)
      area += 0.5 * (nodes(k, 0) * nodes((k + 1) % n, 1) - nodes(k, 1) * nodes((k + 1) % n, 0));
    StrainPoints points;
    element.strain(cell_body(nodes, elasticity_matrix(steel), depth_of(steel)), points);
    Eigen::Vector3d integral = Eigen::Vector3d::Zero();
    double sum = 0;
    for (int i = 0; i < points.size; ++i) {
      const StrainPoint& point = points.point[static_cast<std::size_t>(i)];
      integral += point.volume * (point.B * linear_motion(nodes, {1, 2}, F));
      sum += point.volume;
    }
    CHECK(sum == Approx(area).epsilon(1e-14).margin(0));
    CHECK((integral - area * exact).norm() < 1e-13);
  }
}

TEST_CASE("every element: a cell has three motions without energy and no more", "[conformance]") {
  for (const Element& element : chosen(elements()))
    for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain}) {
      CAPTURE(element.name);
      const CellMatrix K = stiffness_of(element, distorted_cell(element), {1000, 0.3, state, 1});
      CHECK(K == K.transpose());
      const Eigen::VectorXd values = symmetric_eigenvalues(K);
      const double largest = values(values.size() - 1);
      CHECK(values.head(3).cwiseAbs().maxCoeff() < 1e-13 * largest);
      CHECK(values(3) > 1e-3 * largest);  // an hourglass mode would sit at rounding size
    }
}

TEST_CASE("every element: stiffness does not depend on the corner a cell begins with",
          "[conformance]") {
  for (const Element& element : chosen(elements()))
    for (int n = element.corners(), shift = 1; shift < n; ++shift) {
      CAPTURE(element.name, shift);
      const CellNodes nodes = distorted_cell(element);
      CellNodes turned(element.n_nodes, 2);
      std::vector<Index> from;
      for (int k = 0; k < element.n_nodes; ++k) {
        from.push_back((k + shift) % n + (k < n ? 0 : n));
        turned.row(k) = nodes.row(from.back());
      }
      const CellMatrix K = stiffness_of(element, nodes);
      const CellMatrix K_turned = stiffness_of(element, turned);
      double difference = 0;
      for (Index i = 0; i < K.rows(); ++i)
        for (Index j = 0; j < K.cols(); ++j)
          difference = std::max(
              difference,
              std::abs(K_turned(i, j) - K(2 * from[static_cast<std::size_t>(i / 2)] + i % 2,
                                          2 * from[static_cast<std::size_t>(j / 2)] + j % 2)));
      CHECK(difference < 1e-14 * K.norm());
    }
}

TEST_CASE("every element: stiffness turns with the body", "[conformance]") {
  const double angle = 0.4;
  Eigen::Matrix2d R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    const CellNodes nodes = distorted_cell(element);
    CellMatrix turn = CellMatrix::Zero(2 * element.n_nodes, 2 * element.n_nodes);
    for (Index k = 0; k < element.n_nodes; ++k) turn.block<2, 2>(2 * k, 2 * k) = R;
    const CellMatrix K = stiffness_of(element, nodes);
    const CellMatrix K_turned = stiffness_of(element, CellNodes(nodes * R.transpose()));
    CHECK((K_turned - turn * K * turn.transpose()).norm() < 1e-13 * K.norm());
  }
}

TEST_CASE("every element: stiffness grows with E and thickness and not with size",
          "[conformance]") {
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    const CellNodes nodes = distorted_cell(element);
    const CellMatrix K = stiffness_of(element, nodes);
    const CellMatrix stiffer = stiffness_of(element, nodes, {7 * 21000, 0.29, steel.state, 1});
    const CellMatrix thicker = stiffness_of(element, nodes, {21000, 0.29, steel.state, 0.3});
    const CellMatrix larger = stiffness_of(element, CellNodes(1000 * nodes));
    CHECK((stiffer - 7 * K).norm() < 1e-13 * stiffer.norm());
    CHECK((thicker - 0.3 * K).norm() < 1e-13 * K.norm());
    CHECK((larger - K).norm() < 1e-13 * K.norm());
  }
}
