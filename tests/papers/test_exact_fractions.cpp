// Exact fractions beside the printed method in floating point: the same points in every step.
#include "../chapters/ch04_quasi_active_set/last_step.hpp"
#include "catch_compat.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/closest_point.hpp"
#include "support/exact.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using exact::Fraction;
using namespace signorini;
using namespace signorini_test;

namespace {

exact::Vector whole(const VectorXd& x) {
  exact::Vector result;
  for (const double value : x) result.emplace_back(static_cast<long long>(value));
  return result;
}

exact::Programme exact_programme(const ClosestPoint& point) {
  exact::Programme q{{}, whole(point.g), whole(point.p)};
  for (const auto row : point.A.rowwise()) q.A.push_back(whole(row.transpose()));
  return q;
}

VectorXd floating(const exact::Vector& x) {
  VectorXd result(static_cast<Index>(x.size()));
  for (Index i = 0; i < result.size(); ++i) result(i) = x[static_cast<std::size_t>(i)].value();
  return result;
}

}  // namespace

TEST_CASE(
    "fractions are in lowest terms with a positive denominator, and say when they are too long",
    "[exact]") {
  CHECK(Fraction(6, -4).text() == "-3/2");
  CHECK(Fraction(8, 4).text() == "2");
  CHECK((Fraction(1, 6) + Fraction(1, 10)).text() == "4/15");
  CHECK((Fraction(1, 6) - Fraction(1, 6) == Fraction()));
  CHECK((Fraction(-7, 6) * Fraction(3, 14)).text() == "-1/4");
  CHECK((Fraction(1, 3) / Fraction(-2, 3)).text() == "-1/2");
  CHECK((Fraction(-1, 2) < Fraction(1, 3) && !(Fraction(1, 3) < Fraction(1, 3))));
  CHECK(Fraction(1, 3).value() == 1.0 / 3);
  CHECK_THROWS_AS(Fraction(1, 0), std::domain_error);
  CHECK_THROWS_AS(Fraction(4'000'000'007) * Fraction(4'000'000'009), std::overflow_error);
  CHECK(exact::text_of(exact::solve({{0, 2}, {3, 1}}, {1, 1})) == "(1/6, 1/2)");
  CHECK(exact::solve({{1, 2}, {2, 4}}, {1, 1}).empty());
}

TEST_CASE("the point found by trying every set in fractions is that of enumeration", "[exact]") {
  Random random(6);
  for (int sample = 0; sample < 30; ++sample) {
    const ClosestPoint point = eight_half_spaces(random);
    const exact::Programme q = exact_programme(point);
    const exact::Rest best = closest(q, {0, 1, 2, 3, 4, 5, 6, 7}, q.p);
    CHECK(rows_with(q, best.u, -1).empty());
    const VectorXd u = point.displacement(enumerate(point.problem()));
    CHECK((u - floating(best.u)).norm() <= 1e-13 * point.p.norm());
    CHECK(point.energy(u) ==
          Approx(energy(q, best.u).value()).margin(1e-13 * point.p.squaredNorm()));
  }
}

TEST_CASE("the first steps of the printed loop are those in fractions, whatever rows they take",
          "[exact][literal]") {
  Random random(7);
  int followed = 0;
  for (int sample = 0; sample < 30; ++sample) {
    const ClosestPoint point = eight_half_spaces(random);
    const exact::Programme q = exact_programme(point);
    for (const QuasiActiveRows choice :
         {QuasiActiveRows::AllViolated, QuasiActiveRows::IndependentByIndex,
          QuasiActiveRows::IndependentByViolation, QuasiActiveRows::MostViolated}) {
      exact::Vector u = q.p;
      SolverOptions stop;
      for (stop.iteration_limit = 1; stop.iteration_limit <= 3; ++stop.iteration_limit) {
        const QuasiActiveRun run = run_quasi_active_set_literal(point.problem(), stop, choice);
        const auto step = static_cast<std::size_t>(stop.iteration_limit) - 1;
        if (run.steps.size() <= step || run.state.report.status != SolveStatus::IterationLimit)
          break;
        const std::vector<Index>& rows = run.steps[step].quasi_active;
        const std::vector<Index>& violated = run.steps[step].violated;
        CHECK(rows_with(q, u, -1) == exact::Set(violated.begin(), violated.end()));
        u = closest(q, {rows.begin(), rows.end()}, u).u;
        CHECK((point.displacement(run.state) - floating(u)).norm() <= 1e-12 * point.p.norm());
        ++followed;
      }
    }
  }
  CHECK(followed > 100);
}

// From u^k = 0, with x - 2y <= 6 the nearer of the two open rows.
TEST_CASE("(33) with a row that is not closed may end farther from u^0 than with the tight row",
          "[exact][XuanLi2002-33][XuanLi2002-34][XuanLi2002-35]") {
  const exact::Programme q = {{{0, 0, 1}, {1, 1, 0}, {1, -2, 0}}, {0, 5, 6}, {10, 0, 1}};
  const exact::Vector u = {0, 0, 0};
  const auto squared = [&](const exact::Vector& end) {
    const exact::Vector off = exact::along(end, -1, q.p);
    return dot(off, off);
  };
  const ch04::LastStep tight = ch04::last_step(q, u);
  CHECK(exact::text_of(tight.end) == "(5, 0, 0)");
  CHECK(squared(tight.end).text() == "26");
  const ch04::LastStep more = ch04::last_step(q, u, {0, 2});
  CHECK(more.delta.text() == "25/54");
  CHECK(exact::text_of(more.end) == "(115/27, 20/27, 0)");
  CHECK(squared(tight.end) < squared(more.end));
  CHECK(rows_with(q, more.end, -1).empty());
}
