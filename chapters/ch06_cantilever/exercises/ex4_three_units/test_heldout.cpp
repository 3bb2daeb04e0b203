#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "signorini/core/random.hpp"
#include "signorini/solvers/enumerate.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ex6_4::closed_nodes;
using ex6_4::Rows;
using signorini::ContactProblem;

TEST_CASE("ex6.4 held out: each row in a unit of its own", "[ex6.4]") {
  signorini::Random random(64);
  const signorini::Indentation punch = signorini::half_plane_indentation(30);
  const Rows plain = closed_nodes(punch.problem);
  CHECK(plain.size() == 18);
  for (int sample = 0; sample < 30; ++sample) {
    VectorXd row(30);
    for (double& entry : row) entry = std::pow(10, random.uniform(-9, 9));
    CAPTURE(sample);
    CHECK(closed_nodes({row.asDiagonal() * punch.problem.compliance * row.asDiagonal(),
                        row.cwiseProduct(punch.problem.free_gap)}) == plain);
  }
}

TEST_CASE("ex6.4 held out: random problems in random units", "[ex6.4]") {
  signorini::Random random(65);
  for (int sample = 0; sample < 200; ++sample) {
    const Index n = random.whole(1, 7);
    MatrixXd B(n, n);
    VectorXd d(n);
    for (double& entry : B.reshaped()) entry = random.uniform(0, 1);
    for (double& entry : d) entry = random.uniform(-1, 0.5);
    const ContactProblem problem{B * B.transpose() + MatrixXd::Identity(n, n), d};
    const Rows expected = signorini::enumerate(problem).active();
    const double length = std::pow(10, random.uniform(-12, 12));
    const double force = std::pow(10, random.uniform(-12, 12));
    CAPTURE(sample, length, force);
    CHECK(closed_nodes({problem.compliance * (length / force), d * length}) == expected);
  }
}

// Nothing acts: no gap and no force is larger than what rounding makes of nothing.
TEST_CASE("ex6.4 held out: pairs that touch everywhere", "[ex6.4]") {
  CHECK(closed_nodes({Eigen::Matrix2d::Identity(), Eigen::Vector2d(0, 0)}) == Rows{});
  CHECK(closed_nodes({Eigen::Matrix2d::Identity(), Eigen::Vector2d(0, 1e-30)}) == Rows{});
}

TEST_CASE("ex6.4 held out: sets that do not settle are no answer", "[ex6.4]") {
  const ContactProblem circles{(Eigen::Matrix3d() << 4, -6, -4, -6, 10, 8, -4, 8, 9).finished(),
                               Eigen::Vector3d(3, -4, -1)};
  CHECK_THROWS_AS(closed_nodes(circles), std::runtime_error);
}
