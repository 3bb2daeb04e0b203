#include <cmath>

#include "catch_compat.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/problem/iterative_refinement.hpp"
#include "support/refined.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::Refined;

namespace {

/// A chain of n springs in whole numbers that rests on supports, built backwards from its answer.
///
/// u_i and the forces are whole numbers, and so are K, p, A and g: the answer is exact in doubles.
struct Chain {
  QuadraticProgramme programme;
  Eigen::VectorXd u;
  Eigen::VectorXd force;
  std::vector<Index> active;
};

Chain chain(Index n) {
  Chain made;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n / 2, n);
  made.u.resize(n);
  made.force.setZero(n / 2);
  made.programme.initial_gap.resize(n / 2);
  for (Index i = 0; i < n; ++i) {
    K(i, i) += 1000;
    if (i + 1 < n) K(i + 1, i + 1) += 1000, K(i, i + 1) = K(i + 1, i) = -1000;
    made.u(i) = static_cast<double>(i * i % 17 - 5);
  }
  for (Index pair = 0; pair < n / 2; ++pair) {
    A(pair, 2 * pair) = 3;
    A(pair, 2 * pair + 1) = -1;
    const bool closed = pair % 3 != 0;
    if (closed) made.active.push_back(pair);
    if (closed) made.force(pair) = static_cast<double>(1 + pair % 4);
    made.programme.initial_gap(pair) = A.row(pair).dot(made.u) + (closed ? 0 : 2);
  }
  made.programme.stiffness = K.sparseView();
  made.programme.A = A.sparseView();
  made.programme.load = K * made.u + A.transpose() * made.force;
  return made;
}

/// Refines from zero with K^-1 and G that are wrong in relative terms by `error`, entry by entry.
Refined refined(const Chain& chain, double error, const std::vector<Index>& active) {
  const Eigen::MatrixXd K = chain.programme.stiffness;
  const CholeskyFactor factor(K);
  const auto wrong = [error](const Eigen::VectorXd& v) {
    Eigen::VectorXd w = v;
    for (Index i = 0; i < w.size(); ++i)
      w(i) *= 1 + error * std::sin(static_cast<double>(3 * i + 1));
    return w;
  };
  const Eigen::MatrixXd A = chain.programme.A;
  const Eigen::MatrixXd exact = A * factor.solve_columns(A.transpose());
  Eigen::MatrixXd G = exact;
  for (Index i = 0; i < G.rows(); ++i)
    for (Index j = 0; j <= i; ++j)
      G(i, j) = G(j, i) = exact(i, j) * (1 + error * std::cos(static_cast<double>(i * j)));
  const Index n = chain.u.size();
  return signorini_test::refined(
      chain.programme, [&](const Eigen::VectorXd& v) { return wrong(factor.solve(v)); }, G,
      {Eigen::VectorXd::Zero(n), {}, Eigen::VectorXd::Zero(chain.force.size())}, active);
}

}  // namespace

TEST_CASE("refinement recovers all digits from a solver that has six", "[refinement]") {
  const Chain exact = chain(24);
  for (const double error : {0.0, 1e-6}) {
    CAPTURE(error);
    const Refined result = refined(exact, error, exact.active);
    CHECK(result.confirmed);
    CHECK((result.solution.displacement - exact.u).cwiseAbs().maxCoeff() < 1e-14);
    CHECK((result.solution.force - exact.force).cwiseAbs().maxCoeff() < 1e-14);
    CHECK(certify(exact.programme, result.solution).worst() < 1e-15);
    CHECK(result.solves <= 10);
  }
}

TEST_CASE("a refined gap is zero in closed pairs and exact in open ones", "[refinement]") {
  const Chain exact = chain(24);
  const Refined result = refined(exact, 1e-6, exact.active);
  for (Index pair = 0; pair < result.movement.size(); ++pair)
    CHECK(result.movement(pair) == Approx(pair % 3 == 0 ? 2 : 0).epsilon(1e-14).margin(1e-15));
}

TEST_CASE("a better solver needs no more solves", "[refinement]") {
  const Chain exact = chain(24);
  CHECK(refined(exact, 0, exact.active).solves <= refined(exact, 1e-3, exact.active).solves);
}

TEST_CASE("a set with a missing pair is not confirmed, because the pair overlaps", "[refinement]") {
  const Chain exact = chain(24);
  std::vector<Index> fewer = exact.active;
  fewer.erase(fewer.begin() + 2);
  CHECK_FALSE(refined(exact, 1e-6, fewer).confirmed);
}

