// # The bilinear quadrilateral
//
// Four nodes, and in each direction the displacement \f$a + b\,\xi + c\,\eta + d\,\xi\eta\f$:
// complete to degree 1, and continuous from cell to cell because it is linear along each side. The
// stiffness of the unit square with \f$E = 1\f$, \f$\nu = 0\f$ and thickness 1 can be computed by
// hand. Its first row, which is the force \f$x\f$ on the first node for unit displacements
// \f$x, y\f$ of the four nodes, is
//
// \f[ \tfrac{1}{24}\,(12,\; 3,\; -6,\; -3,\; -6,\; -3,\; 0,\; 3). \f]
//
// The entries of \f$x\f$ add up to 0, and so do those of \f$y\f$: a translation costs nothing.
//
// The element fails in bending. A beam that bends has \f$u_x = xy\f$ and \f$u_y = -x^2/2\f$. This
// cell has \f$xy\f$, but not \f$x^2\f$, so it shears by \f$\gamma = x\f$ where the beam does not.
// In a cell that is \f$a\f$ times as long as high the false energy makes it \f$1 + a^2/2\f$ times
// too stiff (for \f$\nu = 0\f$): 1.5 for a square, 9 for \f$a = 4\f$. Finer cells heal it, but
// slowly; q4_incompatible.cpp adds what is missing.

#include "signorini/fem/elements.hpp"

namespace signorini {

Shape bilinear_shape(double xi, double eta) {
  Shape shape;
  shape.value.resize(4);
  shape.slope.resize(4, 2);
  for (int k = 0; k < 4; ++k) {
    const double a = k == 1 || k == 2 ? 1 : -1;  // corner k is at (a, b)
    const double b = k >= 2 ? 1 : -1;
    shape.value(k) = 0.25 * (1 + a * xi) * (1 + b * eta);
    shape.slope(k, 0) = 0.25 * a * (1 + b * eta);
    shape.slope(k, 1) = 0.25 * b * (1 + a * xi);
  }
  return shape;
}

Element q4() {
  return {"q4",
          "4 nodes, full integration",
          4,
          1,
          bilinear_shape,
          [](const CellBody& cell, StrainPoints& points) {
            sample_strain(bilinear_shape, gauss_square(2), cell, points);
          }};
}

}  // namespace signorini
