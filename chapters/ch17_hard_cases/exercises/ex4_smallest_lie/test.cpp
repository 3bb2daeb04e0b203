#include <limits>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using ex17_4::smallest_lie;
using signorini::ContactProblem;
using signorini::ContactState;

static ContactState solved(const ContactProblem& problem) {
  return signorini::primal_dual_active_set(problem, {});
}

TEST_CASE("ex17.4 one pair", "[ex17.4]") {
  const ContactProblem problem{Eigen::MatrixXd::Ones(1, 1), -VectorXd::Ones(1)};
  for (const double accepted : {1e-12, 1e-9, 1e-3})
    CHECK(smallest_lie(problem, solved(problem), 0, accepted) == Approx(accepted).epsilon(0.01));
}

TEST_CASE("ex17.4 a force of zero has no share", "[ex17.4]") {
  const ContactProblem problem{Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-1, 1)};
  const ContactState state = solved(problem);
  CHECK(smallest_lie(problem, state, 1, 1e-12) == std::numeric_limits<double>::infinity());
}

// The larger force of two that do not feel each other is seen sooner: figures are measured by the largest.
TEST_CASE("ex17.4 small forces have more room", "[ex17.4]") {
  const ContactProblem problem{Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-1, -0.01)};
  const ContactState state = solved(problem);
  const double large = smallest_lie(problem, state, 0, 1e-12);
  const double small = smallest_lie(problem, state, 1, 1e-12);
  CHECK(large == Approx(1e-12).epsilon(0.01));
  CHECK(small == Approx(100 * large).epsilon(0.02));
}
