// Chapter 0 - Plane elasticity by finite elements, with nothing but Eigen.
#pragma once
#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>
#include <map>
#include <vector>

namespace ch00 {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 2>;  // one row each [mm]
using Corners = Eigen::Matrix<double, 4, 2>;              // of a cell, anticlockwise [mm]
using ElementMatrix = Eigen::Matrix<double, 8, 8>;        // x, y of the four corners in turn

// [mesh]
struct Mesh {
  Points nodes;
  Eigen::Matrix<Index, Eigen::Dynamic, 4> cells;  // numbers of the corners, anticlockwise
};

inline Mesh rectangle(double width, double height, Index across, Index up) {
  Mesh mesh{Points((across + 1) * (up + 1), 2), {across * up, 4}};
  for (Index j = 0, node = 0; j <= up; ++j)
    for (Index i = 0; i <= across; ++i, ++node)
      mesh.nodes.row(node) << width * double(i) / double(across), height * double(j) / double(up);
  for (Index j = 0, cell = 0; j < up; ++j)
    for (Index i = 0; i < across; ++i, ++cell) {
      const Index first = j * (across + 1) + i;
      mesh.cells.row(cell) << first, first + 1, first + across + 2, first + across + 1;
    }
  return mesh;
}
// [mesh]

// [shape]
struct Shape {
  Eigen::Vector4d value;  // N of the four corners
  Corners slope;          // dN/dxi, dN/deta
};

inline Shape shape(double xi, double eta) {
  const Eigen::Array4d a(-1, 1, 1, -1), b(-1, -1, 1, 1);  // corner k is at (a_k, b_k)
  Shape at;
  at.value = (1 + a * xi) * (1 + b * eta) / 4;
  at.slope << a * (1 + b * eta) / 4, b * (1 + a * xi) / 4;
  return at;
}
// [shape]

/// \param E  [N/mm^2] \param nu  [-] \return D: (xx, yy, xy) of the stress [N/mm^2] = D (xx, yy, 2 xy) of the strain
inline Matrix3d plane_stress(double E, double nu) {
  Matrix3d D;
  D << 1, nu, 0, /**/ nu, 1, 0, /**/ 0, 0, (1 - nu) / 2;
  return E / (1 - nu * nu) * D;
}

// [strain]
struct Strain {
  Eigen::Matrix<double, 3, 8> B;  // (xx, yy, 2 xy) = B u of the cell [1/mm]
  double area;                    // of the cell, for one of the square [mm^2]
};

inline Strain strain(const Corners& corners, double xi, double eta) {
  const Corners local = shape(xi, eta).slope;
  const Matrix2d J = local.transpose() * corners;         // rows dx/dxi, dx/deta
  const Corners slope = local * J.inverse().transpose();  // dN/dx, dN/dy
  Strain at{Eigen::Matrix<double, 3, 8>::Zero(), J.determinant()};
  for (Index k = 0; k < 4; ++k)
    at.B.middleCols<2>(2 * k) << slope(k, 0), 0, /**/ 0, slope(k, 1), /**/ slope(k, 1), slope(k, 0);
  return at;
}
// [strain]

// [element]
inline ElementMatrix element_stiffness(const Corners& corners, const Matrix3d& D) {
  ElementMatrix K = ElementMatrix::Zero();
  const double g = 1 / std::sqrt(3.0);  // Gauss points: weight 1 each
  for (const double xi : {-g, g})
    for (const double eta : {-g, g}) {
      const Strain at = strain(corners, xi, eta);
      K += at.B.transpose() * D * at.B * at.area;
    }
  return K;
}
// [element]

// [assembly]
inline SparseMatrix assemble(const Mesh& mesh, const Matrix3d& D) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& cell : mesh.cells.rowwise()) {
    const ElementMatrix K = element_stiffness(mesh.nodes(cell, Eigen::all), D);
    for (Index i = 0; i < 8; ++i)
      for (Index j = 0; j < 8; ++j)
        entries.emplace_back(2 * cell(i / 2) + i % 2, 2 * cell(j / 2) + j % 2, K(i, j));
  }
  SparseMatrix K(2 * mesh.nodes.rows(), 2 * mesh.nodes.rows());
  K.setFromTriplets(entries.begin(), entries.end());  // equal places are added up
  return K;
}
// [assembly]

// [solve]
using Held = std::map<Index, double>;  // unknown 2 node + axis, its displacement [mm]
/// \param K  positive definite where nothing holds [N/mm] \param load  [N] \param held  the others are free \return u of all [mm]
inline VectorXd solve(const SparseMatrix& K, const VectorXd& load, const Held& held) {
  VectorXd u = VectorXd::Zero(load.size());
  for (const auto& [unknown, displacement] : held) u(unknown) = displacement;
  std::vector<Eigen::Triplet<double>> ones;  // row k picks the k-th unknown that nothing holds
  for (Index i = 0; i < load.size(); ++i)
    if (held.count(i) == 0) ones.emplace_back(Index(ones.size()), i, 1);
  SparseMatrix pick(Index(ones.size()), load.size());
  pick.setFromTriplets(ones.begin(), ones.end());
  const Eigen::SimplicialLDLT<SparseMatrix> factor(pick * K * pick.transpose());
  return u + pick.transpose() * factor.solve(pick * (load - K * u));
}
// [solve]

/// \param side  its nodes, in walking order \param fx, fy  on a unit of its length [N/mm] \return on all unknowns [N]
// [load]
inline VectorXd side_load(const Mesh& mesh, const std::vector<Index>& side, double fx, double fy) {
  VectorXd load = VectorXd::Zero(2 * mesh.nodes.rows());
  for (std::size_t k = 1; k < side.size(); ++k) {
    const double length = (mesh.nodes.row(side[k]) - mesh.nodes.row(side[k - 1])).norm();
    for (const Index node : {side[k - 1], side[k]})
      load.segment<2>(2 * node) += length / 2 * Eigen::Vector2d(fx, fy);
  }
  return load;
}
// [load]

}  // namespace ch00
