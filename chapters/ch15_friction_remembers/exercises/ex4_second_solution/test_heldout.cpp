#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/solvers/lemke.hpp"
#include "support/random.hpp"

using ex15_4::all_answers;
using ex15_4::Answer;
using ex15_4::Pair;
using signorini::ContactStatus;

namespace {

Pair random_pair(signorini_test::Random& random, double coefficient, double cohesion) {
  Eigen::Matrix2d C;
  for (double& entry : C.reshaped()) entry = random.uniform(-1, 1);
  const Eigen::Matrix2d F = C * C.transpose() + 0.05 * Eigen::Matrix2d::Identity();
  return {F, random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, coefficient),
          random.uniform(0, cohesion)};
}

void check_law(const Pair& pair, const Answer& answer) {
  const double gap =
      pair.free_gap + pair.compliance.row(0).dot(Eigen::RowVector2d(answer.force, answer.friction));
  const double slip = pair.free_slip +
                      pair.compliance.row(1).dot(Eigen::RowVector2d(answer.force, answer.friction));
  if (answer.contact_status == ContactStatus::Open) {
    CHECK(gap >= 0);
    CHECK(answer.force == 0);
    CHECK(answer.friction == 0);
    return;
  }
  const double bound = pair.coefficient * answer.force + pair.cohesion;
  CHECK(answer.force >= 0);
  CHECK(gap == Approx(0).margin(1e-11 * (1 + answer.force)));
  CHECK(std::abs(answer.friction) <= bound * (1 + 1e-12) + 1e-14);
  if (answer.contact_status == ContactStatus::Stick)
    CHECK(slip == Approx(0).margin(1e-11 * (1 + answer.force)));
  if (answer.contact_status == ContactStatus::SlipForward) {
    CHECK(slip > 0);
    CHECK(answer.friction == Approx(-bound).epsilon(1e-12));
  }
  if (answer.contact_status == ContactStatus::SlipBackward) {
    CHECK(slip < 0);
    CHECK(answer.friction == Approx(bound).epsilon(1e-12));
  }
}

}  // namespace

// Without cohesion there is one answer or three, apart from ties; and what the library finds is one of them.
TEST_CASE("ex15.4 held out: random pairs", "[ex15.4]") {
  signorini_test::Random random(4);
  int several = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Pair pair = random_pair(random, 6, 0);
    CAPTURE(trial);
    const std::vector<Answer> found = all_answers(pair);
    CHECK(found.size() % 2 == 1);
    several += found.size() == 3;
    for (const Answer& answer : found) check_law(pair, answer);
    signorini::ContactProblem problem;
    problem.compliance = pair.compliance;
    problem.free_gap = Eigen::VectorXd::Constant(1, pair.free_gap);
    problem.free_slip = Eigen::VectorXd::Constant(1, pair.free_slip);
    problem.law = signorini::law_of_all(Eigen::VectorXd::Constant(1, pair.coefficient),
                                        Eigen::VectorXd::Zero(1));
    const signorini::ContactState state = signorini::lemke(problem);
    REQUIRE(state.report.status == signorini::SolveStatus::Solved);
    bool known = false;
    for (const Answer& answer : found)
      known = known || (answer.contact_status == state.contact_status[0] &&
                        std::abs(answer.force - state.force(0)) <= 1e-9 * (1 + answer.force));
    CHECK(known);
  }
  CHECK(several > 20);
}

TEST_CASE("ex15.4 held out: cohesion holds a pair that only touches, and not an open one",
          "[ex15.4]") {
  signorini_test::Random random(5);
  for (int trial = 0; trial < 500; ++trial) {
    CAPTURE(trial);
    const Pair pair = random_pair(random, 2, 0.5);
    for (const Answer& answer : all_answers(pair)) check_law(pair, answer);
  }
  const Eigen::Matrix2d F = Eigen::Vector2d(2, 4).asDiagonal();
  const std::vector<Answer> glued = all_answers({F, -6, 8, 0.5, 1});
  REQUIRE(glued.size() == 1);
  CHECK(glued[0].contact_status == ContactStatus::Stick);
  CHECK(glued[0].friction == Approx(-2).epsilon(1e-14));
  const std::vector<Answer> slides = all_answers({F, -6, 8, 0, 1});
  REQUIRE(slides.size() == 1);
  CHECK(slides[0].contact_status == ContactStatus::SlipForward);
  CHECK(slides[0].friction == Approx(-1).epsilon(1e-14));
}

TEST_CASE("ex15.4 held out: a mirror exchanges forward and backward", "[ex15.4]") {
  signorini_test::Random random(6);
  for (int trial = 0; trial < 500; ++trial) {
    CAPTURE(trial);
    const Pair pair = random_pair(random, 6, 0);
    Pair mirrored = pair;
    mirrored.compliance(0, 1) *= -1;
    mirrored.compliance(1, 0) *= -1;
    mirrored.free_slip *= -1;
    const std::vector<Answer> one = all_answers(pair), two = all_answers(mirrored);
    REQUIRE(one.size() == two.size());
    for (const Answer& answer : one) {
      bool found = false;
      for (const Answer& other : two)
        found = found || (other.force == Approx(answer.force).epsilon(1e-12).margin(1e-12) &&
                          other.friction == Approx(-answer.friction).epsilon(1e-12).margin(1e-12));
      CHECK(found);
    }
  }
}
