#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using namespace ex8_4;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini::ContactProblem;

static ContactProblem random_problem(Index n, std::uint64_t seed) {
  signorini::Random random(seed);
  MatrixXd B(n, n);
  VectorXd d(n);
  for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
  for (double& entry : d) entry = random.uniform(-1, 0.5);
  return {B * B.transpose() + 0.1 * MatrixXd::Identity(n, n), d};
}

TEST_CASE("ex8.4 held out: random problems end where the library ends", "[ex8.4]") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const ContactProblem problem = random_problem(1 + static_cast<Index>(seed % 20), seed);
    CAPTURE(seed);
    const VectorXd expected = signorini::find_solver("lemke").solve(problem, {}).force;
    CHECK(equal_within(through_the_inside(problem), expected, 1e-9 * (1 + expected.norm())));
  }
}

TEST_CASE("ex8.4 held out: along the path the products fall together", "[ex8.4]") {
  const ContactProblem problem = random_problem(12, 99);
  const VectorXd end = through_the_inside(problem);
  for (const double epsilon : {1.0, 1e-4, 1e-8}) {
    const Inner inner = central(problem, epsilon);
    CAPTURE(epsilon);
    const VectorXd products = inner.force.cwiseProduct(inner.gap);
    CHECK((products / epsilon - VectorXd::Ones(12)).cwiseAbs().maxCoeff() < 1e-10);
    // The work of both differences on each other is n epsilon less two products that are not negative.
    const VectorXd off = inner.force - end;
    CHECK(off.dot(problem.compliance * off) <= 12 * epsilon * (1 + 1e-6));
  }
}

// One unit for the gap of the first pair, another one for that of the second.
TEST_CASE("ex8.4 held out: each pair in units of its own", "[ex8.4][units]") {
  const ContactProblem plain = random_problem(5, 7);
  const VectorXd expected = through_the_inside(plain);
  for (const double unit : {1e-6, 1e6}) {
    const VectorXd row = (VectorXd(5) << unit, 1, unit, unit * unit, 1).finished();
    const ContactProblem other{row.asDiagonal() * plain.compliance * row.asDiagonal(),
                               row.cwiseProduct(plain.free_gap)};
    CAPTURE(unit);
    const VectorXd force = through_the_inside(other).cwiseProduct(row);
    CHECK(equal_within(force, expected, 1e-9 * (1 + expected.norm())));
    const Inner inner = central(other, 1e-3);
    CHECK((inner.force.cwiseProduct(inner.gap) * 1e3 - VectorXd::Ones(5)).cwiseAbs().maxCoeff() <
          1e-10);
  }
}

// The second pair has a force of 2/3 of the shift, or a gap of all of it: the path has to be followed far enough to tell.
TEST_CASE("ex8.4 held out: a pair that nearly touches, in small and large units",
          "[ex8.4][units]") {
  const double shift = 1e-5;
  for (const double unit : {1e-9, 1.0, 1e9}) {
    const Eigen::Matrix2d G = (Eigen::Matrix2d() << 2, 1, 1, 2).finished() * unit;
    CAPTURE(unit);
    const VectorXd open = through_the_inside({G, unit * Eigen::Vector2d(-2, -1 + shift)});
    CHECK(equal_within(open, Eigen::Vector2d(1, 0), 1e-12));
    const VectorXd both = through_the_inside({G, unit * Eigen::Vector2d(-2, -1 - shift)});
    CHECK(equal_within(both, Eigen::Vector2d(1 - shift / 3, shift * 2 / 3), 1e-12));
  }
}

TEST_CASE("ex8.4 held out: problems on which pivots take every basis", "[ex8.4]") {
  for (const Index n : {2, 4, 6}) {
    const VectorXd force = through_the_inside(signorini::fathi(n));
    CAPTURE(n);
    CHECK(equal_within(force, VectorXd::Unit(n, 0), 1e-9));
  }
}

TEST_CASE("ex8.4 held out: nothing acts, and no pairs", "[ex8.4]") {
  CHECK(through_the_inside({Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero()}).norm() == 0);
  CHECK(through_the_inside({MatrixXd(0, 0), VectorXd(0)}).size() == 0);
  const Inner inner = central({Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero()}, 4);
  CHECK(equal_within(inner.force, Eigen::Vector2d(2, 2), 1e-10));
}

TEST_CASE("ex8.4 held out: what is no problem is refused", "[ex8.4]") {
  const ContactProblem good{Eigen::Matrix2d::Identity(), Eigen::Vector2d(-1, 1)};
  CHECK_THROWS_AS(central(good, 0), std::invalid_argument);
  CHECK_THROWS_AS(central(good, -1), std::invalid_argument);
  CHECK_THROWS_AS(central(good, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  CHECK_THROWS_AS(central(good, std::numeric_limits<double>::infinity()), std::invalid_argument);
  CHECK_THROWS_AS(central({Eigen::Matrix2d::Identity(), Eigen::Vector3d(-1, 1, 1)}, 1),
                  std::invalid_argument);
  CHECK_THROWS_AS(through_the_inside({MatrixXd::Identity(2, 3), Eigen::Vector2d(-1, 1)}),
                  std::invalid_argument);
}
