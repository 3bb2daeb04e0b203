#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "signorini/contact/obstacle.hpp"
#include "support/message.hpp"

using Eigen::Vector2d;
using namespace signorini;
using signorini_test::problem_message;

namespace {

/// The wave y = 0.3 sin(2x).
Obstacle wave() {
  return profile([](double x) { return 0.3 * std::sin(2 * x); },
                 [](double x) { return 0.6 * std::cos(2 * x); });
}

}  // namespace

TEST_CASE("a gap is open above zero, closed at zero and an overlap below", "[obstacle]") {
  const Obstacle ground = half_plane({5, -1}, {0, 3});
  CHECK(ground.look({0, 1}).gap == Approx(2).epsilon(1e-15));
  CHECK(ground.look({7, -1}).gap == Approx(0).margin(1e-15));
  CHECK(ground.look({0, -1.5}).gap == Approx(-0.5).epsilon(1e-15));
  const Obstacle roller = disc({1, 2}, 5);
  CHECK(roller.look({1, 9}).gap == Approx(2).epsilon(1e-15));
  CHECK(roller.look({4, 6}).gap == Approx(0).margin(1e-15));
  CHECK(roller.look({1, 1}).gap == Approx(-4).epsilon(1e-15));
  const Obstacle bearing = hole({1, 2}, 5);
  CHECK(bearing.look({1, 1}).gap == Approx(4).epsilon(1e-15));
  CHECK(bearing.look({4, 6}).gap == Approx(0).margin(1e-15));
  CHECK(bearing.look({1, 9}).gap == Approx(-2).epsilon(1e-15));
  CHECK(wave().look({0.4, 1}).gap > 0);
  CHECK(wave().look({0.4, 0.3 * std::sin(0.8)}).gap == Approx(0).margin(1e-15));
  CHECK(wave().look({0.4, 0}).gap < 0);
}

TEST_CASE("normals have length 1 and point out of the obstacle", "[obstacle][XuanLi2002-1]") {
  CHECK((half_plane({5, -1}, {3, 4}).look({0, 9}).normal - Vector2d(0.6, 0.8)).norm() < 1e-15);
  CHECK((disc({1, 2}, 5).look({1, 9}).normal - Vector2d(0, 1)).norm() < 1e-15);
  CHECK((hole({1, 2}, 5).look({1, 5}).normal - Vector2d(0, -1)).norm() < 1e-15);
  const Vector2d normal = wave().look({0.4, 1}).normal;
  CHECK(normal.norm() == Approx(1).epsilon(1e-15));
  CHECK(normal.y() > 0);
  CHECK(normal.x() / normal.y() == Approx(-0.6 * std::cos(0.8)).epsilon(1e-14));
}

TEST_CASE("moving along the normal opens the gap at rate 1", "[obstacle]") {
  const double h = 1e-6;  // truncation h^2, rounding 1e-16 / h
  const Vector2d x(0.4, 0.8);
  for (const Obstacle& obstacle :
       {half_plane({5, -1}, {3, 4}), disc({1, 2}, 0.5), hole({1, 2}, 5)}) {
    CAPTURE(obstacle.name);
    const Vector2d n = obstacle.look(x).normal;
    const Vector2d t(-n.y(), n.x());
    const auto rate = [&](const Vector2d& direction) {
      return (obstacle.look(x + h * direction).gap - obstacle.look(x - h * direction).gap) /
             (2 * h);
    };
    CHECK(rate(n) == Approx(1).epsilon(1e-9));
    CHECK(rate(t) == Approx(0).margin(1e-9));
  }
  // A profile: the normal is that of the curve below the point, exact where the point touches it.
  const Vector2d foot(0.4, 0.3 * std::sin(0.8));
  const Vector2d n = wave().look(foot).normal;
  CHECK((wave().look(foot + h * n).gap - wave().look(foot - h * n).gap) / (2 * h) ==
        Approx(1).epsilon(1e-9));
}

