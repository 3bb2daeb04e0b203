// What numbers say of a pair, and how far rounding may go before it says something else.
#include <vector>

#include "catch_compat.hpp"
#include "signorini/problem/active_set_system.hpp"

using Eigen::Vector2d;
using namespace signorini;

namespace {

/// What a pair of mu = 0.5, pressed by 1, does next.
ContactStatus next(ContactStatus contact_status, const Vector2d& force, const Vector2d& movement,
                   double rounding) {
  const ScaledProblem problem = equilibrate(
      {Eigen::Matrix2d::Identity(), Eigen::VectorXd::Constant(1, -1), Eigen::VectorXd::Zero(1),
       law_of_all(Eigen::VectorXd::Constant(1, 0.5), Eigen::VectorXd::Zero(1))});
  ActiveSetSolution solution;
  solution.force = force;
  solution.movement = movement;
  solution.force_rounding = rounding;
  if (rounding > 0) solution.movement_rounding = Vector2d::Constant(rounding);
  std::vector<ContactStatus> statuses = {contact_status};
  const Eigen::Index changes = predict(problem, solution, 1, statuses);
  CHECK(changes == (statuses.front() != contact_status ? 1 : 0));
  return statuses.front();
}

}  // namespace

TEST_CASE("a pair that sticks at its bound slides only where rounding cannot have pushed it",
          "[active_set][friction]") {
  const double r = 1e-10;
  for (const double way : {1.0, -1.0}) {
    const ContactStatus slides = way > 0 ? ContactStatus::SlipBackward : ContactStatus::SlipForward;
    const auto stuck = [&](double beyond, double rounding) {
      return next(ContactStatus::Stick, {1, way * (0.5 + beyond)}, {0, 0}, rounding);
    };
    CHECK(stuck(0, 0) == ContactStatus::Stick);
    CHECK(stuck(r, 0) == slides);
    CHECK(stuck(1.4 * r, r) == ContactStatus::Stick);  // of tau, and mu times that of lambda
    CHECK(stuck(1.6 * r, r) == slides);
  }
}

TEST_CASE("a pair slides on against a slip of rounding size, and sticks where it turns",
          "[active_set][friction]") {
  const double r = 1e-10;
  for (const double way : {1.0, -1.0}) {
    const ContactStatus slides = way > 0 ? ContactStatus::SlipForward : ContactStatus::SlipBackward;
    const auto sliding = [&](double slip, double rounding) {
      return next(slides, {1, -way * 0.5}, {0, way * slip}, rounding);
    };
    CHECK(sliding(1, 0) == slides);
    CHECK(sliding(-0.9 * r, r) == slides);
    CHECK(sliding(-1.1 * r, r) == ContactStatus::Stick);
    CHECK(sliding(-1e-3, 0) == ContactStatus::Stick);
  }
}

TEST_CASE("an open pair closes, and a closed one opens, where rounding cannot have done it",
          "[active_set]") {
  const double r = 1e-10;
  CHECK(next(ContactStatus::Open, {0, 0}, {-0.9 * r, 0}, r) == ContactStatus::Open);
  CHECK(next(ContactStatus::Open, {0, 0}, {-1.1 * r, 0}, r) == ContactStatus::Stick);
  CHECK(next(ContactStatus::Open, {0, 0}, {-0.9 * r, 0}, 0) == ContactStatus::Stick);
  CHECK(next(ContactStatus::Stick, {-0.9 * r, 0}, {0, 0}, r) == ContactStatus::Stick);
  CHECK(next(ContactStatus::Stick, {-1.1 * r, 0}, {0, 0}, r) == ContactStatus::Open);
}

TEST_CASE("a sliding pair is named by its friction force, and by its slip only where it has none",
          "[active_set][friction]") {
  using Statuses = std::vector<ContactStatus>;
  const FrictionLaw rough = law_of_all(Vector2d(0.5, 0), Vector2d(0, 2));
  const FrictionLaw smooth = law_of_all(Vector2d(0, 0), Vector2d(0, 0));
  const auto named = [](const FrictionLaw& law, double pressed, const Statuses& statuses) {
    ContactState state;
    fill_state(law, statuses, Eigen::Vector4d(pressed, 0, 0.5, -2),
               Eigen::Vector4d(0, 0, 1e-17, -1e-17), state);
    return state.contact_status;
  };
  const Statuses both = {ContactStatus::SlipBackward, ContactStatus::SlipForward};
  CHECK(named(rough, 1, both) == both);
  CHECK(named(rough, -1e-17, both) ==  // presses by rounding
        Statuses{ContactStatus::SlipForward, ContactStatus::SlipForward});
  CHECK(named(smooth, -1e-17, {ContactStatus::SlipBackward, ContactStatus::Stick}) ==
        Statuses{ContactStatus::SlipForward, ContactStatus::Stick});
}
