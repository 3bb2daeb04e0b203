#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "../chapters/ch07_rigid_pin/pin.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex7_5;
using Eigen::Index;
using Eigen::VectorXd;

static HeldPlate of_chapter(const ch07::Pin& pin, const ch07::Bearing& held) {
  const signorini::ContactProblem& problem = held.run.condensed.problem;
  return {problem.compliance, problem.free_gap,
          pin.side() * held.run.model.pairs.position.col(0) / ch07::hole_radius,
          std::abs(pin.q) * ch07::plate_size / 2};
}

TEST_CASE("ex7.5 held out: the plate of the chapter, pulled and pressed", "[ex7.5]") {
  for (const ch07::Pin& pin : {ch07::tension, ch07::compression}) {
    const ch07::Bearing held = ch07::on_even_mesh(pin, 18, 6);
    const Bearing free = pole_free(of_chapter(pin, held));
    const VectorXd& expected = held.run.solution.contact.force;
    REQUIRE(free.force.size() == expected.size());
    CHECK(equal_within(free.force, expected, 1e-9 * expected.norm()));
    CHECK(free.pole_force == Approx(held.force(0)).epsilon(1e-9));
    CHECK(free.pole_gap == Approx(0).margin(1e-12));
  }
}

// A pin with a flat on its nose: all gaps but that of the pole are less by the same amount.
TEST_CASE("ex7.5 held out: a flat at the pole lifts it off", "[ex7.5]") {
  const ch07::Bearing held = ch07::on_even_mesh(ch07::compression, 18, 6);
  HeldPlate plate = of_chapter(ch07::compression, held);
  plate.free_gap.array() -= 0.2;
  const Bearing free = pole_free(plate);
  CHECK(free.pole_force == Approx(0).margin(1e-9));
  CHECK(free.pole_gap > 0.1);
  CHECK(plate.cosine.dot(free.force) == Approx(plate.load).epsilon(1e-9));
  const VectorXd gap =
      plate.free_gap + plate.compliance * free.force + plate.cosine * free.pole_gap;
  CHECK(gap.minCoeff() > -1e-9);
  CHECK(std::abs(gap.dot(free.force)) < 1e-8);
}

TEST_CASE("ex7.5 held out: units do not matter", "[ex7.5][units]") {
  const Eigen::Matrix2d G = (Eigen::Matrix2d() << 2, 1, 1, 3).finished();
  const HeldPlate plain{G, Eigen::Vector2d(-30, 2), Eigen::Vector2d(0.9, 0.3), 5};
  const Bearing one = pole_free(plain);
  for (const double length : {1e-6, 1e6})
    for (const double force : {1e-6, 1e6}) {
      const HeldPlate other{G * (length / force), plain.free_gap * length, plain.cosine,
                            plain.load * force};
      const Bearing there = pole_free(other);
      CAPTURE(length, force);
      CHECK(there.pole_gap / length == Approx(one.pole_gap).epsilon(1e-9));
      CHECK(equal_within(there.force / force, one.force, 1e-9));
    }
}

TEST_CASE("ex7.5 held out: pairs behind the pin push back, and the pole alone bears all",
          "[ex7.5]") {
  const HeldPlate behind{Eigen::MatrixXd::Ones(1, 1), VectorXd::Constant(1, -1),
                         VectorXd::Constant(1, -0.5), 2};
  CHECK(pole_free(behind).force(0) == Approx(1).epsilon(1e-12));
  CHECK(pole_free(behind).pole_force == Approx(2.5).epsilon(1e-12));
  const Bearing alone = pole_free({Eigen::MatrixXd(0, 0), VectorXd(0), VectorXd(0), 3});
  CHECK(alone.pole_force == Approx(3).epsilon(1e-12));
  CHECK(alone.force.size() == 0);
}

TEST_CASE("ex7.5 held out: sizes that do not fit are refused", "[ex7.5]") {
  const VectorXd two = VectorXd::Ones(2), three = VectorXd::Ones(3);
  const Eigen::MatrixXd G = Eigen::MatrixXd::Identity(2, 2);
  CHECK_THROWS_AS(pole_free({G, three, two, 1}), std::invalid_argument);
  CHECK_THROWS_AS(pole_free({G, two, three, 1}), std::invalid_argument);
  CHECK_THROWS_AS(pole_free({Eigen::MatrixXd::Identity(2, 3), two, two, 1}), std::invalid_argument);
}
