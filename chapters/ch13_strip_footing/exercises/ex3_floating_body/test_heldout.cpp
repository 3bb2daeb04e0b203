#include "../chapters/ch13_strip_footing/footing.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex13_3;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

FloatingBody bar(Index n, double stiffness, double length) {
  FloatingBody body{MatrixXd::Zero(n, n), VectorXd::Ones(n),
                    VectorXd::LinSpaced(n, -1, 2) * stiffness * length, MatrixXd::Zero(2, n),
                    Eigen::Vector2d(0.3, -0.2) * length};
  for (Index i = 0; i + 1 < n; ++i)
    body.stiffness.block<2, 2>(i, i) += stiffness * (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
  body.A(0, 0) = -1;
  body.A(1, n - 1) = 1;
  return body;
}

/// What the footing of the chapter is made of, with the amplitude that the library found.
struct Solved {
  FloatingBody body;
  std::vector<Index> closed;
  VectorXd force, displacement;
};

Solved footing() {
  const signorini::SolvedScene run = ch13::settle(ch13::soil_of(3, 3, 2, 2, 6), {1, 2, 1e6});
  const signorini::QuadraticProgramme& programme = run.model.programme;
  const signorini::PrimalDual& refined = run.solution.refined;
  REQUIRE(run.model.modes.size() == 1);
  const VectorXd u = refined.displacement;
  return {{MatrixXd(programme.stiffness), run.model.modes[0].shape, programme.load,
           MatrixXd(programme.A), programme.initial_gap},
          run.solution.contact.active(),
          refined.force,
          u};
}

}  // namespace

// The node that touches may be the one that is held: it has no compliance then.
TEST_CASE("ex13.3 held out: held where it touches", "[ex13.3]") {
  const FloatingBody body = bar(5, 3, 1);
  for (const std::vector<Index>& closed :
       {std::vector<Index>{1}, std::vector<Index>{0, 1}, std::vector<Index>{1, 0}}) {
    const Rest inside = rest_of(body, 2, closed), at_the_end = rest_of(body, 4, closed);
    REQUIRE(at_the_end.displacement.size() == 5);
    CHECK(equal_within(inside.force, at_the_end.force, 1e-12));
    CHECK(equal_within(inside.displacement, at_the_end.displacement, 1e-12));
    CHECK(at_the_end.amplitude == Approx(at_the_end.displacement(4)).epsilon(1e-12));
  }
}

TEST_CASE("ex13.3 held out: units, and a motion twice as long", "[ex13.3]") {
  const Rest plain = rest_of(bar(6, 1, 1), 3, {0, 1});
  for (const double stiffness : {1e-9, 1e9})
    for (const double length : {1e-6, 1e6}) {
      CAPTURE(stiffness, length);
      FloatingBody body = bar(6, stiffness, length);
      body.motion *= 2;
      const Rest other = rest_of(body, 3, {0, 1});
      REQUIRE(other.displacement.size() == 6);
      CHECK(equal_within(other.displacement / length, plain.displacement, 1e-11));
      CHECK(equal_within(other.force / (stiffness * length), plain.force, 1e-11));
      CHECK(2 * other.amplitude / length == Approx(plain.amplitude).epsilon(1e-11));
    }
}

TEST_CASE("ex13.3 held out: a pair that the load does not press has no force", "[ex13.3]") {
  FloatingBody body = bar(4, 1, 1);
  body.load << 1, -1, 2, -2;
  CHECK(rest_of(body, 0, {1}).force.norm() < 1e-13);
}

// The footing on its soil: one motion moves one body of two, along y.
TEST_CASE("ex13.3 held out: the footing of the chapter", "[ex13.3]") {
  const Solved known = footing();
  Index held = 0, still = 0;
  known.body.motion.cwiseAbs().maxCoeff(&held);
  known.body.motion.cwiseAbs().minCoeff(&still);
  const Rest rest = rest_of(known.body, held, known.closed);
  REQUIRE(rest.force.size() == known.force.size());
  CHECK(equal_within(rest.force, known.force, 1e-9 * known.force.norm()));
  CHECK(equal_within(rest.displacement, known.displacement, 1e-9 * known.displacement.norm()));
  CHECK_THROWS_AS(rest_of(known.body, still, known.closed), std::invalid_argument);
}
