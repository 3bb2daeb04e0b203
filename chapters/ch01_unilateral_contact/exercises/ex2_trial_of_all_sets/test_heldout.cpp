#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct Programme {
  MatrixXd K;
  VectorXd p;
  MatrixXd A;
  VectorXd g;
};

// Small whole numbers make touching pairs and dependent rows likely; u = 0 keeps all gaps closed or
// open, so that a solution exists.
Programme random_programme(unsigned seed, Index n, Index n_c) {
  std::mt19937 random(seed);
  const auto draw = [&random](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  Programme q{MatrixXd(n, n), VectorXd(n), MatrixXd(n_c, n), VectorXd(n_c)};
  for (double& entry : q.K.reshaped()) entry = draw(-2, 2);
  q.K = MatrixXd(q.K * q.K.transpose()) + MatrixXd::Identity(n, n);
  for (double& entry : q.p) entry = draw(-9, 9);
  for (double& entry : q.A.reshaped()) entry = draw(-1, 1);
  for (double& entry : q.g) entry = draw(0, 2);
  return q;
}

// Largest violation of the four conditions; problems are made of whole numbers below 100.
double violation(const Programme& q, const ex1_2::Rest& rest) {
  const VectorXd& u = rest.displacement;
  const VectorXd& force = rest.contact_force;
  const VectorXd gap = q.g - q.A * u;
  double worst = (q.K * u + q.A.transpose() * force - q.p).cwiseAbs().maxCoeff();
  for (Index i = 0; i < gap.size(); ++i)
    worst = std::max({worst, -gap(i), -force(i), std::abs(gap(i) * force(i))});
  return worst;
}

VectorXd reference_displacement(const Programme& q) {
  const signorini::CholeskyFactor K(q.K);
  MatrixXd half = q.A.transpose();
  signorini::solve_lower_columns(K.lower(), half);
  const signorini::ContactState state =
      signorini::enumerate({half.transpose() * half, q.g - q.A * K.solve(q.p)});
  REQUIRE(state.report.status == signorini::SolveStatus::Solved);
  return K.solve(q.p - q.A.transpose() * state.force);
}

ex1_2::Rest solve(const Programme& q) { return ex1_2::solve_by_trial(q.K, q.p, q.A, q.g); }

}  // namespace

TEST_CASE("ex1.2 held out: random problems agree with the library", "[ex1.2]") {
  const unsigned seed = GENERATE(range(0U, 100U));
  const Index n_c = static_cast<Index>(seed % 9);
  const Programme q = random_programme(seed, 1 + static_cast<Index>(seed % 6), n_c);
  CAPTURE(seed, n_c);
  const ex1_2::Rest rest = solve(q);
  REQUIRE(rest.displacement.size() == q.p.size());
  REQUIRE(rest.contact_force.size() == n_c);
  CHECK(equal_within(rest.displacement, reference_displacement(q), 1e-11));
  CHECK(violation(q, rest) < 1e-11);
}

// Row 2 is open at K^-1 p = (1, 2) and closes only because row 1 pushes back.
TEST_CASE("ex1.2 held out: a pair may close because another one does", "[ex1.2]") {
  Programme q{MatrixXd::Identity(2, 2), Eigen::Vector2d(1, 2), MatrixXd(2, 2), VectorXd::Zero(2)};
  q.A << 0, 1, 1, -1;
  const ex1_2::Rest rest = solve(q);
  REQUIRE(rest.displacement.size() == 2);
  REQUIRE(rest.contact_force.size() == 2);
  CHECK(rest.displacement.norm() < 1e-14);
  CHECK(equal_within(rest.contact_force, Eigen::Vector2d(3, 1), 1e-14));
}

TEST_CASE("ex1.2 held out: rows that repeat, add up or vanish", "[ex1.2]") {
  Programme q{MatrixXd::Identity(2, 2), Eigen::Vector2d(3, 5), MatrixXd(5, 2), VectorXd(5)};
  q.A << 1, 0, 1, 0, 0.1, 0, 1, 1, 0, 0;  // row 0 again, a tenth of it, a sum, nothing
  q.g << 1, 1, 0.1, 4, 0;
  const ex1_2::Rest rest = solve(q);
  REQUIRE(rest.displacement.size() == 2);
  REQUIRE(rest.contact_force.size() == 5);
  CHECK(
      equal_within(rest.displacement, Eigen::Vector2d(1, 3), 1e-12));  // u_x = 1 and u_x + u_y = 4
  CHECK(violation(q, rest) < 1e-12);
}

TEST_CASE("ex1.2 held out: units and scales of rows change nothing", "[ex1.2]") {
  const unsigned seed = GENERATE(range(0U, 20U));
  const double length = GENERATE(1e-9, 1.0, 1e9);
  const double row = GENERATE(1e-6, 1e6);
  CAPTURE(seed, length, row);
  const Programme q = random_programme(seed, 6, 5);
  Programme other{q.K / length, q.p, q.A, length * q.g};
  for (Index i = 0; i < 5; i += 2) {
    other.A.row(i) *= row;
    other.g(i) *= row;
  }
  const ex1_2::Rest rest = solve(q);
  const ex1_2::Rest scaled = solve(other);
  REQUIRE(rest.displacement.size() == 6);
  REQUIRE(scaled.displacement.size() == 6);
  CHECK(violation(q, rest) < 1e-11);
  CHECK(equal_within(scaled.displacement / length, rest.displacement, 1e-9));
}

// u to the left of one wall and to the right of another: in exact numbers G is singular, in rounded
// ones it need not be.
TEST_CASE("ex1.2 held out: gaps that contradict each other are refused", "[ex1.2]") {
  const unsigned seed = GENERATE(range(0U, 20U));
  CAPTURE(seed);
  Programme q = random_programme(seed, 3, 2);
  q.A.row(0) << 0.1, 0.7, -0.3;
  q.A.row(1) = -q.A.row(0) / 3;
  q.g << -1, -1;
  CHECK_THROWS_AS(solve(q), signorini::ProblemError);
}

TEST_CASE("ex1.2 held out: too many pairs are refused", "[ex1.2]") {
  const MatrixXd K = MatrixXd::Identity(1, 1);
  const VectorXd p = VectorXd::Zero(1);
  CHECK_THROWS_AS(ex1_2::solve_by_trial(K, p, MatrixXd::Ones(9, 1), VectorXd::Ones(9)),
                  std::invalid_argument);
}
