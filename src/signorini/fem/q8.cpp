// # The quadrilateral with eight nodes
//
// Midpoints of the sides join the corners, and sides may be parabolas. In each direction the
// displacement has the eight terms
// \f$1, \xi, \eta, \xi^2, \xi\eta, \eta^2, \xi^2\eta, \xi\eta^2\f$: all of degree 2, which is what
// bending needs, and no node in the middle of the cell. At the centre each corner counts
// \f$-1/4\f$ and each midpoint \f$1/2\f$; together that is 1.
//
// A uniform pressure on a side acts on its three nodes as 1/6, 4/6 and 1/6. So a nodal force does
// not measure the pressure; divided by the share of its node in the surface it does.
//
// The rule has 3 x 3 points. Many programs take 2 x 2, which is softer and cheaper. Then four
// points with three strains each watch 16 - 3 = 13 ways to deform, so that one of them costs no
// energy.

#include "signorini/fem/elements.hpp"

namespace signorini {
namespace {

Shape serendipity_shape(double xi, double eta) {
  Shape shape;
  shape.value.resize(8);
  shape.slope.resize(8, 2);
  for (int k = 0; k < 4; ++k) {
    const double a = k == 1 || k == 2 ? 1 : -1;
    const double b = k >= 2 ? 1 : -1;
    shape.value(k) = 0.25 * (1 + a * xi) * (1 + b * eta) * (a * xi + b * eta - 1);
    shape.slope(k, 0) = 0.25 * a * (1 + b * eta) * (2 * a * xi + b * eta);
    shape.slope(k, 1) = 0.25 * b * (1 + a * xi) * (a * xi + 2 * b * eta);
  }
  for (const int s : {0, 2}) {  // midpoints of the sides eta = -1 and eta = 1
    const double b = s == 0 ? -1 : 1;
    shape.value(4 + s) = 0.5 * (1 - xi * xi) * (1 + b * eta);
    shape.slope(4 + s, 0) = -xi * (1 + b * eta);
    shape.slope(4 + s, 1) = 0.5 * b * (1 - xi * xi);
  }
  for (const int s : {1, 3}) {  // midpoints of the sides xi = 1 and xi = -1
    const double a = s == 1 ? 1 : -1;
    shape.value(4 + s) = 0.5 * (1 + a * xi) * (1 - eta * eta);
    shape.slope(4 + s, 0) = 0.5 * a * (1 - eta * eta);
    shape.slope(4 + s, 1) = -eta * (1 + a * xi);
  }
  return shape;
}

void serendipity_strain(const CellBody& cell, StrainPoints& points) {
  sample_strain(serendipity_shape, gauss_square(3), cell, points);
}

}  // namespace

Element q8() {
  return {
      "q8", "8 nodes, quadratic, full integration", 8, 2, serendipity_shape, serendipity_strain};
}

}  // namespace signorini