TEST_CASE("a set with a pair too many is not confirmed, because the pair pulls", "[refinement]") {
  const Chain exact = chain(24);
  std::vector<Index> more = exact.active;
  more.insert(more.begin(), 0);
  const Refined result = refined(exact, 1e-6, more);
  CHECK(result.solution.force(0) < 0);
  CHECK_FALSE(result.confirmed);
}

TEST_CASE("without closed pairs refinement solves K u = p", "[refinement]") {
  Chain open = chain(12);
  open.programme.initial_gap.array() += 100;
  open.programme.load = open.programme.stiffness * open.u;
  const Refined result = refined(open, 1e-6, {});
  CHECK(result.confirmed);
  CHECK((result.solution.displacement - open.u).cwiseAbs().maxCoeff() < 1e-14);
}

// Which of two equal pairs bears the force is open; their sum, the gaps and u are not.
TEST_CASE("a set of pairs that repeat each other is refined as well", "[refinement]") {
  const Chain exact = chain(24);
  const Index pairs = exact.force.size();
  Chain twice = exact;
  const Eigen::MatrixXd A = exact.programme.A;
  twice.programme.A = (Eigen::MatrixXd(2 * pairs, A.cols()) << A, A).finished().sparseView();
  twice.programme.initial_gap = exact.programme.initial_gap.replicate(2, 1);
  twice.force = exact.force.replicate(2, 1);
  for (const Index pair : exact.active) twice.active.push_back(pairs + pair);
  const Refined result = refined(twice, 0, twice.active);
  REQUIRE(result.movement.size() == 2 * pairs);
  CHECK(result.confirmed);
  CHECK((result.solution.displacement - exact.u).cwiseAbs().maxCoeff() < 1e-14);
  const Eigen::VectorXd& force = result.solution.force;
  CHECK((force.head(pairs) + force.tail(pairs) - exact.force).cwiseAbs().maxCoeff() < 1e-14);
  CHECK(certify(twice.programme, result.solution).worst() < 1e-15);
}

TEST_CASE("a set of pairs that contradict each other is not confirmed", "[refinement]") {
  const Chain exact = chain(24);
  const Index pairs = exact.force.size();
  Chain apart = exact;  // the last row is that of the first closed pair, but 0.5 wider
  Eigen::MatrixXd A(pairs + 1, exact.u.size());
  A << Eigen::MatrixXd(exact.programme.A), Eigen::MatrixXd(exact.programme.A).row(exact.active[0]);
  apart.programme.A = A.sparseView();
  apart.programme.initial_gap.conservativeResize(pairs + 1);
  apart.programme.initial_gap(pairs) = apart.programme.initial_gap(exact.active[0]) + 0.5;
  apart.force.conservativeResize(pairs + 1);
  apart.force(pairs) = 0;
  CHECK(refined(apart, 0, exact.active).confirmed);
  apart.active.push_back(pairs);
  const Refined result = refined(apart, 0, apart.active);
  CHECK(result.movement(pairs) == Approx(0.5));
  CHECK_FALSE(result.confirmed);
}

TEST_CASE("forces that do not balance the load of a free body are not confirmed",
          "[refinement][floating]") {
  // A spring between two nodes, pushed by 1 at one of them, with a wall at the other.
  QuadraticProgramme programme;
  programme.stiffness = (Eigen::Matrix2d() << 1, -1, -1, 1).finished().sparseView();
  programme.load = Eigen::Vector2d(1, 0);
  programme.A = Eigen::MatrixXd(Eigen::RowVector2d(0, 1)).sparseView();
  programme.initial_gap = Eigen::VectorXd::Zero(1);
  const Eigen::MatrixXd modes = Eigen::Vector2d::Ones();
  const ContactProblem condensed{Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Zero(1)};
  const ScaledProblem scaled = equilibrate(condensed);
  const std::function<Eigen::VectorXd(const Eigen::VectorXd&)> unused;
  const RefinementData data{programme, unused, condensed, scaled, modes};
  RefinedSolution numbers;
  numbers.settled = true;
  numbers.movement = Eigen::VectorXd::Zero(1);
  for (const double force : {1.0, 1 + 1e-12, 0.5}) {
    numbers.solution = {Eigen::Vector2d(1, 0), {}, Eigen::VectorXd::Constant(1, force)};
    CHECK(check_signs(data, numbers, {ContactStatus::Stick}).confirmed == (force == 1));
  }
}

// The first sweep finds u and the forces, the second one finds nothing: two solves each.
TEST_CASE("an exact factor takes two sweeps from nothing", "[refinement]") {
  const Chain exact = chain(24);
  CHECK(refined(exact, 0, exact.active).solves <= 4);
}
