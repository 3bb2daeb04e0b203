#include <cmath>
#include <stdexcept>

#include "../chapters/ch08_complementarity/functions.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex8_3;
using Residuals = std::vector<double>;

// Runs of the table of the chapter.
static const signorini::ContactProblem touching{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(),
                                                Eigen::Vector2d(-2, -1)};
static const signorini::ContactProblem three{
    (Eigen::Matrix3d() << 4, -6, -4, -6, 10, 8, -4, 8, 9).finished(), Eigen::Vector3d(3, -4, -1)};

static Residuals run(const signorini::ContactProblem& problem, std::size_t which) {
  return newton(problem, signorini::functions[which], 0 * problem.free_gap, {1e-10, 0}).residuals;
}

TEST_CASE("ex8.3 digits, by hand", "[ex8.3]") {
  const Residuals gains = digits_gained({100, 10, 1, 10, 1e-3});
  REQUIRE(gains.size() == 4);
  CHECK(gains[0] == Approx(1).epsilon(1e-14));
  CHECK(gains[2] == Approx(-1).epsilon(1e-14));
  CHECK(gains[3] == Approx(4).epsilon(1e-14));
}

TEST_CASE("ex8.3 four runs by hand", "[ex8.3]") {
  CHECK(fate({1, 1e-1, 1e-2, 1e-3}) == Fate::Steady);
  CHECK(fate({1, 1e-1, 1e-3, 1e-7}) == Fate::Quick);
  CHECK(fate({3, 2, 5, 2, 5}) == Fate::Round);
  CHECK(fate({1, 2, 1, 3}) == Fate::Unclear);
  CHECK(fate({1, 10, 1, 1e-2}) == Fate::Unclear);       // a step back before the gains grow
  CHECK(fate({1, 1e-1, 1e-2, 3e-3}) == Fate::Unclear);  // the last gain is half as large
  CHECK(period({1, 2, 1, 3}) == 0);
  CHECK(period({3, 2, 5, 2, 5}) == 2);
  CHECK(period({1, 1e-1, 1e-2, 1e-3}) == 0);
}

TEST_CASE("ex8.3 the fates of three functions of the chapter", "[ex8.3][LinEtAl-12]") {
  CHECK(fate(run(touching, 0)) == Fate::Quick);
  CHECK(fate(run(touching, 4)) == Fate::Steady);
  CHECK(fate(run(three, 1)) == Fate::Round);
  const Residuals circle = run(three, 1);
  const int p = period(circle);
  REQUIRE(p > 1);
  for (std::size_t k = circle.size() - 20; k < circle.size(); ++k)
    CHECK(circle[k] == Approx(circle[k - static_cast<std::size_t>(p)]).epsilon(1e-9));
}

// Cut a run short, and compare the forecast with what came.
TEST_CASE("ex8.3 the forecast of a steady run", "[ex8.3]") {
  const Residuals whole = run(touching, 4);
  const Residuals part(whole.begin(), whole.begin() + 8);
  const auto left = steps_left(part, 1.0001 * whole.back());
  REQUIRE(left);
  CHECK(std::abs(*left - static_cast<int>(whole.size() - part.size())) <= 1);
  CHECK_FALSE(steps_left(run(three, 1), 1e-10));
  CHECK(steps_left({1, 1e-1, 1e-3, 1e-7}, 2e-15) == 1);
  CHECK(steps_left({1, 1e-1, 1e-3, 1e-7}, 5e-16) == 2);
  CHECK(steps_left({1, 1e-1, 1e-3, 1e-9}, 1e-25) ==
        2);  // gains of 1, 2 and 6 digits, then 12 and 24
  // 1, 1.6 and 2.56 digits, then 4.1 and 6.6
  CHECK(steps_left({1, 1e-1, std::pow(10, -2.6), std::pow(10, -5.16)}, 1e-10) == 2);
}

TEST_CASE("ex8.3 three residuals are too few", "[ex8.3]") {
  CHECK_THROWS_AS(digits_gained({1, 0.1, 0.01}), std::invalid_argument);
}

TEST_CASE("ex8.3 a residual of zero ends a run", "[ex8.3]") {
  CHECK(digits_gained({1, 0.1, 0.01, 0}).back() == HUGE_VAL);
  CHECK_THROWS_AS(digits_gained({1, 0, 0.1, 0.01}), std::invalid_argument);
}
