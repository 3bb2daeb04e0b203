#include "signorini/elasticity/elements.hpp"

namespace signorini {
namespace {

/// Replaces the volumetric strain by its mean over the cell (see [Hughes1980]).
///
/// The change of area tr = xx + yy of the plane is split off with the factor 1/2, so that the same
/// operator serves plane stress and plane strain.
void averaged_strain(const CellBody& cell, StrainPoints& points) {
  sample_strain(bilinear_shape, gauss_square(2), cell, points);
  Eigen::Matrix<double, 1, 8> mean = Eigen::Matrix<double, 1, 8>::Zero();
  double volume = 0;
  for (int i = 0; i < points.size; ++i) {
    const StrainPoint& point = points.point[static_cast<std::size_t>(i)];
    mean += point.volume * (point.B.row(0) + point.B.row(1));
    volume += point.volume;
  }
  mean /= volume;
  for (int i = 0; i < points.size; ++i) {
    StrainMatrix& B = points.point[static_cast<std::size_t>(i)].B;
    const Eigen::Matrix<double, 1, 8> shift = 0.5 * (mean - B.row(0) - B.row(1));
    B.row(0) += shift;
    B.row(1) += shift;
  }
}

}  // namespace

Element q4_bbar() {
  return {"q4_bbar", "4 nodes, mean volumetric strain", 4, 1, bilinear_shape, averaged_strain};
}

}  // namespace signorini
