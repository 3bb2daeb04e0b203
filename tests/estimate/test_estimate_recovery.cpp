#include <cmath>
#include <numeric>

#include "addons/effects/layers.hpp"
#include "addons/estimate/error_products.hpp"
#include "catch_compat.hpp"
#include "meshes/regions.hpp"
#include "meshes/reshape.hpp"
#include "meshes/split.hpp"
#include "signorini/fem/elements.hpp"
#include "support/meshes.hpp"

using namespace signorini;
using Eigen::Index;
using signorini_test::block_for;

namespace {

/// Displacements of the nodes.
template <typename Field>
NodeArray field(const Mesh& mesh, Field&& u) {
  NodeArray nodes(mesh.n_nodes(), 2);
  for (Index k = 0; k < nodes.rows(); ++k)
    nodes.row(k) = u(Eigen::Vector2d(mesh.nodes.row(k).transpose())).transpose();
  return nodes;
}

NodeArray stretched_linearly(const Mesh& mesh) {
  return field(mesh, [](const Eigen::Vector2d& x) {
    return Eigen::Vector2d(0.3 * x.x(), -0.2 * x.y());  // also in axial symmetry a uniform strain
  });
}

double largest(const Eigen::MatrixXd& numbers) { return numbers.cwiseAbs().maxCoeff(); }

}  // namespace

TEST_CASE("a uniform stress is recovered exactly and leaves no error, on any cells",
          "[recovery][closed-form]") {
  const std::size_t member = GENERATE(range(std::size_t{0}, elements().size()));
  const PlaneState state = GENERATE(PlaneState::Stress, PlaneState::Strain, PlaneState::Axial);
  const Element& element = elements()[member];
  CAPTURE(element.name, to_string(state));
  const Eigen::Vector2d size(2, 1);
  Mesh mesh = signorini_test::distorted(block_for(element, size, 5, 4), size, {0.4, 0.25}, 7);
  mesh.nodes.col(0).array() += 1;  // away from the axis
  MaterialField material({200, 0.3, state, 1});
  const NodeArray u = stretched_linearly(mesh);
  const PrimalAndDuals fields{mesh, element, material, {u, u}};
  const SmoothStress smooth = recovered(fields);
  const Elasticity D = elasticity_matrix(material.base);
  Eigen::VectorXd strain = Eigen::VectorXd::Zero(D.rows());
  strain.head(2) << 0.3, -0.2;
  if (D.rows() == 4) strain(3) = 0.3;
  const Eigen::RowVectorXd stress = (D * strain).transpose();
  for (Index k = 0; k < smooth.value.rows(); ++k)
    CHECK(largest(smooth.value.row(k).head(D.rows()) - stress) <= 1e-11 * largest(stress));
  const double energy = 200 * 0.3 * 0.3 * 2;
  CHECK(largest(error_products(fields, smooth)) <= 1e-12 * energy);
}

TEST_CASE("stresses that cells know at their best points are recovered exactly up to the edge",
          "[recovery][closed-form]") {
  const MaterialField material({100, 0.25, PlaneState::Stress, 1});
  // Displacements of one degree more than the element has; their stresses are of the degree of the polynomials.
  const auto bent = [](const Eigen::Vector2d& x, int degree) {
    return Eigen::Vector2d(std::pow(x.x(), degree) - 2 * std::pow(x.y(), degree),
                           0.5 * std::pow(x.x(), degree - 1) * x.y());
  };
  const auto strain = [](const Eigen::Vector2d& x, int degree) {
    return Eigen::Vector3d(degree * std::pow(x.x(), degree - 1), 0.5 * std::pow(x.x(), degree - 1),
                           -2 * degree * std::pow(x.y(), degree - 1) +
                               0.5 * (degree - 1) * std::pow(x.x(), degree - 2) * x.y());
  };
  const char* name = GENERATE("q4", "q8");
  CAPTURE(name);
  const Element& element = find_element(name);
  const int degree = element.degree + 1;
  const Mesh mesh = block_for(element, {2, 1}, 6, 4);
  const SmoothStress smooth =
      recovered({mesh, element, material, {field(mesh, [&](const Eigen::Vector2d& x) {
                   return bent(x, degree);
                 })}});
  for (Index k = 0; k < mesh.n_nodes(); ++k) {
    const Eigen::Vector3d exact =
        elasticity_matrix(material.base) * strain(mesh.nodes.row(k).transpose(), degree);
    CHECK(largest(smooth.value.row(k) - exact.transpose()) <= 1e-10 * 100 * degree * 4);
  }
}

// Of |x|^2 a linear triangle has the gradient in the middle of the circle through its corners, which is that of an
// equilateral triangle.
TEST_CASE(
    "equilateral triangles know a linear stress in their middles, and it is recovered exactly",
    "[recovery][closed-form]") {
  const Mesh rhombus = mapped(block_for(find_element("q4"), {6, 4}, 6, 4), [](const auto& x) {
    return Eigen::Vector2d(x.x() + x.y() / 2, std::sqrt(0.75) * x.y());
  });
  const Mesh mesh = split(rhombus);
  const MaterialField material({100, 0.25, PlaneState::Stress, 1});
  const SmoothStress smooth =
      recovered({mesh, find_element("t3"), material, {field(mesh, [](const Eigen::Vector2d& x) {
                   return Eigen::Vector2d(x.squaredNorm() * Eigen::Vector2d(1, -2));
                 })}});
  for (Index k = 0; k < mesh.n_nodes(); ++k) {
    if ((mesh.cells.array() == k).count() == 1)
      continue;  // the sharp corners, where none is fitted
    const Eigen::Vector2d x = mesh.nodes.row(k);
    const Eigen::Vector3d strain(2 * x.x(), -4 * x.y(), 2 * x.y() - 4 * x.x());
    const Eigen::Vector3d exact = elasticity_matrix(material.base) * strain;
    CHECK(largest(smooth.value.row(k) - exact.transpose()) <= 1e-10 * 100 * 4 * 8);
  }
}

