#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/random.hpp"

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

TEST_CASE("ex2.2 held out: no other force that presses gains more", "[ex2.2]") {
  const unsigned seed = GENERATE(range(0U, 100U));
  CAPTURE(seed);
  signorini::Random random(seed);
  const Index n = random.whole(1, 6);
  MatrixXd B(n, n);
  for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
  const MatrixXd G = B * B.transpose() + 0.1 * MatrixXd::Identity(n, n);
  VectorXd d(n);
  for (double& gap : d) gap = random.uniform(-1, 1);
  VectorXd xi(n);
  for (double& weight : xi) weight = random.uniform(0, 1);
  const ex2_2::Gain gain = ex2_2::dual_energy(G, d, xi);
  CHECK(gain.energy == Approx(signorini::surrogate_dual_value({G, d}, xi)).epsilon(1e-12));
  CHECK(gain.force == Approx(signorini::total_contact_force({G, d}, xi)).epsilon(1e-12));
  CHECK(gain.force >= 0);
  for (int k = 0; k < 20; ++k) {
    const double eta = random.uniform(0, 3);
    CHECK(-eta * d.dot(xi) - 0.5 * eta * eta * xi.dot(G * xi) <= gain.energy + 1e-12);
  }
}

// Two walls facing each other: equal weights push against each other and move nothing.
TEST_CASE("ex2.2 held out: between two walls the sign of the weighted gap decides", "[ex2.2]") {
  const Matrix2d G = (Matrix2d() << 1, -1, -1, 1).finished();
  const Vector2d half(0.5, 0.5);
  CHECK(ex2_2::dual_energy(G, Vector2d(-1, -0.5), half).energy == HUGE_VAL);  // too narrow
  CHECK(ex2_2::dual_energy(G, Vector2d(-1, 1), half).energy == 0);            // an exact fit
  CHECK(ex2_2::dual_energy(G, Vector2d(-1, 1), half).force == 0);
  CHECK(ex2_2::dual_energy(G, Vector2d(-1, 2), half).energy == 0);  // room to move
  CHECK(ex2_2::dual_energy(G, Vector2d(-1, 2), Vector2d(1, 0)).energy == 0.5);
}
