#include <cmath>

#include "catch_compat.hpp"
#include "signorini/fem/elements.hpp"
#include "support/linear_solve.hpp"
#include "support/meshes.hpp"
#include "support/message.hpp"

using Eigen::Vector2d;
using namespace signorini;
using signorini_test::block_for;
using signorini_test::solve_body;

TEST_CASE("the Gauss rules are exact up to their degree", "[element]") {
  for (int n = 1; n <= 16; ++n)
    for (int power = 0; power <= 2 * n - 1; ++power) {
      CAPTURE(n, power);
      double sum = 0;
      for (const GaussPoint& point : gauss_line(n)) sum += point.weight * std::pow(point.xi, power);
      CHECK(sum == Approx(power % 2 == 0 ? 2.0 / (power + 1) : 0).epsilon(1e-14).margin(1e-15));
    }
  for (int n = 2; n <= 3; ++n) {
    double sum = 0;
    for (const GaussPoint& point : gauss_square(n))
      sum += point.weight * std::pow(point.xi, 2) * std::pow(point.eta, 2);
    CHECK(sum == Approx(4.0 / 9.0).epsilon(1e-14).margin(0));
  }
  CHECK_THROWS_AS(gauss_line(17), std::invalid_argument);
  CHECK_THROWS_AS(gauss_square(1), std::invalid_argument);
}

TEST_CASE("an element is found by its name, an unknown one is answered with the family",
          "[element]") {
  CHECK(find_element("q8").n_nodes == 8);
  CHECK_THAT(signorini_test::problem_message([] { static_cast<void>(find_element("q5")); }),
             ContainsSubstring("unknown element 'q5'") &&
                 ContainsSubstring("q4, q4_bbar, q4_incompatible, q8, t3, t6"));
}

namespace {

/// Largest error of the displacement of a strip in pure bending over the largest displacement.
///
/// sigma_xx = -E' k y: u = (-k x y, k (x^2 + nu' y^2) / 2), with E' = E, nu' = nu in plane stress.
double bending_error(const Element& element, PlaneState state, Eigen::Index layers) {
  const double curvature = 1e-3;
  const double E = 1000;
  const double nu = 0.3;
  const bool stress = state == PlaneState::Stress;
  const double E_plane = stress ? E : E / (1 - nu * nu);
  const double nu_plane = stress ? nu : nu / (1 - nu);
  const VectorField exact = [=](const Vector2d& x) {
    return Vector2d(-curvature * x.x() * x.y(),
                    curvature * (x.x() * x.x() + nu_plane * x.y() * x.y()) / 2);
  };
  const Mesh mesh = mapped(block_for(element, {20, 2}, 5, layers),
                           [](const Vector2d& x) { return Vector2d(x.x(), x.y() - 1); });
  Loads loads;
  loads.edges.push_back(
      {"right", 0, [=](const Vector2d& x) { return Vector2d(-E_plane * curvature * x.y(), 0); }});
  const NodeArray u =
      solve_body(mesh, element, {E, nu, state, 1}, {{"left", true, true, exact, false}}, loads);
  double error = 0;
  for (Eigen::Index node = 0; node < mesh.n_nodes(); ++node)
    error =
        std::max(error, (u.row(node).transpose() - exact(mesh.nodes.row(node).transpose())).norm());
  return error / (curvature * 20 * 20 / 2);
}

}  // namespace

// Closed form: pure bending of a strip by a linear end traction.
TEST_CASE("one layer of q4_incompatible, q8 or t6 bends a strip exactly, q4 and t3 do not",
          "[element][closed-form]") {
  for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain}) {
    CHECK(bending_error(q4_incompatible(), state, 1) < 1e-10);  // rounding times condition number
    CHECK(bending_error(q8(), state, 1) < 1e-10);
    CHECK(bending_error(t6(), state, 1) < 1e-10);
    CHECK(bending_error(q4(), state, 1) > 0.5);
    CHECK(bending_error(t3(), state, 1) > 0.5);
  }
}

namespace {

/// Error of the displacement of the inner wall of a thick cylinder under inner pressure, relative.
double cylinder_error(const Element& element, double nu, Eigen::Index layers,
                      Eigen::Index sectors) {
  const double inner = 3;
  const double outer = 9;
  const double right_angle = std::acos(0.0);
  const Mesh mesh = mapped(
      block_for(element, {outer - inner, right_angle}, layers, sectors), [=](const Vector2d& x) {
        const bool upright = x.y() == right_angle;
        const Vector2d direction =
            upright ? Vector2d(0, 1) : Vector2d(std::cos(x.y()), std::sin(x.y()));
        return Vector2d((inner + x.x()) * direction);
      });
  Loads loads;
  loads.edges.push_back({"left", 1, {}});
  const NodeArray u = solve_body(mesh, element, {1000, nu, PlaneState::Strain, 1},
                                 {symmetric("bottom"), symmetric("top")}, loads);
  const double exact = (1 + nu) / 1000 * inner * inner / (outer * outer - inner * inner) *
                       ((1 - 2 * nu) * inner + outer * outer / inner);
  return u(boundary_nodes(mesh, "left").back(), 0) / exact - 1;
}

}  // namespace

// Closed form: Lame's thick cylinder in plane strain.
TEST_CASE("mean dilatation does not lock near incompressibility where the plain element does",
          "[element][closed-form]") {
  CHECK(std::abs(cylinder_error(q4_bbar(), 0.4999, 10, 18)) < 0.02);  // chords of 5 degrees
  CHECK(std::abs(cylinder_error(q4_bbar(), 0.3, 10, 18)) < 0.02);
  CHECK(std::abs(cylinder_error(q4(), 0.3, 10, 18)) < 0.02);
  CHECK(std::abs(cylinder_error(t3(), 0.3, 10, 18)) < 0.05);
  for (const Element& stiff : {q4(), t3()})
    CHECK(cylinder_error(stiff, 0.4999, 10, 18) < -0.5);  // far too stiff
  CHECK(std::abs(cylinder_error(t6(), 0.4999, 10, 18)) < 0.02);
}
