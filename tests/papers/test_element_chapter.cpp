// What chapter 9 says of the contact element: forces, balance, the Jacobian, and the two meanings of f_n.
#include <Eigen/LU>
#include <algorithm>

#include "../chapters/ch09_point_to_surface/contact_element.hpp"
#include "../chapters/ch09_point_to_surface/round_block.hpp"
#include "catch_compat.hpp"
#include "papers/saddle_point_newton.hpp"
#include "signorini/core/random.hpp"
#include "signorini/scene/readings.hpp"

using namespace ch09;

namespace {

const Nodes X = (Nodes() << 4, 0, 0, 3, 3, 1.5).finished();

// On springs, pressed and pulled along the edge.
ContactElement pulled(const Signs& sign, double shear = 4, double cohesion = 1) {
  const Place at = projected(X);
  ContactElement element{
      X, (Vector6d() << 10, 10, 10, 10, 5, 5).finished(), Vector6d::Zero(), 0.3, cohesion, sign};
  element.load.tail(2) = -6 * at.n + shear * at.t;
  return element;
}

// Largest error of a column of the Jacobian against central differences, at a place without kinks.
double jacobian_error(const ContactElement& element) {
  const Vector10d x = Vector10d::LinSpaced(0.3, 0.93);
  const Matrix10d J = equations(element, x).jacobian;
  double worst = 0;
  for (Eigen::Index j = 0; j < 10; ++j) {
    const Vector10d h = 1e-6 * Vector10d::Unit(j);
    const Vector10d rise = equations(element, x + h).residual - equations(element, x - h).residual;
    worst = std::max(worst, (rise / 2e-6 - J.col(j)).norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("forces of one element: what presses node 3 and drags it, and its opposite in shares",
          "[node-to-segment][LinEtAl-20][LinEtAl-23][LinEtAl-24][LinEtAl-25][LinEtAl-26]"
          "[LinEtAl-27][closed-form]") {
  const Place at = projected(X);  // the edge has the length 5 and the normal (3, 4)/5
  CHECK(at.N1 == Approx(0.66).epsilon(1e-14));
  CHECK(at.gap == Approx(0.6).epsilon(1e-14));
  const Nodes fn = nodal_forces(at, 5, 0), ft = nodal_forces(at, 0, 5);
  const auto is = [](const auto& row, double x, double y) {
    return (row - Eigen::RowVector2d(x, y)).norm() < 1e-14;
  };
  CHECK(is(fn.row(2), 3, 4));                  // (23)
  CHECK(is(ft.row(2), 4, -3));                 // (24)
  CHECK(is(fn.row(0) + fn.row(1), -3, -4));    // (25)
  CHECK(is(ft.row(0) + ft.row(1), -4, 3));     // (26)
  CHECK(is(fn.row(0), -0.66 * 3, -0.66 * 4));  // (27)
  CHECK(is(ft.row(1), -0.34 * 4, 0.34 * 3));
}

TEST_CASE("forces of one element are in balance; only friction across a gap is a couple",
          "[node-to-segment][LinEtAl-27][closed-form]") {
  const Place at = projected(X);
  const Nodes fn = nodal_forces(at, 1.2, 0), ft = nodal_forces(at, 0, 0.5);
  CHECK((fn + ft).colwise().sum().norm() < 1e-14);
  CHECK(moment(X, fn) == Approx(0).margin(1e-14));
  CHECK(moment(X, ft) == Approx(-0.5 * at.gap).epsilon(1e-13));
}

TEST_CASE("the gap of an element moves as its nodes do, and its load is that of its nodal forces",
          "[node-to-segment][LinEtAl-21][LinEtAl-22][LinEtAl-30]") {
  ContactElement element = pulled(as_pressure);
  const Place at = projected(X);
  Vector10d x = Vector10d::Zero();
  x.head(6) << 0.1, -0.2, 0.3, 0.1, -0.1, 0.2;
  const Eigen::Vector2d U3 = at.N1 * x.segment<2>(0) + at.N2 * x.segment<2>(2);  // (21)
  const double gap = at.gap + (x.segment<2>(4) - U3).dot(at.n);                  // (22)
  CHECK(equations(element, x).residual(6) == Approx(fischer_burmeister(gap, 0)).margin(1e-14));
  element.load.setZero();
  element.springs.setZero();
  x(6) = 2;
  x(7) = 0.7;
  const Nodes forces = nodal_forces(at, 2, 0.7);
  for (const Signs& sign : {as_pressure, as_stress}) {
    element.sign = sign;
    const Vector10d at_x = equations(element, sign.gap_row > 0 ? x : mirrored(x)).residual;
    for (Eigen::Index i = 0; i < 6; ++i)
      CHECK(at_x(i) == Approx(-forces(i / 2, i % 2)).margin(1e-14));
  }
}

TEST_CASE("the Jacobian of an element is that of its equations, and not with another sign of a",
          "[node-to-segment][LinEtAl-31]") {
  for (const Signs& sign : {as_pressure, as_stress, as_printed})
    CHECK(jacobian_error(pulled(sign)) < 1e-8);
  ContactElement other = pulled(as_pressure);
  const Vector10d x = Vector10d::LinSpaced(0.3, 0.93);
  const Matrix10d J = equations(other, x).jacobian;
  other.sign.reaction = 1;
  CHECK((equations(other, x).jacobian - J).block(0, 6, 6, 2).norm() > 1);
}

TEST_CASE(
    "one sign: f_n as a stress, with (29) to (31) as printed, is the mirror image of f_n as a "
    "pressure",
    "[node-to-segment][LinEtAl-28][LinEtAl-29][LinEtAl-30][LinEtAl-31]") {
  signorini::Random random(1);
  for (int sample = 0; sample < 100; ++sample) {
    Vector10d x;
    for (double& at : x) at = random.uniform(-1, 1);
    const System here = equations(pulled(as_pressure), x);
    const System there = equations(pulled(as_stress), mirrored(x));
    Vector10d residual = mirrored(there.residual);  // rows 8 and 9 change places
    residual.segment<2>(6) << there.residual(6), -there.residual(7);
    CHECK(residual == here.residual);  // to the last bit: only signs and places differ
  }
  for (const double shear : {0.5, 4.0})
    for (const double cohesion : {0.0, 1.0}) {
      CAPTURE(shear, cohesion);
      const Vector10d start = Vector10d::Unit(6);
      const End here = solved(pulled(as_pressure, shear, cohesion), start);
      const End there = solved(pulled(as_stress, shear, cohesion), mirrored(start));
      REQUIRE(here.solved);
      REQUIRE(there.solved);
      CHECK(there.steps == here.steps);
      CHECK((mirrored(there.x) - here.x).norm() < 1e-13);
      // Closed: the gap 0.6, node 3 on its springs, the edge on those of nodes 1 and 2.
      const double closing = 1 / 5.0 + (0.66 * 0.66 + 0.34 * 0.34) / 10;  // per unit of f_n
      CHECK(here.x(6) == Approx((6 / 5.0 - 0.6) / closing).epsilon(1e-12));
      CHECK_FALSE(solved(pulled(as_printed, shear, cohesion), start).solved);
    }
}

TEST_CASE("the round block has the same forces with all unknowns and with contact forces only",
          "[saddle-point]") {
  const SolvedScene condensed = solved(round_block(16, {"mm"}), "round block");
  const Eigen::VectorXd& force = condensed.solution.contact.force;
  for (const auto form : {SaddlePointForm::OneUnit, SaddlePointForm::AsPrinted}) {
    SaddlePointOptions options;
    options.form = form;
    const SaddlePointSolution whole = saddle_point_newton(condensed.model.programme, options);
    REQUIRE(whole.report.status == SolveStatus::Solved);
    CHECK((whole.solution.force - force).norm() < 1e-11 * force.norm());
  }
}
