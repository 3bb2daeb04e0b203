// A Signorini problem built backwards from its solution: the free boundary lies inside a cell.
#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/scene.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

namespace {

// Unit square, plane strain, lambda = mu = 1. The base lies on the obstacle for x < edge with the pressure
// 4 m^3, m = max(0, edge - x), and stands off by max(0, x - edge)^2 beyond.
constexpr double edge = 0.45;
constexpr double slope = 0.02;
constexpr double k = 4;

double inside(double x) { return std::max(0.0, edge - x); }
double sunk(double x) { return -slope * (1 + x * x); }
double exact_pressure(double x) { return k * std::pow(inside(x), 3); }
Vector2d exact_displacement(const Vector2d& x) {
  return {2 * slope * x.x() * x.y(), sunk(x.x()) - x.y() * k / 3 * std::pow(inside(x.x()), 3)};
}
Vector2d body_force(const Vector2d& x) {
  const double m = inside(x.x());
  return {-2 * k * m * m, 2 * k * x.y() * m - 2 * slope};
}

struct Errors {
  double displacement;  ///< L2 norm over the square, from the nodes
  double pressure;      ///< L2 norm over the base, from the nodes
  Index wrong_pairs;    ///< pairs closed beyond the edge by more than a cell, or open before it
};

Errors errors_of(const char* element, Index n) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {1, 1}, n, n,
                    std::string(element) == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear);
  body.element = element;
  body.material = {2.5, 0.25, PlaneState::Strain, 1};
  for (const char* side : {"right", "top", "left"})
    body.supports.push_back({side, true, true, exact_displacement, false});
  body.loads.body_force = body_force;
  const auto ground = [](double x) {
    return sunk(x) - std::pow(std::max(0.0, x - edge), 2);  // its normal stays vertical
  };
  scene.contacts = {{{"bottom"}, profile(ground, [](double) { return 0.0; })}};
  const Solution solution = solve(scene);
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  CHECK(solution.certificate.holds());

  Errors errors{0, 0, 0};
  for (Index node = 0; node < body.mesh.n_nodes(); ++node) {
    const Vector2d exact = exact_displacement(body.mesh.nodes.row(node).transpose());
    errors.displacement += (solution.displacements[0].row(node).transpose() - exact).squaredNorm();
  }
  errors.displacement = std::sqrt(errors.displacement / static_cast<double>(body.mesh.n_nodes()));
  const Pairs pairs = plan(scene).gaps.pairs;
  const double h = 1 / static_cast<double>(n);
  for (Index pair = 0; pair < solution.pressure.size(); ++pair) {
    const double x = pairs.position(pair, 0);
    errors.pressure +=
        pairs.weight(pair) * std::pow(solution.pressure(pair) - exact_pressure(x), 2);
    const bool closed = solution.contact.contact_status[std::size_t(pair)] != ContactStatus::Open;
    if ((closed && x > edge + 3 * h) || (!closed && x < edge - 3 * h)) ++errors.wrong_pairs;
  }
  errors.pressure = std::sqrt(errors.pressure);
  return errors;
}

}  // namespace

TEST_CASE("displacements and pressure converge to a manufactured Signorini solution with order 2",
          "[manufactured][rate]") {
  const Errors coarse = errors_of("q4", 16);
  const Errors fine =
      errors_of("q4", 64);  // two halvings: the edge lies elsewhere in its cell each time
  CAPTURE(coarse.displacement, fine.displacement, coarse.pressure, fine.pressure);
  CHECK(0.5 * std::log2(coarse.displacement / fine.displacement) == Approx(2).margin(0.15));
  CHECK(0.5 * std::log2(coarse.pressure / fine.pressure) == Approx(2).margin(0.3));
  CHECK(coarse.wrong_pairs == 0);
  CHECK(fine.wrong_pairs == 0);
}

TEST_CASE("every element closes the right part of the base", "[manufactured]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible", "q8"}) {
    const Errors errors = errors_of(element, 24);
    CAPTURE(element, errors.displacement, errors.pressure);
    CHECK(errors.displacement < 1e-4);
    CHECK(errors.pressure < 0.01);
    CHECK(errors.wrong_pairs == 0);
  }
}
