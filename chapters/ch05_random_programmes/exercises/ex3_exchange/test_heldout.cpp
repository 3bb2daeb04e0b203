#include <stdexcept>
#include <utility>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "signorini/core/random.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/equal_within.hpp"

using namespace ex5_3;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Table random_table(signorini::Random& random, Index n) {
  MatrixXd B(n, n);
  VectorXd d(n);
  for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
  for (double& entry : d) entry = random.uniform(-1, 0.5);
  return {B * B.transpose() + 0.3 * MatrixXd::Identity(n, n), d,
          std::vector<bool>(static_cast<std::size_t>(n))};
}

}  // namespace

// Any gaps and forces that satisfy the first equations satisfy those of every table.
TEST_CASE("ex5.3 held out: the equations are the same, solved for others", "[ex5.3]") {
  signorini::Random random(53);
  for (int sample = 0; sample < 50; ++sample) {
    const Index n = random.whole(1, 7);
    Table table = random_table(random, n);
    VectorXd force(n);
    for (double& entry : force) entry = random.uniform(-1, 1);
    const VectorXd gap = table.q + table.M * force;
    for (int k = 0; k < 10; ++k) {
      exchange(table, random.whole(0, static_cast<int>(n) - 1));
      VectorXd x = force, y = gap;
      for (Index i = 0; i < n; ++i)
        if (table.closed[static_cast<std::size_t>(i)]) std::swap(x(i), y(i));
      CHECK((table.q + table.M * x - y).norm() < 1e-9);
    }
  }
}

TEST_CASE("ex5.3 held out: the order does not matter, and twice is not at all", "[ex5.3]") {
  signorini::Random random(54);
  const Table first = random_table(random, 5);
  Table one = first, two = first;
  for (const Index i : {0, 3, 4}) exchange(one, i);
  for (const Index i : {4, 0, 3}) exchange(two, i);
  CHECK(equal_within(one.M, two.M, 1e-11));
  CHECK(equal_within(one.q, two.q, 1e-11));
  for (const Index i : {3, 4, 0}) exchange(one, i);
  CHECK(equal_within(one.M, first.M, 1e-10));
  CHECK(equal_within(one.q, first.q, 1e-10));
  CHECK(one.closed == first.closed);
}

TEST_CASE("ex5.3 held out: random problems that it solves, it solves right", "[ex5.3]") {
  signorini::Random random(55);
  int solved = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const Table first = random_table(random, random.whole(1, 9));
    const Run run = drive({first.M, first.q}, 60);
    CAPTURE(sample);
    if (run.solved)
      CHECK(equal_within(run.force, signorini::enumerate({first.M, first.q}).force, 1e-9));
    solved += run.solved ? 1 : 0;
  }
  CHECK(solved > 290);
}

// A step is not a pivot: few steps, and many exchanges in each.
TEST_CASE("ex5.3 held out: a punch", "[ex5.3]") {
  const signorini::Indentation punch = signorini::half_plane_indentation(40);
  const Run run = drive(punch.problem, 40);
  REQUIRE(run.solved);
  CHECK(run.steps < 10);
  CHECK(run.exchanges > 24);
  CHECK((run.force.array() > 0).count() == 24);
}

// A pair that just touches, with rounding, is on the right side.
TEST_CASE("ex5.3 held out: rounding is not wrong, pairs that depend are refused", "[ex5.3]") {
  Table touching{Eigen::Matrix2d::Identity(), Eigen::Vector2d(-1e-14, 1), {false, false}};
  CHECK(exchange_wrong_pairs(touching) == decltype(exchange_wrong_pairs(touching)){});
  Table twice{Eigen::Matrix2d::Ones(), Eigen::Vector2d(-1, -1), {false, false}};
  CHECK_THROWS_AS(exchange_wrong_pairs(twice), std::invalid_argument);
  CHECK_THROWS_AS(exchange(twice, -1), std::invalid_argument);
  for (const double pivot : {1e-13, -1.0}) {
    Table table{Eigen::Matrix2d::Identity() * pivot, Eigen::Vector2d(-1, -1), {false, false}};
    CHECK_THROWS_AS(exchange(table, 0), std::invalid_argument);
  }
}
