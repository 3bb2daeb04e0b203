// What chapter 9 says of the contact element: balance, the repaired Jacobian, and the printed one.
#include <Eigen/LU>
#include <algorithm>

#include "../chapters/ch09_point_to_surface/contact_element.hpp"
#include "../chapters/ch09_point_to_surface/round_block.hpp"
#include "catch_compat.hpp"
#include "papers/saddle_point_newton.hpp"
#include "signorini/scene/readings.hpp"

using namespace ch09;

namespace {

const Nodes X = (Nodes() << 4, 0, 0, 3, 3, 1.5).finished();

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

TEST_CASE("forces of one element are in balance; only friction across a gap is a couple",
          "[node-to-segment][LinEtAl-27][closed-form]") {
  const Place at = projected(X);
  const Nodes fn = nodal_forces(at, 1.2, 0), ft = nodal_forces(at, 0, 0.5);
  CHECK((fn + ft).colwise().sum().norm() < 1e-14);
  CHECK(moment(X, fn) == Approx(0).margin(1e-14));
  CHECK(moment(X, ft) == Approx(-0.5 * at.gap).epsilon(1e-13));
}

TEST_CASE("with -a the Jacobian of an element is that of its equations, with +a it is not",
          "[node-to-segment][LinEtAl-31]") {
  const Place at = projected(X);
  ContactElement element{X, (Vector6d() << 10, 10, 10, 10, 5, 5).finished(), Vector6d::Zero(), 0.3,
                         1};
  element.load.tail(2) = -6 * at.n + 4 * at.t;
  for (const double bound : {1.0, -1.0}) {
    element.bound = bound;
    element.reaction = -1;
    CHECK(jacobian_error(element) < 1e-8);
    element.reaction = 1;
    CHECK(jacobian_error(element) > 1);
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
