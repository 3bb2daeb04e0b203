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
