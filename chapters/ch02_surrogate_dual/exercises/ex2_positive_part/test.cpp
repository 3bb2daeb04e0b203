#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

TEST_CASE("ex2.2 one pair follows the closed form", "[ex2.2]") {
  const double gap = GENERATE(-3.0, -1.0, 0.0, 2.0);
  CAPTURE(gap);
  const ex2_2::Gain gain = ex2_2::dual_energy(MatrixXd::Constant(1, 1, 2),
                                              VectorXd::Constant(1, gap), VectorXd::Ones(1));
  CHECK(gain.force == std::max(0.0, -gap / 2));
  CHECK(gain.energy == std::max(0.0, -gap) * std::max(0.0, -gap) / 4);
}

TEST_CASE("ex2.2 the open vertex loses against the overlapping one", "[ex2.2]") {
  const Matrix2d G = Matrix2d::Identity();
  CHECK(ex2_2::dual_energy(G, Vector2d(2, -1), Vector2d(1, 0)).energy == 0);
  CHECK(ex2_2::dual_energy(G, Vector2d(2, -1), Vector2d(0, 1)).energy == 0.5);
  CHECK(ex2_2::dual_energy(G, Vector2d(2, -1), Vector2d(0, 1)).force == 1);
}

TEST_CASE("ex2.2 an overlapping pair that cannot yield has no best force", "[ex2.2]") {
  const ex2_2::Gain gain =
      ex2_2::dual_energy(MatrixXd::Zero(1, 1), VectorXd::Constant(1, -1), VectorXd::Ones(1));
  CHECK(std::isinf(gain.force));
  CHECK(gain.force > 0);
  CHECK(std::isinf(gain.energy));
  CHECK(gain.energy > 0);
}
