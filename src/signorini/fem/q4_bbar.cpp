// # Four nodes that keep their volume
//
// As \f$\nu\f$ approaches 1/2, the modulus of volume grows like \f$1/(1-2\nu)\f$, and a body can
// only move so that \f$\varepsilon_{xx} + \varepsilon_{yy} \approx 0\f$. The q4 element must obey
// at each of its four points. A large mesh has one node per cell, hence two unknowns: four
// conditions for two unknowns leave nothing that could move, and the mesh *locks*. The square
// \f$[-1,1]^2\f$ with \f$E = 1\f$, thickness 1, in plane strain, moved by \f$u_x = xy\f$, stores
// this energy:
//
// - q4: 1.15 at \f$\nu = 0.3\f$, 11.6 at 0.49, 1112 at 0.4999;
// - q4_bbar: 0.51, 0.45 and 0.44.
//
// Volume is averaged over the cell here: one condition for two unknowns, as for an incompressible
// continuum. Mixed methods with one constant pressure per cell do nearly the same. Shear is not
// averaged, so that slender cells still lock in bending.

#include "signorini/fem/elements.hpp"

namespace signorini {
namespace {

/// Replaces the volumetric strain by its mean over the cell (see [Hughes1980]).
///
/// What the change of area xx + yy, with the hoop strain of volume, lacks to its mean is split between xx and yy, so
/// that the same operator serves plane stress, plane strain, and bodies of revolution, which far from their axis are
/// in plane strain.
void averaged_strain(const CellBody& cell, StrainPoints& points) {
  sample_strain(bilinear_shape, gauss_square(2), cell, points);
  const bool axial = cell.D.rows() == 4;
  Eigen::Matrix<double, 1, 8> mean = Eigen::Matrix<double, 1, 8>::Zero();
  double volume = 0;
  for (int i = 0; i < points.size; ++i) {
    const StrainPoint& point = points.point[static_cast<std::size_t>(i)];
    mean += point.volume * (point.B.row(0) + point.B.row(1));
    if (axial) mean += point.volume * point.B.row(3);
    volume += point.volume;
  }
  mean /= volume;
  for (int i = 0; i < points.size; ++i) {
    StrainMatrix& B = points.point[static_cast<std::size_t>(i)].B;
    Eigen::Matrix<double, 1, 8> shift = mean - B.row(0) - B.row(1);
    if (axial) shift -= B.row(3);
    B.row(0) += 0.5 * shift;
    B.row(1) += 0.5 * shift;
  }
}

}  // namespace

Element q4_bbar() {
  return {"q4_bbar", "4 nodes, mean volumetric strain", 4, 1, bilinear_shape, averaged_strain, nullptr, true};
}

}  // namespace signorini
