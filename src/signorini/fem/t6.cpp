// # The triangle with six nodes
//
// With the area coordinates \f$a_1 = 1-\xi-\eta\f$, \f$a_2 = \xi\f$, \f$a_3 = \eta\f$ the corners
// have \f$N = a(2a-1)\f$ and the midpoints \f$N = 4\,a\,a'\f$ of their two ends. In the centre of
// gravity a corner counts \f$-1/9\f$ and a midpoint \f$4/9\f$.
//
// The integral of a corner's function over a straight triangle is 0, that of a midpoint a third of
// the area. So the nodal forces of a weight are all at midpoints. That looks wrong and is
// consistent: these forces do the work of the weight on every parabola that the cell can take.

#include "signorini/fem/elements.hpp"

namespace signorini {
namespace {

Shape quadratic_shape(double xi, double eta) {
  const double at[] = {1 - xi - eta, xi, eta};  // area coordinates
  const double slope[][2] = {{-1, -1}, {1, 0}, {0, 1}};
  Shape shape;
  shape.value.resize(6);
  shape.slope.resize(6, 2);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    shape.value(k) = at[k] * (2 * at[k] - 1);
    shape.value(3 + k) = 4 * at[k] * at[next];
    for (int axis = 0; axis < 2; ++axis) {
      shape.slope(k, axis) = (4 * at[k] - 1) * slope[k][axis];
      shape.slope(3 + k, axis) = 4 * (at[k] * slope[next][axis] + at[next] * slope[k][axis]);
    }
  }
  return shape;
}

/// Degree 4: with it a uniform stress does what it should to the nodes of curved cells in axial symmetry as well,
/// where the nodal forces are of degree 2 in the shape functions and of degree 2 in the radius. In the plane three
/// points would do as much on straight sides.
void quadratic_strain(const CellBody& cell, StrainPoints& points) {
  sample_strain(quadratic_shape, gauss_triangle(6), cell, points);
}

}  // namespace

Element t6() {
  return {"t6", "6 nodes, quadratic, full integration", 6, 2, quadratic_shape, quadratic_strain};
}

}  // namespace signorini
