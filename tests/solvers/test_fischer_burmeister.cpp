#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/complementarity_functions.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

VectorXd powers_of_ten(Random& random, Index n, int range) {
  VectorXd row(n);
  for (Index i = 0; i < n; ++i) row(i) = std::pow(10.0, random.whole(-range, range));
  return row;
}

}  // namespace

TEST_CASE("the Fischer-Burmeister function is zero exactly on the two half axes",
          "[fischer_burmeister][closed-form][LinEtAl-11][LinEtAl-12]") {
  CHECK(fischer_burmeister(0, 0) == 0);
  CHECK(fischer_burmeister(0, 7) == 0);
  CHECK(fischer_burmeister(7, 0) == 0);
  CHECK(fischer_burmeister(3, 4) == Approx(-2).epsilon(1e-15));    // 5 - 7
  CHECK(fischer_burmeister(-3, 4) == Approx(4).epsilon(1e-15));    // 5 - 1
  CHECK(fischer_burmeister(-3, -4) == Approx(12).epsilon(1e-15));  // 5 + 7
  CHECK(fischer_burmeister(0, -1) == 2);
}

TEST_CASE("the Fischer-Burmeister function keeps its digits near a solution and far from one",
          "[fischer_burmeister]") {
  // For b << 1 phi(1, b) = -b + b^2 / 2 - ...; the plain formula returns 0 from b = 1e-17 on.
  CHECK(fischer_burmeister(1, 1e-20) == Approx(-1e-20).epsilon(1e-15).margin(0));
  CHECK(fischer_burmeister(1e-20, 1) == Approx(-1e-20).epsilon(1e-15).margin(0));
  CHECK(fischer_burmeister(3e200, 4e200) == Approx(-2e200).epsilon(1e-15));
}

TEST_CASE("the slope of the Fischer-Burmeister function agrees with central differences",
          "[fischer_burmeister]") {
  Random random(3);
  const double h = 1e-6;  // error h^2 of the difference plus 1e-16 / h of rounding: 1e-10
  for (int sample = 0; sample < 200; ++sample) {
    const double a = random.uniform(-2, 2);
    const double b = random.uniform(-2, 2);
    if (std::hypot(a, b) < 0.05) continue;  // third derivatives grow like 1 / r^2
    const ComplementaritySlope slope = fischer_burmeister_slope(a, b);
    CAPTURE(a, b);
    CHECK(slope.a == Approx((fischer_burmeister(a + h, b) - fischer_burmeister(a - h, b)) / (2 * h))
                         .margin(1e-8));
    CHECK(slope.b == Approx((fischer_burmeister(a, b + h) - fischer_burmeister(a, b - h)) / (2 * h))
                         .margin(1e-8));
  }
}

TEST_CASE("at the kink the slope is the one along a = b, and it has its digits at the axes",
          "[fischer_burmeister]") {
  const ComplementaritySlope kink = fischer_burmeister_slope(0, 0);
  CHECK(kink.a == std::sqrt(0.5) - 1);
  CHECK(kink.b == std::sqrt(0.5) - 1);
  const ComplementaritySlope near = fischer_burmeister_slope(1e-3, 1e-3);
  CHECK(near.a == Approx(kink.a).epsilon(1e-14));
  CHECK(near.b == Approx(kink.b).epsilon(1e-14));
  // a / sqrt(a^2 + b^2) - 1 = -b^2 / 2 to first order, which is below the rounding of 1.
  CHECK(fischer_burmeister_slope(1, 1e-10).a == Approx(-0.5e-20).epsilon(1e-14).margin(0));
}

TEST_CASE("Newton's method agrees with the trial of all sets on random problems",
          "[fischer_burmeister]") {
  Random random(21);
  for (int sample = 0; sample < 200; ++sample) {
    const ContactProblem problem = random_problem(random, random.whole(1, 8));
    const ContactState state = fischer_burmeister(problem);
    const ContactState reference = enumerate(problem);
    CAPTURE(sample);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(state.active() == reference.active());
    CHECK((state.force - reference.force).norm() <= 1e-12 * reference.force.norm());
    CHECK(certify(problem, state).worst() <= 1e-13);
  }
}

TEST_CASE("Newton's method needs few steps, whatever the number of pairs", "[fischer_burmeister]") {
  // Measured over 3000 problems of up to 40 pairs: 3.3 in the mean, 15 at most.
  Random random(2);
  Index most = 0;
  double sum = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const ContactState state = fischer_burmeister(random_problem(random, random.whole(1, 40)));
    REQUIRE(state.report.status == SolveStatus::Solved);
    most = std::max(most, state.report.iterations);
    sum += static_cast<double>(state.report.iterations);
  }
  CHECK(most <= 20);
  CHECK(sum / 300 <= 5);
  // Strongly coupled pairs: measured 9, 15 and 16; with gap against force alone 7, 23 and 39.
  for (const Index n : {40, 160, 320}) {
    const ContactState state = fischer_burmeister(string_problem(n));
    CHECK(state.report.status == SolveStatus::Solved);
    CHECK(state.report.iterations <= 20);
  }
}

