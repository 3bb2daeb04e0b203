#include <limits>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

using Eigen::Index;
using ex17_4::smallest_lie;
using signorini::ContactProblem;
using signorini::ContactState;

static ContactProblem string(Index n) {
  Eigen::MatrixXd G(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      G(i, j) = static_cast<double>((std::min(i, j) + 1) * (n - std::max(i, j)));
  return {G, -(G * Eigen::VectorXd::LinSpaced(n, 1, 2))};
}

TEST_CASE("ex17.4 held out: the share divides what is seen from what is not", "[ex17.4]") {
  for (const Index n : {3, 8}) {
    const ContactProblem problem = string(n);
    const ContactState state = signorini::primal_dual_active_set(problem, {});
    REQUIRE(state.report.status == signorini::SolveStatus::Solved);
    for (Index pair = 0; pair < n; ++pair)
      for (const double accepted : {1e-11, 1e-6}) {
        CAPTURE(n, pair, accepted);
        const double share = smallest_lie(problem, state, pair, accepted);
        const auto worst = [&](double lie) {
          ContactState other = state;
          other.force(pair) *= 1 + lie;
          return certify(problem, other).worst();
        };
        CHECK(worst(share * 1.001) > accepted);
        CHECK(worst(share * 0.999) <= accepted);
      }
  }
}

TEST_CASE("ex17.4 held out: units change nothing", "[ex17.4]") {
  const ContactProblem problem = string(5);
  const ContactState state = signorini::primal_dual_active_set(problem, {});
  const double share = smallest_lie(problem, state, 2, 1e-9);
  for (const double length : {1e-9, 1e9}) {
    const ContactProblem other{problem.compliance * length, problem.free_gap * length};
    ContactState same = state;
    same.gap *= length;
    CHECK(smallest_lie(other, same, 2, 1e-9) == Approx(share).epsilon(1e-5));
  }
}

// What is accepted however large the lie is has no smallest lie.
TEST_CASE("ex17.4 held out: nobody looks", "[ex17.4]") {
  const ContactProblem problem = string(3);
  const ContactState state = signorini::primal_dual_active_set(problem, {});
  CHECK(smallest_lie(problem, state, 0, 1e3) == std::numeric_limits<double>::infinity());
}
