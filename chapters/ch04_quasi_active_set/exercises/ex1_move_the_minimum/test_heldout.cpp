#include <algorithm>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "signorini/core/dense.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;

namespace {

ex4_1::Moved move(const DenseProgramme& q, const VectorXd& u) {
  return ex4_1::move_minimum(q.stiffness, q.A, q.initial_gap, u);
}

}  // namespace

TEST_CASE("ex4.1 held out: three steps of random programmes are those of the library", "[ex4.1]") {
  const std::uint64_t seed = GENERATE(range(1U, 31U));
  const DenseProgramme q = rosen_suzuki(12, 9, seed).programme;
  const CholeskyFactor K(q.stiffness);
  const ContactProblem problem = condense(q).problem;
  VectorXd u = K.solve(q.load);
  VectorXd force = VectorXd::Zero(9);
  for (Index k = 1; k <= 3; ++k) {
    const ex4_1::Moved moved = move(q, u);
    REQUIRE(moved.displacement.size() == 12);
    REQUIRE(moved.weights.size() == static_cast<Index>(moved.violated.size()));
    if (moved.violated.empty()) break;
    CHECK(moved.weights.minCoeff() >= 0);
    CHECK(moved.weights.sum() == Approx(1).epsilon(1e-13));
    force(moved.violated) += moved.total_force * moved.weights;
    u = moved.displacement;
    SolverOptions stop;
    stop.iteration_limit = k;
    const ContactState state = quasi_active_set_literal(problem, stop);
    CAPTURE(seed, k);
    CHECK(equal_within(u, K.solve(q.load - q.A.transpose() * force), 1e-11));
    if (state.report.status != SolveStatus::IterationLimit)
      break;  // the library has gone on to its end
    CHECK(equal_within(state.force, force, 1e-10));
  }
}

TEST_CASE("ex4.1 held out: units do not change what is violated", "[ex4.1]") {
  const double length = GENERATE(1e-9, 1e9);
  const DenseProgramme q = rosen_suzuki(12, 9, 5).programme;
  const VectorXd u = CholeskyFactor(q.stiffness).solve(q.load);
  const ex4_1::Moved plain = move(q, u);
  const ex4_1::Moved other =
      ex4_1::move_minimum(q.stiffness / length, q.A, length * q.initial_gap, length * u);
  CHECK(other.violated == plain.violated);
  REQUIRE(other.displacement.size() == 12);
  CHECK(equal_within(other.displacement / length, plain.displacement, 1e-12));
  CHECK(other.total_force == Approx(plain.total_force).epsilon(1e-12));
}

TEST_CASE("ex4.1 held out: rows that were satisfied exactly do not count again", "[ex4.1]") {
  const DenseProgramme q = rosen_suzuki(12, 9, 7).programme;
  const ex4_1::Moved first = move(q, CholeskyFactor(q.stiffness).solve(q.load));
  REQUIRE(first.displacement.size() == 12);
  const ex4_1::Moved second = move(q, first.displacement);
  for (const Index i :
       second.violated)  // tight rows are violated by rounding only, which is nothing
    CHECK(std::count(first.violated.begin(), first.violated.end(), i) == 0);
}
