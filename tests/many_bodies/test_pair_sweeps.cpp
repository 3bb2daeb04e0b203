// Pairs with friction that are solved one by one, each exactly.
#include "addons/many_bodies/pair_sweeps.hpp"

#include "catch_compat.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"

using namespace signorini;
using Eigen::VectorXd;

TEST_CASE("a pair alone is open, sticks or slides as its equations say", "[pair_sweeps]") {
  // F = (2, 0.5; 0.5, 1): what it does without forces decides.
  const auto force = [](double gap, double slip, double mu, double cohesion = 0) {
    return lone_pair_force({gap, slip, 2, 0.5, 0.5, 1, mu, cohesion});
  };
  CHECK(force(0.1, 3, 0.5).isZero(0));
  // Closed without slip: 2 l + 0.5 t = 4, 0.5 l + t = 1 gives l = 2, t = 0.
  CHECK((force(-4, -1, 0.5) - Eigen::Vector2d(2, 0)).norm() <= 4 * epsilon);
  // Forward, t = -l/2: 2 l - l/4 = 3.5, and the slip is 5 + 1 - 1.
  CHECK((force(-3.5, 5, 0.5) - Eigen::Vector2d(2, -1)).norm() <= 4 * epsilon);
  // Backward, t = l/2: 2 l + l/4 = 4.5, and the slip is -5 + 1 + 1.
  CHECK((force(-4.5, -5, 0.5) - Eigen::Vector2d(2, 1)).norm() <= 4 * epsilon);
  // With cohesion alone the bound is given: t = -1, 2 l - 0.5 = 3.5.
  CHECK((force(-3.5, 5, 0, 1) - Eigen::Vector2d(2, -1)).norm() <= 4 * epsilon);
}

TEST_CASE("sweeps over coupled pairs end at a solution", "[pair_sweeps]") {
  // Two pairs, the second without friction: rows are two gaps and the slip of the first.
  ContactProblem problem;
  problem.compliance.resize(3, 3);
  problem.compliance << 2, 0.5, 0.2, 0.5, 1, 0.1, 0.2, 0.1, 1;
  problem.free_gap = Eigen::Vector2d(-1, -0.5);
  problem.free_slip = VectorXd::Constant(1, 0.4);
  problem.law = {{0}, VectorXd::Constant(1, 0.3), VectorXd::Zero(1)};
  VectorXd force = VectorXd::Zero(3);
  // Each sweep leaves less than half: fifty leave a rounding.
  sweep_pairs(problem.compliance.sparseView(), free_movement(problem), problem.law, 50, force);
  const VectorXd movement = free_movement(problem) + problem.compliance * force;
  ContactState state;
  fill_state(problem.law, {ContactStatus::SlipForward, ContactStatus::Stick}, force, movement, state);
  CHECK(certify(problem, state).worst() <= 16 * epsilon);
  CHECK(force(2) == Approx(-0.3 * force(0)).epsilon(4 * epsilon));
}
