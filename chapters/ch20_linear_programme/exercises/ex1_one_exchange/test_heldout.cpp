#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/linear_programme.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using namespace ex20_1;

TEST_CASE("ex20.1 held out: random problems end at the solution of the library", "[ex20.1]") {
  signorini::Random random(1);
  for (int sample = 0; sample < 200; ++sample) {
    const Index n = 1 + sample % 9;
    const auto any = [&] { return random.uniform(-2, 2); };
    const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(n, n, any);
    const Eigen::MatrixXd G = B * B.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
    const Eigen::VectorXd d = Eigen::VectorXd::NullaryExpr(n, any);
    const Run run = solve(G, d);
    const Eigen::VectorXd force = signorini::linear_programme({G, d}).force;
    CAPTURE(sample);
    CHECK(run.left <= 1e-9);
    CHECK(equal_within(run.force, force,
                       1e-8 * (1 + force.norm())));  // up to nine exchanges and more, unrefined
  }
}

TEST_CASE("ex20.1 held out: a pair that was written twice stalls", "[ex20.1]") {
  const Run run = solve(Eigen::Matrix2d::Ones(), Eigen::Vector2d(-1, -2));
  CHECK(run.joined == std::vector<Index>{2});
  CHECK(run.left == Approx(1).epsilon(1e-14));
}

TEST_CASE("ex20.1 held out: of equal ratios the first row leaves, and none if nothing blocks",
          "[ex20.1]") {
  const Tableau tableau = start(Eigen::Matrix2d::Ones(), Eigen::Vector2d(-1, -1));
  CHECK(joining(tableau) == 2);
  CHECK(leaving(tableau, 2) == 0);
  CHECK(leaving(start(Eigen::Matrix2d::Ones(), Eigen::Vector2d(1, 1)), 2) == -1);
}
