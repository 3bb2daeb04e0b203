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