TEST_CASE("pairs that touch without force do not keep Newton's method from ending",
          "[fischer_burmeister]") {
  Random random(9);
  for (int sample = 0; sample < 2000; ++sample) {
    ContactProblem problem = random_problem(random, 6);
    VectorXd force = VectorXd::Zero(6);
    force.head(2) << 1, 0.5;
    VectorXd gap = VectorXd::Zero(6);
    gap.tail(2) << 2, 0.25;
    problem.free_gap = gap - problem.compliance * force;
    const ContactState state = fischer_burmeister(problem);
    CAPTURE(sample);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK((state.force - force).norm() < 1e-11);
  }
}

TEST_CASE("the residual of Newton's method falls from step to step", "[fischer_burmeister]") {
  const ContactState state = fischer_burmeister(string_problem(80));
  REQUIRE(state.report.status == SolveStatus::Solved);
  REQUIRE(state.report.history.size() == static_cast<std::size_t>(state.report.iterations));
  double last = 1;
  for (const Iteration& step : state.report.history) {
    CHECK(step.residual < last);
    last = step.residual;
  }
}

TEST_CASE("Newton's method does not know the scale of a row nor units",
          "[fischer_burmeister][units]") {
  Random random(5);
  for (int sample = 0; sample < 20; ++sample) {
    const ContactProblem problem = random_problem(random, 12);
    const ContactState state = fischer_burmeister(problem);
    const VectorXd row = powers_of_ten(random, 12, 8);
    const ContactState scaled = fischer_burmeister(with_rows(problem, row));
    CHECK(scaled.report.iterations == state.report.iterations);
    CHECK(scaled.active() == state.active());
    CHECK((row.cwiseProduct(scaled.force) - state.force).norm() <= 1e-12 * state.force.norm());
    const ContactState in_metres = fischer_burmeister(in_units(problem, 1e-6, 1e6));
    CHECK(in_metres.report.iterations == state.report.iterations);
    CHECK((1e-6 * in_metres.force - state.force).norm() <= 1e-12 * state.force.norm());
  }
}

TEST_CASE("any square matrix: a complementarity problem without symmetry, built backwards",
          "[fischer_burmeister]") {
  // M = B B^T + skew part has z^T M z > 0, so the solution is the only one.
  Random random(6);
  for (int sample = 0; sample < 100; ++sample) {
    const Index n = random.whole(1, 30);
    Eigen::MatrixXd M = random_problem(random, n).compliance;
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < j; ++i) {
        const double skew = random.uniform(-3, 3);
        M(i, j) += skew;
        M(j, i) -= skew;
      }
    VectorXd force = VectorXd::Zero(n);
    VectorXd gap = VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i)
      (random.whole(0, 1) == 0 ? force : gap)(i) = random.uniform(0.1, 1);
    const ContactState state = fischer_burmeister({M, gap - M * force});
    CAPTURE(sample, n);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK((state.force - force).norm() <= 1e-9 * (1 + force.norm()));
    CHECK((state.gap - gap).norm() <= 1e-9 * (1 + gap.norm()));
  }
}

TEST_CASE("where nothing is a solution, Newton's method does not claim one",
          "[fischer_burmeister]") {
  Eigen::Matrix2d wedge;
  wedge << 1, -1, -1, 1;
  const ContactState state = fischer_burmeister({wedge, Vector2d(-1, -0.5)});
  CHECK(state.report.status != SolveStatus::Solved);
  CHECK(state.report.iterations > 0);
  // A gap that forces only make smaller: any square matrix is allowed, but not every one has a solution.
  CHECK(fischer_burmeister({Eigen::MatrixXd::Constant(1, 1, -1), VectorXd::Constant(1, -1)})
            .report.status != SolveStatus::Solved);
}

TEST_CASE("a limit on the steps is kept and said", "[fischer_burmeister]") {
  const ContactState state = fischer_burmeister(string_problem(160), {2});
  CHECK(state.report.status == SolveStatus::IterationLimit);
  CHECK(state.report.iterations == 2);
}

TEST_CASE("a pair that touches without a force is not called closed",
          "[fischer_burmeister][closed-form]") {
  for (const double coupling : {0.125, 0.25, 0.5, 0.75, 0.9375, -0.25, -0.5})
    for (const Index pressed : {0, 1}) {
      const Eigen::Matrix2d G = (Eigen::Matrix2d() << 1, coupling, coupling, 1).finished();
      const ContactState state = fischer_burmeister({G, -G.col(pressed)});  // forces e_pressed
      CAPTURE(coupling, pressed);
      REQUIRE(state.report.status == SolveStatus::Solved);
      CHECK(state.active() == std::vector<Index>{pressed});
    }
}
