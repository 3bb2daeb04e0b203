#include <cmath>

#include "catch_compat.hpp"
#include "papers/linear_programme.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/message.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// A problem that has gaps of at least 0.1 without load.
struct Loaded {
  ContactProblem problem;
  VectorXd initial_gap;
};

Loaded loaded(Random& random, Index n) {
  Loaded result{random_problem(random, n), VectorXd(n)};
  for (Index i = 0; i < n; ++i) result.initial_gap(i) = random.uniform(0.1, 1);
  return result;
}

Index pivots(const std::vector<ContactState>& states) {
  Index sum = 0;
  for (const ContactState& state : states) sum += state.report.iterations;
  return sum;
}

}  // namespace

TEST_CASE("the linear programme agrees with the trial of all sets on random problems",
          "[linear_programme]") {
  Random random(22);
  for (int sample = 0; sample < 200; ++sample) {
    const ContactProblem problem = random_problem(random, random.whole(1, 8));
    const ContactState state = linear_programme(problem);
    const ContactState reference = enumerate(problem);
    CAPTURE(sample);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(state.active() == reference.active());
    CHECK((state.force - reference.force).norm() <= 1e-12 * reference.force.norm());
    CHECK(certify(problem, state).worst() <= 1e-13);
  }
}

TEST_CASE("one pair at a time: at least as many pivots as closed pairs, and not many more",
          "[linear_programme]") {
  Random random(4);
  for (const Index n : {5, 20, 80}) {
    const ContactState state = linear_programme(random_problem(random, n));
    REQUIRE(state.report.status == SolveStatus::Solved);
    const Index closed = static_cast<Index>(state.active().size());
    CAPTURE(n, state.report.iterations, closed);
    CHECK(state.report.iterations >= closed);
    CHECK(state.report.iterations <= 8 * n);  // measured: 2.2 n at n = 200
  }
}

TEST_CASE("the sum of artificial gaps never rises", "[linear_programme]") {
  const ContactState state = linear_programme(string_problem(60));
  REQUIRE(state.report.history.size() == static_cast<std::size_t>(state.report.iterations));
  double last = 1 + 1e-12;  // the sum is recomputed from rounded numbers
  for (const Iteration& pivot : state.report.history) {
    CHECK(pivot.residual <= last + 1e-12);
    last = pivot.residual;
  }
  CHECK(last <= 1e-12);
}

TEST_CASE("pivots do not know the scale of a row nor units", "[linear_programme][units]") {
  Random random(5);
  for (int sample = 0; sample < 20; ++sample) {
    const ContactProblem problem = random_problem(random, 12);
    const ContactState state = linear_programme(problem);
    VectorXd row(12);
    for (Index i = 0; i < 12; ++i) row(i) = std::pow(10.0, random.whole(-8, 8));
    const ContactState scaled = linear_programme(with_rows(problem, row));
    CHECK(scaled.report.iterations == state.report.iterations);
    CHECK(scaled.active() == state.active());
    CHECK((row.cwiseProduct(scaled.force) - state.force).norm() <= 1e-12 * state.force.norm());
    const ContactState in_metres = linear_programme(in_units(problem, 1e-6, 1e6));
    CHECK(in_metres.report.iterations == state.report.iterations);
  }
}

TEST_CASE("increments of load end where one step ends", "[linear_programme]") {
  Random random(7);
  for (const Index increments : {1, 2, 10, 37}) {
    const Loaded load = loaded(random, 15);
    const ContactState once = linear_programme(load.problem);
    const std::vector<ContactState> steps =
        incremental_linear_programme(load.problem, load.initial_gap, increments);
    REQUIRE(steps.size() == static_cast<std::size_t>(increments));
    for (const ContactState& step : steps) CHECK(step.report.status == SolveStatus::Solved);
    CHECK(steps.back().active() == once.active());
    CHECK((steps.back().force - once.force).norm() <= 1e-13 * once.force.norm());
  }
}

TEST_CASE("each increment is a solution for its own load", "[linear_programme]") {
  Random random(8);
  const Loaded load = loaded(random, 10);
  const std::vector<ContactState> steps =
      incremental_linear_programme(load.problem, load.initial_gap, 4);
  REQUIRE(steps.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    const double t = static_cast<double>(k + 1) / 4;
    const ContactProblem part{load.problem.compliance,
                              (1 - t) * load.initial_gap + t * load.problem.free_gap};
    CHECK(certify(part, steps[k]).worst() <= 1e-13);
  }
}

TEST_CASE("an increment that changes no pair needs no pivot", "[linear_programme]") {
  // Every gap closes at the first increment and stays closed while the load grows in proportion.
  Random random(9);
  ContactProblem problem = random_problem(random, 6);
  problem.free_gap = -problem.compliance * VectorXd::Ones(6);
  const std::vector<ContactState> steps =
      incremental_linear_programme(problem, VectorXd::Zero(6), 5);
  REQUIRE(steps.size() == 5);
  CHECK(steps.front().report.iterations >= 6);
  CHECK(pivots(steps) == steps.front().report.iterations);
}

TEST_CASE("restricted entry stalls on a pair written twice with two gaps, and says so",
          "[linear_programme]") {
  // Force 2 on the second solves this; but once the first force has joined, its own gap may not, and no
  // other variable changes the overlap that is left.
  const ContactProblem twice{Eigen::MatrixXd::Ones(2, 2), Vector2d(-1, -2)};
  const ContactState state = linear_programme(twice);
  CHECK(state.report.status == SolveStatus::Breakdown);
  CHECK(state.farkas_certificate.size() == 0);
  CHECK(enumerate(twice).report.status == SolveStatus::Solved);
}

TEST_CASE("prices prove that gaps contradict each other", "[linear_programme]") {
  Eigen::Matrix2d G;
  G << 4, -2, -2, 1;  // two walls that face each other, the second gap in half units
  const Vector2d d(-1, -0.25);
  const ContactState state = linear_programme({G, d});
  REQUIRE(state.report.status == SolveStatus::Infeasible);
  const VectorXd& y = state.farkas_certificate;
  REQUIRE(y.size() == 2);
  CHECK((y.array() >= 0).all());
  CHECK((G * y).norm() <= 1e-15 * y.norm());
  CHECK(d.dot(y) < 0);
}

TEST_CASE("a limit on the pivots is kept and said", "[linear_programme]") {
  const ContactState state = linear_programme(string_problem(40), {3});
  CHECK(state.report.status == SolveStatus::IterationLimit);
  CHECK(state.report.iterations == 3);
}

TEST_CASE("increments that cannot be are refused", "[linear_programme]") {
  const ContactProblem one{Eigen::MatrixXd::Ones(1, 1), VectorXd::Ones(1)};
  CHECK_THAT(argument_message([&] {
               static_cast<void>(incremental_linear_programme(one, VectorXd::Ones(2), 1));
             }),
             ContainsSubstring("need 1 finite initial gaps, got 2"));
  CHECK_THAT(argument_message([&] {
               static_cast<void>(incremental_linear_programme(one, VectorXd::Ones(1), 0));
             }),
             ContainsSubstring("at least 1 increment, got 0"));
}
