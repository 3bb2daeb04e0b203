// Chapter 19 - The block of chapter 1, and what each method needs to know of it.
#pragma once
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <array>
#include <vector>

#include "signorini/fem/assembly.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/elements.hpp"

namespace ch19 {

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Vector8d = Eigen::Matrix<double, 8, 1>;

const double width = 40, height = 20, pushed = 1;    // [mm]
const Material rubber{10, 0.3, PlaneState::Strain};  // E [N/mm^2], nu; 1 mm thick

/// The block, as seen from the place to which its top carries it: there it has no stress, and overlaps the obstacle.
struct Pressed {
  Mesh mesh;
  Unknowns unknowns;
  SparseMatrix K;              // [N/mm]
  std::vector<Index> up;       // the unknown of each node of the base that opens its gap
  VectorXd free_gap;           // of these nodes [mm]
  VectorXd weight;             // their shares of the base [mm^2]
  double (*gap_at)(double x);  // free gap at any place of the base [mm]
  double unit;  // E over the size of a cell, in which all parameters are given [N/mm^3]
};

inline double round_gap(double x) { return x * x / (2 * 60.0) - pushed; }  // R = 60 mm
inline double flat_gap(double) { return 0.25 - pushed; }

inline Pressed pressed(Index up, double (*gap_at)(double), const std::vector<Support>& supports) {
  Pressed now{block("block", {-width / 2, 0}, {width, height}, 2 * up, up),
              {},
              {},
              {},
              {},
              {},
              gap_at,
              rubber.youngs_modulus * double(up) / height};
  now.unknowns = number_unknowns(now.mesh, supports);
  now.K = assemble(now.mesh, q4(), rubber, now.unknowns, {}).stiffness;
  const std::vector<Index> base = boundary_nodes(now.mesh, "bottom");
  now.free_gap.resize(Index(base.size()));
  for (std::size_t i = 0; i < base.size(); ++i) {
    now.up.push_back(now.unknowns.number(base[i], 1));
    now.free_gap(Index(i)) = gap_at(now.mesh.nodes(base[i], 0));
  }
  now.weight = boundary_weights(now.mesh, "bottom", depth_of(rubber));
  return now;
}

/// On a round obstacle, the top glued to a plate.
inline Pressed on_round(Index up) { return pressed(up, round_gap, {fixed("top")}); }

/// On a flat one, 0.25 mm below, free to widen: its stress is uniform.
inline Pressed on_flat(Index up) {
  return pressed(up, flat_gap,
                 {prescribed("top", Axis::Y, 0.0), prescribed_at("top", {0, height}, Axis::X)});
}

/// What the nodes of the base do: their openings.
inline VectorXd opening(const Pressed& block, const VectorXd& u) { return u(block.up); }

/// Forces on the nodes of the base, upwards, as a load.
inline VectorXd on_base(const Pressed& block, const VectorXd& force) {
  VectorXd load = VectorXd::Zero(block.K.rows());
  load(block.up) = force;
  return load;
}

/// The compliance of the pairs, for methods that need no displacements.
inline MatrixXd compliance(const Pressed& block) {
  const Eigen::SimplicialLDLT<SparseMatrix> factor(block.K);
  MatrixXd G(block.free_gap.size(), block.free_gap.size());
  for (Index i = 0; i < G.cols(); ++i)
    G.col(i) = opening(block, factor.solve(on_base(block, VectorXd::Unit(G.rows(), i))));
  return G;
}

/// A Gauss point of the base: pressure and opening there are products with the displacements of its cell.
struct SidePoint {
  std::array<Index, 8> unknown;  // of the cell, -1 if held
  Vector8d pressure;  // of the body on its base, compression > 0, per displacement [N/mm^3]
  Vector8d opening;   // [-]
  double free_gap;    // [mm]
  double weight;      // length times thickness [mm^2]
  Index cell;
};

inline SidePoint side_point(const Pressed& block, Index cell, const GaussPoint& gauss) {
  SidePoint at{};
  const CellNodes corners = cell_nodes(block.mesh, cell);
  at.opening.setZero();
  const Shape shape = bilinear_shape(gauss.xi, -1);  // the side from corner 0 to corner 1
  StrainMatrix B;
  write_strain_matrix(jacobian(shape, corners).gradient, {}, B);
  at.pressure = -(elasticity_matrix(rubber) * B).row(1).transpose();  // minus sigma_yy
  for (Index k = 0; k < 4; ++k) {
    at.opening(2 * k + 1) = shape.value(k);
    for (Index axis = 0; axis < 2; ++axis)
      at.unknown[std::size_t(2 * k + axis)] =
          block.unknowns.number(block.mesh.cells(cell, k), axis);
  }
  at.free_gap = block.gap_at(shape.value.dot(corners.col(0)));
  at.weight = gauss.weight * (corners(1, 0) - corners(0, 0)) / 2 * rubber.thickness;
  at.cell = cell;
  return at;
}

inline std::vector<SidePoint> side_points(const Pressed& block) {
  std::vector<SidePoint> points;
  for (const CellSide& side : block.mesh.boundaries.at("bottom"))
    for (const GaussPoint& gauss : gauss_line(2))
      points.push_back(side_point(block, side.cell, gauss));
  return points;
}

/// The displacements of a point's cell.
inline Vector8d of_cell(const SidePoint& at, const VectorXd& u) {
  Vector8d values = Vector8d::Zero();
  for (Index i = 0; i < 8; ++i)
    if (at.unknown[std::size_t(i)] >= 0) values(i) = u(at.unknown[std::size_t(i)]);
  return values;
}

/// Adds the amount times row row^T to a matrix.
inline void add_square(SparseMatrix& K, const SidePoint& at, const Vector8d& row, double amount) {
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < 8; ++j)
      if (at.unknown[i] >= 0 && at.unknown[j] >= 0)
        K.coeffRef(at.unknown[i], at.unknown[j]) += amount * row(Index(i)) * row(Index(j));
}

/// The inverse inequality of one cell of the base: the least c with  int q^2 <= c int sigma : epsilon.
inline double inverse_inequality(const Pressed& block) {
  const Mesh& mesh = block.mesh;
  const Index cell = mesh.boundaries.at("bottom").front().cell;
  MatrixXd side = MatrixXd::Zero(8, 8);
  for (const SidePoint& at : side_points(block))
    if (at.cell == cell) side += at.weight * at.pressure * at.pressure.transpose();
  const MatrixXd K = cell_stiffness(
      q4(), cell_body(cell_nodes(mesh, cell), elasticity_matrix(rubber), depth_of(rubber)));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(K);  // the first three cost no energy
  const MatrixXd basis = modes.eigenvectors().rightCols(5) *
                         modes.eigenvalues().tail(5).cwiseSqrt().cwiseInverse().asDiagonal();
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(basis.transpose() * side * basis)
      .eigenvalues()
      .maxCoeff();
}

}  // namespace ch19
