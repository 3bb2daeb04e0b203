#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/equal_within.hpp"

using namespace ex4_4;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini::ContactProblem;

namespace {

double dual_energy(const ContactProblem& problem, const VectorXd& force) {
  return -force.dot(problem.free_gap + 0.5 * (problem.compliance * force));
}

// G of n pairs over m unknowns, in whole numbers: many rows push each other both ways.
ContactProblem random_problem(signorini::Random& random, Index n, Index m) {
  MatrixXd B(n, m);
  VectorXd d(n);
  for (double& entry : B.reshaped()) entry = random.whole(-2, 2);
  for (double& entry : d) entry = random.whole(-3, 3);
  MatrixXd G = B * B.transpose();
  for (Index i = 0; i < n; ++i)
    if (G(i, i) == 0) d(i) = 1;  // a row of zeros cannot be closed
  return {G, d};
}

// Forces that are the best ones for the pairs that have one.
void check_forces(const ContactProblem& problem, const VectorXd& force) {
  CHECK(force.minCoeff() >= 0);
  const VectorXd gap = problem.free_gap + problem.compliance * force;
  for (Index i = 0; i < gap.size(); ++i)
    if (force(i) > 0) CHECK(std::abs(gap(i)) < 1e-9);
}

}  // namespace

TEST_CASE("ex4.4 held out: every round raises the energy, and the last one is the solution",
          "[ex4.4]") {
  signorini::Random random(44);
  for (int sample = 0; sample < 500; ++sample) {
    const Index n = random.whole(2, 7);
    const ContactProblem made = random_problem(random, n, n);
    const ContactProblem problem{made.compliance + 0.2 * MatrixXd::Identity(n, n), made.free_gap};
    CAPTURE(sample, n);
    double energy = 0;
    VectorXd force = VectorXd::Zero(n);
    for (const Round& round : drive(problem, 100)) {
      force = round.force;
      check_forces(problem, force);
      REQUIRE(dual_energy(problem, force) > energy);
      energy = dual_energy(problem, force);
    }
    CHECK(equal_within(force, signorini::enumerate(problem).force, 1e-9));
  }
}

// Rounds seldom need care: around these three and four pairs the second or third one does.
TEST_CASE("ex4.4 held out: with care the energy rises as well", "[ex4.4]") {
  signorini::Random random(46);
  const ContactProblem three{(Eigen::Matrix3d() << 5, -4, 3, -4, 5, -2, 3, -2, 2).finished(),
                             Eigen::Vector3d(2, -3, 0)};
  const ContactProblem four{
      (Eigen::Matrix4d() << 6, 0, -1, 2, 0, 3, -1, -2, -1, -1, 1, 1, 2, -2, 1, 3).finished(),
      Eigen::Vector4d(3, 0, -3, -3)};
  int careful = 0;
  for (int sample = 0; sample < 400; ++sample) {
    ContactProblem problem = sample % 2 == 0 ? three : four;
    const Index n = problem.free_gap.size();
    for (double& entry : problem.free_gap) entry += random.uniform(-0.1, 0.1);
    VectorXd row(n);
    for (double& entry : row) entry = random.uniform(0.8, 1.25);
    problem.compliance = row.asDiagonal() * problem.compliance * row.asDiagonal();
    problem.free_gap = row.cwiseProduct(problem.free_gap);
    CAPTURE(sample);
    double energy = 0;
    VectorXd force = VectorXd::Zero(n);
    for (const Round& round : drive(problem, 20)) {
      force = round.force;
      check_forces(problem, force);
      REQUIRE(dual_energy(problem, force) > energy);
      energy = dual_energy(problem, force);
      careful += round.at_once ? 0 : 1;
    }
    CHECK(equal_within(force, signorini::enumerate(problem).force, 1e-9));
  }
  CHECK(careful > 100);
}

// More pairs than unknowns. Where the overlapping pairs all depend on the closed ones, nobody joins and the rounds end.
TEST_CASE("ex4.4 held out: groups of independent pairs, whatever overlaps", "[ex4.4]") {
  signorini::Random random(45);
  for (int sample = 0; sample < 300; ++sample) {
    const ContactProblem problem = random_problem(random, 8, 3);
    CAPTURE(sample);
    for (const Round& round : drive(problem, 50)) {
      const Rows group = group_of(problem, round.force);
      CHECK(group.size() <= 3);
      check_forces(problem, round.force);
    }
  }
}

// Two of the old pairs vanish on the way, one after the other, and what is left of the forces counts each time.
TEST_CASE("ex4.4 held out: two pairs open one after the other", "[ex4.4]") {
  const ContactProblem problem{
      (Eigen::Matrix4d() << 6, -4, 2, 4, -4, 8, -4, 0, 2, -4, 5, 4, 4, 0, 4, 10).finished(),
      Eigen::Vector4d(4, -16, 5, -11)};
  const Round round = group_step(problem, Eigen::Vector4d(1, 3, 1, 0), {0, 1, 2, 3});
  CHECK_FALSE(round.at_once);
  CHECK(equal_within(round.force, Eigen::Vector4d(0, 2, 0, 1.1), 1e-12));
}

// The first of two pairs to vanish leaves; the other one, which a jump would have opened as well, stays.
TEST_CASE("ex4.4 held out: on the careful way only the first to vanish opens", "[ex4.4]") {
  const ContactProblem problem{
      (Eigen::Matrix4d() << 6, 0, -1, 2, 0, 3, -1, -2, -1, -1, 1, 1, 2, -2, 1, 3).finished(),
      Eigen::Vector4d(3, 0, -3, -3)};
  const std::vector<Round> rounds = drive(problem, 10);
  REQUIRE(rounds.size() == 3);
  CHECK_FALSE(rounds[2].at_once);
  CHECK(equal_within(rounds[2].force, Eigen::Vector4d(0, 2, 4, 1), 1e-12));
}
