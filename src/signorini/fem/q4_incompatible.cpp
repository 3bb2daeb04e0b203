// # Four nodes that bend
//
// The q4 element lacks the parabola of a bent beam. Wilson added it to each cell as modes of its
// own,
//
// \f[ u = \sum_k N_k\,u_k + (1-\xi^2)\,\alpha_1 + (1-\eta^2)\,\alpha_2, \f]
//
// with two components in each \f$\alpha\f$. The modes are zero at the nodes but not along the
// sides: neighbours gape or overlap there, whence the name *incompatible*. With the strain
// \f$M\alpha\f$ of the modes, energy is least where \f$K_{mm}\alpha = -K_{mu}u\f$. So the
// amplitudes follow from the nodes cell by cell, and no equation outside of the cell contains them
// (*static condensation*):
//
// \f[ \bar B = B - M K_{mm}^{-1} K_{mu}, \qquad
//     \int \bar B^T D \bar B = K_{uu} - K_{um} K_{mm}^{-1} K_{mu}. \f]
//
// A rectangle of any length then bends with the energy of a beam to the last digit: the factor
// \f$1 + a^2/2\f$ of q4.cpp is 1. The number of unknowns is the same.

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>

#include "signorini/fem/elements.hpp"

namespace signorini {
namespace {

/// Numbers of rows are template arguments because these are the innermost loops of an assembly.
template <int n_rows>
using ModeStrain = Eigen::Matrix<double, n_rows, 4>;  // one column per internal unknown

/// Strain of the modes 1 - xi^2 and 1 - eta^2 in x and y at one strain point.
///
/// Taken with the Jacobian of the centre and scaled by its determinant over the local one, so that in the plane the
/// modes do no work against a constant stress: this is what makes the patch test pass on distorted
/// cells (see [TaylorBeresfordWilson1976]).
template <int n_rows>
ModeStrain<n_rows> mode_strain(const CellBody& cell, const StrainPoint& point, double weight,
                               const Jacobian& centre) {
  const Eigen::Vector2d at = point.local;
  double depth = cell.depth.factor;
  CellScalars hoop;
  if constexpr (n_rows == 4) {
    const CellScalars N = bilinear_shape(at.x(), at.y()).value;
    depth = cell.depth_at(N);
    hoop = cell.hoop(1 - at.array().square(), N);
  }
  const double scale = centre.determinant * depth / (point.volume / weight);
  CellNodes slope(2, 2);
  slope << -2 * at.x(), 0, 0, -2 * at.y();
  const Eigen::Matrix2d gradient = scale * slope * centre.matrix.inverse().transpose();
  StrainMatrix strain;
  write_strain_matrix(gradient, hoop, strain);
  return fixed_rows<n_rows>(strain);
}

/// Takes its mean from the strain of every mode: where volumes grow with the radius, and with the hoop strain, it is
/// not zero by itself. Without it a body of revolution can be strained evenly at will.
void subtract_mean(const StrainPoints& points, std::array<ModeStrain<4>, 4>& modes) {
  ModeStrain<4> mean = ModeStrain<4>::Zero();
  double volume = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    mean += points.point[i].volume * modes[i];
    volume += points.point[i].volume;
  }
  for (ModeStrain<4>& mode : modes) mode -= mean / volume;
}

/// The strains of the modes at the strain points.
template <int n_rows>
std::array<ModeStrain<n_rows>, 4> mode_strains(const CellBody& cell, const StrainPoints& points) {
  const Jacobian centre = jacobian(bilinear_shape(0, 0), cell.arms);
  std::array<ModeStrain<n_rows>, 4> modes;
  for (std::size_t i = 0; i < 4; ++i)
    modes[i] = mode_strain<n_rows>(cell, points.point[i], gauss_square(2)[i].weight, centre);
  if constexpr (n_rows == 4) subtract_mean(points, modes);
  return modes;
}

/// Takes out of strains what the modes take over: the amplitudes \f$\alpha\f$ with
/// \f$K_{mm}\alpha = \int M^T D\,\epsilon\f$ leave \f$\epsilon - M\alpha\f$. strain(i) is a block of
/// columns at the strain point i.
template <int n_rows, int n_columns, typename Strain>
void take_out_modes(const CellBody& cell, const StrainPoints& points, Strain&& strain) {
  const auto& D = fixed_rows<n_rows>(cell.D);
  const std::array<ModeStrain<n_rows>, 4> modes = mode_strains<n_rows>(cell, points);
  Eigen::Matrix<double, 4, 4> K_modes = Eigen::Matrix<double, 4, 4>::Zero();
  Eigen::Matrix<double, 4, n_columns> load = Eigen::Matrix<double, 4, n_columns>::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Matrix<double, 4, n_rows> stress =
        points.point[i].volume * modes[i].transpose() * D;
    K_modes += stress * modes[i];
    load += stress * strain(i);
  }
  const Eigen::Matrix<double, 4, n_columns> amplitudes = K_modes.ldlt().solve(load);
  for (std::size_t i = 0; i < 4; ++i) strain(i) -= modes[i] * amplitudes;
}

/// Condensation, at the strain points: the modes carry no load, so they follow the nodes. Since
/// \f$\bar B\f$ is stored in the place of \f$B\f$, stiffness and stress need not know that there are modes.
void incompatible_strain(const CellBody& cell, StrainPoints& points) {
  sample_strain(bilinear_shape, gauss_square(2), cell, points);
  with_rows(cell.D.rows(), [&](auto n_rows) {
    take_out_modes<n_rows, 8>(cell, points, [&](std::size_t i) {
      return Eigen::Map<Eigen::Matrix<double, n_rows, 8>>(points.point[i].B.data());
    });
  });
}

/// An eigenstrain \f$\epsilon_0\f$ that varies in the cell moves the modes although no node moves. What
/// they leave of it causes stress. For a uniform one the right side is \f$(\int M)^T D\,\epsilon_0 = 0\f$.
void relax(const CellBody& cell, const StrainPoints& points, PointStrains& strains) {
  with_rows(cell.D.rows(), [&](auto n_rows) {
    take_out_modes<n_rows, 1>(cell, points, [&](std::size_t i) {
      return Eigen::Map<Eigen::Matrix<double, n_rows, 1>>(
          strains.col(static_cast<Eigen::Index>(i)).data());
    });
  });
}

}  // namespace

Element q4_incompatible() {
  return {"q4_incompatible",
          "4 nodes, four incompatible modes",
          4,
          1,
          bilinear_shape,
          incompatible_strain,
          relax};
}

}  // namespace signorini
