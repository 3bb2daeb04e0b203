#include <stdexcept>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using namespace ex1_3;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Body random_body(signorini::Random& random, Index n) {
  MatrixXd B(n, n);
  for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
  VectorXd p(n);
  for (double& entry : p) entry = random.uniform(-1, 1);
  return {B * B.transpose() + MatrixXd::Identity(n, n), p};
}

}  // namespace

TEST_CASE("ex1.3 held out: stops in any order, as the library condenses them", "[ex1.3]") {
  signorini::Random random(3);
  for (int sample = 0; sample < 30; ++sample) {
    const Body body = random_body(random, 7);
    const std::vector<Index> touching = {5, 0, 3};
    VectorXd gap(3);
    for (double& entry : gap) entry = random.uniform(-1, 1);
    MatrixXd A = MatrixXd::Zero(3, 7);
    for (Index k = 0; k < 3; ++k) A(k, touching[static_cast<std::size_t>(k)]) = 1;
    const signorini::ContactProblem expected =
        signorini::condense({body.stiffness, body.load, A, gap}).problem;
    const Condensed found = condense(body, touching, gap);
    REQUIRE(found.compliance.rows() == 3);
    CHECK(equal_within(found.compliance, expected.compliance, 1e-12));
    CHECK(equal_within(found.free_gap, expected.free_gap, 1e-12));
  }
}

TEST_CASE("ex1.3 held out: the order in which unknowns leave does not matter", "[ex1.3]") {
  signorini::Random random(4);
  const Body body = random_body(random, 5);
  const Body one = without(without(body, 1), 2);  // 1, then 3, which has moved up
  const Body two = without(without(body, 3), 1);
  REQUIRE(one.load.size() == 3);
  CHECK(equal_within(one.stiffness, two.stiffness, 1e-13));
  CHECK(equal_within(one.load, two.load, 1e-13));
}

// Springs of different stiffness in a row: the compliance of the last cart is the sum of theirs.
TEST_CASE("ex1.3 held out: a row of springs in any unit", "[ex1.3]") {
  for (const double unit : {1e-9, 1.0, 1e9}) {
    const VectorXd k = unit * VectorXd::LinSpaced(6, 1, 3.5);
    Body row{MatrixXd::Zero(6, 6), VectorXd::Zero(6)};
    for (Index i = 0; i < 6; ++i) {
      row.stiffness(i, i) += k(i);
      if (i == 0) continue;
      row.stiffness(i - 1, i - 1) += k(i);
      row.stiffness(i - 1, i) = row.stiffness(i, i - 1) = -k(i);
    }
    row.load(2) = unit;
    const Condensed last = condense(row, {5}, VectorXd::Constant(1, 0.25));
    REQUIRE(last.compliance.size() == 1);
    CHECK(last.compliance(0, 0) * unit == Approx(unit * k.cwiseInverse().sum()).epsilon(1e-12));
    CHECK(last.free_gap(0) == Approx(0.25 - unit * k.head(3).cwiseInverse().sum()).epsilon(1e-12));
  }
}

TEST_CASE("ex1.3 held out: where every unknown has a stop nothing leaves", "[ex1.3]") {
  signorini::Random random(5);
  const Body body = random_body(random, 4);
  const Condensed all = condense(body, {0, 1, 2, 3}, VectorXd::Zero(4));
  REQUIRE(all.compliance.rows() == 4);
  CHECK(equal_within(all.compliance * body.stiffness, MatrixXd::Identity(4, 4), 1e-12));
}

TEST_CASE("ex1.3 held out: no unknown twice, none below zero, none that is loose", "[ex1.3]") {
  Body body{MatrixXd::Identity(2, 2), VectorXd::Ones(2)};
  CHECK_THROWS_AS(condense(body, {1, 1}, VectorXd::Ones(2)), std::invalid_argument);
  CHECK_THROWS_AS(condense(body, {-1}, VectorXd::Ones(1)), std::invalid_argument);
  CHECK_THROWS_AS(without(body, -1), std::invalid_argument);
  body.stiffness(0, 0) = 0;
  CHECK_THROWS_AS(without(body, 0), std::invalid_argument);
}
