#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex8_5;
using Eigen::VectorXd;

static Problem one_pair(double d, double s, double mu) {
  return {Eigen::Matrix2d::Identity(), VectorXd::Constant(1, d), VectorXd::Constant(1, s), mu};
}

static Status status_of(double d, double s, double force, double friction) {
  const std::vector<Status> found = statuses_at(
      one_pair(d, s, 0.5), 2, VectorXd::Constant(1, force), VectorXd::Constant(1, friction));
  return found.at(0);
}

TEST_CASE("ex8.5 what a pair does, by the maps", "[ex8.5]") {
  CHECK(status_of(1, 0, 0, 0) == Status::Open);         // 0 - 2 * 1
  CHECK(status_of(-1, 0.3, 1, -0.3) == Status::Stick);  // gap and slip are zero
  CHECK(status_of(-1, 1, 1, -0.5) == Status::Forward);  // -0.5 - 2 * 0.5 < -0.5
  CHECK(status_of(-1, -1, 1, 0.5) == Status::Backward);
  CHECK(status_of(-1, 0, 0, 0) == Status::Stick);  // overlap of 1: bound 1, trial 0
}

TEST_CASE("ex8.5 the forces that statuses stand for", "[ex8.5]") {
  const auto forces = [](Status status) { return forces_of(one_pair(-1, 1, 0.5), {status}); };
  CHECK(forces(Status::Open).norm() == 0);
  CHECK(equal_within(forces(Status::Stick), Eigen::Vector2d(1, -1), 1e-15));
  CHECK(equal_within(forces(Status::Forward), Eigen::Vector2d(1, -0.5), 1e-15));
  CHECK(equal_within(forces(Status::Backward), Eigen::Vector2d(1, 0.5), 1e-15));
}

TEST_CASE("ex8.5 one pair sticks or slides", "[ex8.5][LinEtAl-13][LinEtAl-14]") {
  for (const double s : {-2.0, -0.3, 0.0, 0.3, 1.0}) {
    CAPTURE(s);
    const Answer answer = semismooth(one_pair(-1, s, 0.5), 1);
    REQUIRE(answer.solved);
    CHECK(answer.force(0) == Approx(1).epsilon(1e-15));
    CHECK(answer.friction(0) == Approx(std::min(0.5, std::max(-0.5, -s))).margin(1e-15));
  }
  const Answer open = semismooth(one_pair(0.5, 3, 0.5), 1);
  REQUIRE(open.solved);
  CHECK(open.force(0) == 0);
  CHECK(open.friction(0) == 0);
}

TEST_CASE("ex8.5 two pairs of which one would pull, and three that run in a circle", "[ex8.5]") {
  const auto without_friction = [](const Eigen::MatrixXd& G, const VectorXd& d) {
    const Eigen::Index n = d.size();
    Problem problem{Eigen::MatrixXd::Identity(2 * n, 2 * n), d, VectorXd::Zero(n), 0};
    problem.compliance.topLeftCorner(n, n) = G;
    return problem;
  };
  const Answer two = semismooth(
      without_friction((Eigen::Matrix2d() << 2, 1, 1, 2).finished(), Eigen::Vector2d(-3, -1)), 1);
  REQUIRE(two.solved);
  CHECK(two.steps == 2);
  CHECK(equal_within(two.force, Eigen::Vector2d(1.5, 0), 1e-15));
  const Answer circle =
      semismooth(without_friction((Eigen::Matrix3d() << 4, -6, -4, -6, 10, 8, -4, 8, 9).finished(),
                                  Eigen::Vector3d(3, -4, -1)),
                 1);
  CHECK_FALSE(circle.solved);
  CHECK(circle.steps == 3);
}

TEST_CASE("ex8.5 of two pairs one sticks and one slides", "[ex8.5]") {
  const Answer answer = semismooth(
      {Eigen::Matrix4d::Identity(), Eigen::Vector2d(-1, -2), Eigen::Vector2d(0.3, 3), 0.5}, 1);
  REQUIRE(answer.solved);
  CHECK(equal_within(answer.force, Eigen::Vector2d(1, 2), 1e-15));
  CHECK(equal_within(answer.friction, Eigen::Vector2d(-0.3, -1), 1e-15));
  CHECK(answer.statuses == std::vector<Status>{Status::Stick, Status::Forward});
}

TEST_CASE("ex8.5 the same two pairs the other way round", "[ex8.5]") {
  const Answer answer = semismooth(
      {Eigen::Matrix4d::Identity(), Eigen::Vector2d(-2, -1), Eigen::Vector2d(3, 0.3), 0.5}, 1);
  REQUIRE(answer.solved);
  CHECK(answer.statuses == std::vector<Status>{Status::Forward, Status::Stick});
}