TEST_CASE("each layer is estimated as a body of its own material", "[recovery]") {
  const char* name = GENERATE("q4", "q4_incompatible", "q8", "t3");
  const PlaneState state = GENERATE(PlaneState::Strain, PlaneState::Axial);
  CAPTURE(name, to_string(state));
  const Element& element = find_element(name);
  const Mesh lower = block_for(element, {2, 1}, 4, 3);
  Mesh upper = moved(lower, {0, 1});
  upper.regions["upper"].resize(static_cast<std::size_t>(upper.n_cells()));
  std::iota(upper.regions["upper"].begin(), upper.regions["upper"].end(), Index{0});
  const Material soft = {100, 0.2, state, 1}, stiff = {1000, 0.35, state, 1};
  const auto products = [&](const Mesh& mesh, const MaterialField& material) {
    const NodeArray bent = field(mesh, [](const Eigen::Vector2d& x) {
      return Eigen::Vector2d(std::sin(x.x() + x.y()), std::cos(2 * x.y() - x.x()));
    });
    const NodeArray other = field(mesh, [](const Eigen::Vector2d& x) {
      return Eigen::Vector2d(x.x() * std::pow(x.y(), 3), std::exp(x.x()));
    });
    const PrimalAndDuals fields{mesh, element, material, {bent, other}};
    return Eigen::VectorXd(error_products(fields, recovered(fields)).col(0));
  };
  const Mesh both = joined(lower, "top", upper, "bottom");
  const Eigen::VectorXd together = products(both, layered(both, soft, {{"upper", stiff}}));
  Eigen::VectorXd apart(together.size());
  apart << products(lower, soft), products(upper, stiff);
  CHECK(largest(together - apart) <= 1e-11 * largest(apart));
}

TEST_CASE("nothing is smoothed across layers", "[recovery][closed-form]") {
  // Two layers one above the other, stretched sideways: the stress along them jumps with E.
  const Element& element = find_element("q4");
  const Mesh mesh = with_region(block_for(element, {2, 2}, 4, 4), "top", {0, 1}, {2, 2});
  const MaterialField material =
      layered(mesh, {100, 0, PlaneState::Stress, 1}, {{"top", {1000, 0, PlaneState::Stress, 1}}});
  const NodeArray u =
      field(mesh, [](const Eigen::Vector2d& x) { return Eigen::Vector2d(0.1 * x.x(), 0); });
  const PrimalAndDuals fields{mesh, element, material, {u, u}};
  const SmoothStress smooth = recovered(fields);
  CHECK(smooth.value.rows() == mesh.n_nodes() + 5);  // the interface has each of its nodes twice
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (Index k = 0; k < 4; ++k)
      CHECK(smooth.value(smooth.cells(cell, k), 0) ==
            Approx(material.number(cell) == 0 ? 10 : 100).epsilon(1e-12));
  CHECK(largest(error_products(fields, smooth)) <= 1e-13);
}

TEST_CASE("a body that is warm and free has no stress to recover", "[recovery][closed-form]") {
  const char* name = GENERATE("q4", "q4_bbar", "q4_incompatible", "q8", "t3", "t6");
  CAPTURE(name);
  const Element& element = find_element(name);
  const Mesh mesh = block_for(element, {2, 1}, 4, 3);
  MaterialField material({100, 0.25, PlaneState::Strain, 1, 1e-2});
  material.eigenstrain = [](const Material& own, const Eigen::Vector2d&) {
    return Eigen::Vector4d(20 * own.expansion, 20 * own.expansion, 0, 20 * own.expansion);
  };
  const double strain = 1.25 * 1e-2 * 20;
  const NodeArray u =
      field(mesh, [&](const Eigen::Vector2d& x) { return Eigen::Vector2d(strain * x); });
  const NodeArray bent = field(mesh, [](const Eigen::Vector2d& x) {
    return Eigen::Vector2d(std::pow(x.x(), 4), x.x() * std::pow(x.y(), 4));
  });
  const PrimalAndDuals fields{mesh, element, material, {u, bent}};
  const SmoothStress smooth = recovered(fields);
  CHECK(largest(smooth.value.leftCols(3)) <= 1e-12 * 100 * strain);
  CHECK(largest(error_products(fields, smooth)) <= 1e-12 * 100 * strain);
}

TEST_CASE("an element is asked for the strains of each cell once", "[recovery]") {
  static int asked;
  asked = 0;
  Element element = find_element("q4_incompatible");
  element.strain = [](const CellBody& cell, StrainPoints& points) {
    ++asked;
    find_element("q4_incompatible").strain(cell, points);
  };
  const Mesh mesh = block_for(element, {2, 1}, 4, 3);
  const MaterialField material({200, 0.3, PlaneState::Strain, 1});
  const NodeArray u = stretched_linearly(mesh);
  const PrimalAndDuals fields{mesh, element, material, {u, u}};
  (void)error_products(fields, recovered(fields));
  CHECK(asked == mesh.n_cells());
}

TEST_CASE("recovery refuses displacements of another mesh", "[recovery]") {
  const Element& element = find_element("q4");
  const Mesh mesh = block_for(element, {2, 1}, 4, 3);
  CHECK_THROWS_AS(recovered({mesh, element, Material{}, {NodeArray::Zero(3, 2)}}),
                  std::invalid_argument);
}
