// What numbers say of a pair, and how far rounding may go before it says something else.
#include <vector>

#include "catch_compat.hpp"
#include "signorini/problem/closing.hpp"

using Eigen::Vector2d;
using namespace signorini;

namespace {

/// What a pair of mu = 0.5, pressed by 1, does next.
Motion next(Motion motion, const Vector2d& force, const Vector2d& movement, double rounding) {
  const ScaledProblem problem = equilibrate(
      {Eigen::Matrix2d::Identity(), Eigen::VectorXd::Constant(1, -1), Eigen::VectorXd::Zero(1),
       law_of_all(Eigen::VectorXd::Constant(1, 0.5), Eigen::VectorXd::Zero(1))});
  Closure closure;
  closure.force = force;
  closure.movement = movement;
  closure.force_rounding = rounding;
  if (rounding > 0) closure.movement_rounding = Vector2d::Constant(rounding);
  std::vector<Motion> motions = {motion};
  const Eigen::Index changes = predict(problem, closure, 1, motions);
  CHECK(changes == (motions.front() != motion ? 1 : 0));
  return motions.front();
}

}  // namespace

TEST_CASE("a pair that sticks at its bound slides only where rounding cannot have pushed it",
          "[closing][friction]") {
  const double r = 1e-10;
  for (const double way : {1.0, -1.0}) {
    const Motion slides = way > 0 ? Motion::Backward : Motion::Forward;
    const auto stuck = [&](double beyond, double rounding) {
      return next(Motion::Stick, {1, way * (0.5 + beyond)}, {0, 0}, rounding);
    };
    CHECK(stuck(0, 0) == Motion::Stick);
    CHECK(stuck(r, 0) == slides);
    CHECK(stuck(1.4 * r, r) == Motion::Stick);  // of tau, and mu times that of lambda
    CHECK(stuck(1.6 * r, r) == slides);
  }
}

TEST_CASE("a pair slides on against a slip of rounding size, and sticks where it turns",
          "[closing][friction]") {
  const double r = 1e-10;
  for (const double way : {1.0, -1.0}) {
    const Motion slides = way > 0 ? Motion::Forward : Motion::Backward;
    const auto sliding = [&](double slip, double rounding) {
      return next(slides, {1, -way * 0.5}, {0, way * slip}, rounding);
    };
    CHECK(sliding(1, 0) == slides);
    CHECK(sliding(-0.9 * r, r) == slides);
    CHECK(sliding(-1.1 * r, r) == Motion::Stick);
    CHECK(sliding(-1e-3, 0) == Motion::Stick);
  }
}

TEST_CASE("an open pair closes, and a closed one opens, where rounding cannot have done it",
          "[closing]") {
  const double r = 1e-10;
  CHECK(next(Motion::Open, {0, 0}, {-0.9 * r, 0}, r) == Motion::Open);
  CHECK(next(Motion::Open, {0, 0}, {-1.1 * r, 0}, r) == Motion::Stick);
  CHECK(next(Motion::Open, {0, 0}, {-0.9 * r, 0}, 0) == Motion::Stick);
  CHECK(next(Motion::Stick, {-0.9 * r, 0}, {0, 0}, r) == Motion::Stick);
  CHECK(next(Motion::Stick, {-1.1 * r, 0}, {0, 0}, r) == Motion::Open);
}

TEST_CASE("a sliding pair is named by its friction force, and by its slip only where it has none",
          "[closing][friction]") {
  const FrictionLaw rough = law_of_all(Vector2d(0.5, 0), Vector2d(0, 2));
  ContactState state;
  state.slip = Vector2d(1e-17, -1e-17);
  state.friction = Vector2d(0.5, -2);
  state.force = Vector2d(1, 0);
  state.motion = {Motion::Backward, Motion::Forward};
  const std::vector<Motion> named = state.motion;
  name_slides(rough, state);
  CHECK(state.motion == named);
  state.force(0) = -1e-17;  // presses by rounding
  name_slides(rough, state);
  CHECK(state.motion == std::vector<Motion>{Motion::Forward, Motion::Forward});
  state.motion = {Motion::Backward, Motion::Stick};
  name_slides(law_of_all(Vector2d(0, 0), Vector2d(0, 0)), state);
  CHECK(state.motion == std::vector<Motion>{Motion::Forward, Motion::Stick});
}
