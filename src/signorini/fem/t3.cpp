// # The triangle with three nodes
//
// Displacements are linear, \f$N = (1-\xi-\eta,\ \xi,\ \eta)\f$, so that the strain is constant
// and \f$K = A\,t\,B^T D B\f$ with the area \f$A\f$. For the half of the unit square, \f$E = 1\f$,
// \f$\nu = 0\f$ and thickness 1, the first row of \f$K\f$ is
// \f$\tfrac14(3,\ 1,\ -2,\ -1,\ -1,\ 0)\f$.
//
// It is the oldest element, and any domain can be cut into triangles. It is too stiff in bending,
// as q4 is. It locks near incompressibility, because a quadrilateral cut in two has two conditions
// on its volume for two unknowns.

#include "signorini/fem/elements.hpp"

namespace signorini {
namespace {

Shape linear_shape(double xi, double eta) {
  Shape shape;
  shape.value.resize(3);
  shape.slope.resize(3, 2);
  shape.value << 1 - xi - eta, xi, eta;
  shape.slope << -1, -1, 1, 0, 0, 1;
  return shape;
}

/// Three points, though in the plane the strain is the same everywhere: the hoop strain of axial symmetry is not, and
/// neither is a body force.
void constant_strain(const CellBody& cell, StrainPoints& points) {
  sample_strain(linear_shape, gauss_triangle(3), cell, points);
}

}  // namespace

Element t3() {
  return {"t3", "3 nodes, constant strain in the plane", 3, 1, linear_shape, constant_strain};
}

}  // namespace signorini