TEST_CASE("the gap over a profile is the distance, up to gap^2 times curvature",
          "[obstacle][XuanLi2002-2]") {
  const Obstacle curve = wave();
  const Vector2d foot(0.4, 0.3 * std::sin(0.8));
  const double curvature = 1.2 * std::sin(0.8);
  const Vector2d n = curve.look(foot).normal;
  for (const double distance : {1e-2, 1e-3}) {
    CAPTURE(distance);
    const double error = curve.look(foot + distance * n).gap - distance;
    CHECK(std::abs(error) < curvature * distance * distance);
  }
}

TEST_CASE("a straight profile is a half-plane", "[obstacle]") {
  const Obstacle line = profile([](double x) { return 0.5 * x - 1; }, [](double) { return 0.5; });
  const Obstacle plane = half_plane({0, -1}, {-0.5, 1});
  for (const Vector2d& x : {Vector2d(0, 0), Vector2d(3, -2), Vector2d(-1, 4)}) {
    CHECK(line.look(x).gap == Approx(plane.look(x).gap).epsilon(1e-14).margin(1e-15));
    CHECK((line.look(x).normal - plane.look(x).normal).norm() < 1e-15);
  }
}

TEST_CASE("an obstacle that cannot be is refused by name", "[obstacle]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(problem_message([] {
               static_cast<void>(half_plane({0, 0}, {0, 0}));
             }),
             ContainsSubstring("'half plane'") && ContainsSubstring("normal of positive length"));
  CHECK_THAT(problem_message([&] {
               static_cast<void>(half_plane({nan, 0}, {0, 1}));
             }),
             ContainsSubstring("'half plane'"));
  CHECK_THAT(problem_message([] {
               static_cast<void>(disc({0, 0}, 0));
             }),
             ContainsSubstring("'disc'") && ContainsSubstring("radius must be positive"));
  CHECK_THAT(problem_message([] {
               static_cast<void>(hole({0, 0}, -2));
             }),
             ContainsSubstring("'hole'") && ContainsSubstring("got -2"));
  CHECK_THAT(problem_message([] {
               static_cast<void>(hole({1, 2}, 3).look({1, 2}));
             }),
             ContainsSubstring("centre"));
}

TEST_CASE("a profile that is not finite names the place", "[obstacle]") {
  const auto message = [](const Obstacle& obstacle) {
    return problem_message([&] { static_cast<void>(obstacle.look({-2.5, 0})); });
  };
  CHECK_THAT(message(profile([](double x) { return std::sqrt(x); }, [](double) { return 0.0; })),
             ContainsSubstring("'profile'") && ContainsSubstring("at x = -2.5"));
  CHECK_THAT(message(profile([](double) { return 0.0; },
                             [](double) { return std::numeric_limits<double>::infinity(); })),
             ContainsSubstring("slope inf") && ContainsSubstring("x = -2.5"));
}

TEST_CASE("the pin in a hole is the linear part of a disc", "[obstacle]") {
  // Shift and play get smaller together: the difference falls with their square.
  double before = 1;
  for (const double size : {0.1, 0.01, 0.001}) {
    const signorini::Obstacle pin = signorini::pin_in_hole({1, 2}, size, {0.6 * size, 0.8 * size});
    const signorini::Obstacle disc = signorini::disc({1 + 0.6 * size, 2 + 0.8 * size}, 3 - size);
    double difference = 0;
    for (int k = 0; k < 24; ++k) {
      const Eigen::Vector2d n(std::cos(0.3 * k), std::sin(0.3 * k));
      const Eigen::Vector2d x = Eigen::Vector2d(1, 2) + 3 * n;
      CHECK((pin.look(x).normal - n).norm() < 1e-15);
      CHECK(pin.look(x).gap == Approx(size * (1 - 0.6 * n.x() - 0.8 * n.y())).margin(1e-16));
      difference = std::max(difference, std::abs(pin.look(x).gap - disc.look(x).gap));
    }
    CHECK(difference <= size * size / 2 / 3 * 1.1);
    CHECK(difference < before / 90);
    before = difference;
  }
  CHECK_THROWS_AS(signorini::pin_in_hole({0, 0}, std::nan(""), {0, 0}), signorini::ProblemError);
  CHECK_THROWS_AS(signorini::pin_in_hole({0, 0}, 1, {0, 0}).look({0, 0}), signorini::ProblemError);
}
