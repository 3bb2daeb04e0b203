// The orders with which errors of Hertz's contact fall, against what the regularity at the end of contact allows.
#include "../chapters/ch11_hertz/half_plane.hpp"
#include "catch_compat.hpp"

using namespace signorini;

namespace {

// Root mean squares over two places where the contact ends in its edge.
OrderErrors mean_errors(const std::string& element, double edges) {
  const OrderErrors a = order_errors(element, edges + 0.25), b = order_errors(element, edges + 0.75);
  return {std::hypot(a.energy, b.energy) / std::sqrt(2), std::hypot(a.pressure, b.pressure) / std::sqrt(2),
          std::hypot(a.half_width, b.half_width) / std::sqrt(2)};
}

}  // namespace

// At the distance r from the end of contact displacements are smooth but for r^(3/2), and the pressure is like r^(1/2). So
// elements of degree p converge in energy with min(p, 3/2), pressures in L2 with 1, and b, which depends on products of two
// errors, with 2. Neighbouring orders are 1/2 apart, so an order counts as met if it is nearer than 1/4 to it. Observed orders
// are up to 0.2 too low, since terms of the next order are not gone on 8 to 32 edges, and b on linear elements has h^2 log(1/h).
TEST_CASE("Hertz: errors fall with the orders that the end of contact allows", "[hertz][orders]") {
  const std::string element = GENERATE("q4", "q4_incompatible", "t3", "q8", "t6");
  const std::vector<double> edges = {8, 16, 32};
  std::vector<OrderErrors> errors;
  for (const double on_b : edges) errors.push_back(mean_errors(element, on_b));
  const double degree = find_element(element).degree;
  CAPTURE(element);
  CHECK(std::abs(slope(edges, errors, &OrderErrors::energy) - std::min(degree, 1.5)) < 0.25);
  CHECK(std::abs(slope(edges, errors, &OrderErrors::pressure) - 1) < 0.25);
  CHECK(std::abs(slope(edges, errors, &OrderErrors::half_width) - 2) < 0.25);
}

// Exact: stresses on the cuts carry the load that Hertz's pressure brings in, whatever the mesh; three Gauss points on an edge
// integrate them to 1e-6 and better.
TEST_CASE("Hertz: the square cut out of the half-plane is in balance", "[hertz][orders]") {
  const SolvedScene run = solved(parabola_on_square("q8", GENERATE(4.5, 8.25)), "the parabola");
  CHECK(boundary_forces(run, {"top"}).force.col(1).sum() == Approx(-parabola.force / 2).epsilon(1e-5));
}
