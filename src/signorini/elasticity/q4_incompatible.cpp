#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>

#include "signorini/elasticity/elements.hpp"

namespace signorini {
namespace {

using ModeStrain = Eigen::Matrix<double, 3, 4>;  // one column per internal unknown

/// Strain of the modes 1 - xi^2 and 1 - eta^2 in x and y.
///
/// Taken with the Jacobian of the centre and scaled by its determinant over the local one, so that the
/// modes do no work against a constant stress: this is what makes the patch test pass on distorted
/// cells (see [TaylorBeresfordWilson1976]).
ModeStrain mode_strain(const GaussPoint& gauss, double determinant, const Jacobian& centre) {
  CellNodes slope(2, 2);
  slope << -2 * gauss.xi, 0, 0, -2 * gauss.eta;
  const Eigen::Matrix2d gradient =
      centre.determinant / determinant * slope * centre.matrix.inverse().transpose();
  return strain_matrix(CellNodes(gradient));
}

void incompatible_strain(const CellNodes& nodes, const Eigen::Matrix3d& D, StrainPoints& points) {
  sample_strain(bilinear_shape, gauss_square(2), nodes, points);
  const Jacobian centre = jacobian(bilinear_shape(0, 0), nodes);
  Eigen::Matrix<double, 4, 4> K_modes = Eigen::Matrix<double, 4, 4>::Zero();
  Eigen::Matrix<double, 4, 8> K_mixed = Eigen::Matrix<double, 4, 8>::Zero();
  std::array<ModeStrain, 4> modes;
  for (std::size_t i = 0; i < 4; ++i) {
    const GaussPoint& gauss = gauss_square(2)[i];
    const StrainPoint& point = points.point[i];
    modes[i] = mode_strain(gauss, point.area / gauss.weight, centre);
    const Eigen::Matrix<double, 4, 3> stress = point.area * modes[i].transpose() * D;
    K_modes += stress * modes[i];
    K_mixed += stress * point.B;
  }
  // The modes carry no load, so they follow the nodes: amplitudes = -K_modes^-1 K_mixed u.
  const Eigen::Matrix<double, 4, 8> amplitudes = -K_modes.ldlt().solve(K_mixed);
  for (std::size_t i = 0; i < 4; ++i) points.point[i].B += modes[i] * amplitudes;
}

}  // namespace

Element q4_incompatible() {
  return {"q4_incompatible",  "4 nodes, four incompatible modes", 4, 1, bilinear_shape,
          incompatible_strain};
}

}  // namespace signorini
