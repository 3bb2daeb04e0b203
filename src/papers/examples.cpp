// # Problems whose answer is known
//
// A method is judged by problems that somebody else has solved. There are three ways to come by
// such: build the problem backwards from its solution, take a case that the theory of elasticity
// solves in closed form, or take a small one that is made to be hard.

#include "papers/examples.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "signorini/core/errors.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// Entries are drawn column by column, always in the same order: the seed alone says which matrix it
// is.
Eigen::MatrixXd random_matrix(Random& random, Index rows, Index cols) {
  Eigen::MatrixXd matrix(rows, cols);
  for (Index j = 0; j < cols; ++j)
    for (Index i = 0; i < rows; ++i) matrix(i, j) = random.uniform(-1, 1);
  return matrix;
}

// The first `count` of a random order of 0, ..., n - 1.
// Every step swaps one of those that are left to the front, so the rest of the order is never made.
std::vector<Index> random_choice(Random& random, Index n, Index count) {
  std::vector<Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Index{0});
  for (Index k = 0; k < count; ++k)
    std::swap(order[static_cast<std::size_t>(k)],
              order[static_cast<std::size_t>(
                  random.whole(static_cast<int>(k), static_cast<int>(n - 1)))]);
  order.resize(static_cast<std::size_t>(count));
  return order;
}

// The load and the initial gaps that a chosen displacement, chosen forces and chosen gaps solve.
void pose(KnownProgramme& known, const Eigen::VectorXd& gap) {
  DenseProgramme& programme = known.programme;
  const Eigen::VectorXd stretched = programme.stiffness * known.displacement;
  programme.load = stretched + programme.A.transpose() * known.force;
  programme.initial_gap = programme.A * known.displacement + gap;
  known.energy = 0.5 * known.displacement.dot(stretched) - programme.load.dot(known.displacement);
}

// Share of the total force left of x, under Hertz's pressure (2 / pi b) sqrt(1 - (x/b)^2).
// The exact pressure of a punch is summed over the length of each pair, as the difference of two of
// these shares. Both are integrals of the pressure, divided by the total force.
double share_parabola(double x, double b) {
  const double t = std::clamp(x / b, -1.0, 1.0);
  return 0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) / pi;
}

/// The same under the pressure of a flat punch, 1 / (pi sqrt(1 - x^2)).
double share_flat(double x) { return 0.5 + std::asin(std::clamp(x, -1.0, 1.0)) / pi; }

}  // namespace

// Backwards: choose a stiffness, displacements, forces and gaps, and ask which load and which
// initial gaps they solve,
// \f[ K = BB^T + \tfrac{n}{3} I, \qquad p = Ku + A^T\lambda, \qquad g = Au + \text{gap}. \f]
// Each pair has a force or a gap and not both, so all conditions hold. K is positive definite, so
// there is no other solution.
// At most n rows are independent. Half of min(n, m) rows are closed, and random rows are
// independent, so there are no other forces either.
KnownProgramme rosen_suzuki(Index n, Index m, std::uint64_t seed) {
  require_argument(n > 0 && m > 0, "rosen_suzuki: sizes must be positive, got n = ", n,
                   ", m = ", m);
  Random random(seed);
  KnownProgramme known;
  DenseProgramme& programme = known.programme;
  const Eigen::MatrixXd B = random_matrix(random, n, n);
  programme.stiffness = Eigen::MatrixXd::Zero(n, n);
  programme.stiffness.selfadjointView<Eigen::Lower>().rankUpdate(B);
  programme.stiffness.triangularView<Eigen::StrictlyUpper>() = programme.stiffness.transpose();
  programme.stiffness.diagonal().array() += static_cast<double>(n) / 3;
  programme.A = random_matrix(random, m, n);
  known.displacement = random_matrix(random, n, 1);

  known.force.setZero(m);
  Eigen::VectorXd gap(m);
  for (Index i = 0; i < m; ++i) gap(i) = random.uniform(0.1, 2);
  for (const Index i : random_choice(random, m, std::min(n, m) / 2)) {
    gap(i) = 0;
    known.force(i) = random.uniform(0.5, 2);
  }
  pose(known, gap);
  return known;
}

// The same idea with other numbers: a conclusion that hangs on the way of drawing is none. Whole
// numbers leave no rounding in the data: sums and products of them are exact up to \f$ 2^{53} \f$.
//
// With n = 1, B = 2 and A = 3 the stiffness is 5. Let u = 1, and let the row be closed with the force 4:
// then p = 5 + 12 = 17 and g = 3, and without contact u would be 17/5, an overlap of 36/5.
//
// K is the identity and a sum of squares, so it is positive definite. A row of A has few entries, as a
// gap depends on the nodes nearby, and one at least, so that no row is empty. How many rows close is
// drawn too, from one to as many as can be independent.
KnownProgramme whole_number_programme(Index n, Index m, std::uint64_t seed) {
  require_argument(n > 0 && m > 0, "whole_number_programme: sizes must be positive, got n = ", n,
                   ", m = ", m);
  Random random(seed);
  KnownProgramme known;
  DenseProgramme& programme = known.programme;
  Eigen::MatrixXd B(n, n);
  for (double& entry : B.reshaped()) entry = random.whole(-2, 2);
  programme.stiffness = B.transpose() * B + Eigen::MatrixXd::Identity(n, n);
  programme.A.setZero(m, n);
  for (Index i = 0; i < m; ++i)
    for (Index j = 0; j < n; ++j) {
      if (j == i % n)
        programme.A(i, j) = random.whole(1, 5) * (2 * random.whole(0, 1) - 1);
      else if (random.whole(1, 3) == 1)
        programme.A(i, j) = random.whole(-5, 5);
    }
  known.displacement.resize(n);  // the solution
  for (double& u : known.displacement) u = random.whole(-4, 4);

  known.force.setZero(m);
  Eigen::VectorXd gap(m);
  for (double& open : gap) open = random.whole(1, 9);
  for (const Index i :
       random_choice(random, m, random.whole(1, static_cast<int>(std::min(n, m))))) {
    gap(i) = 0;
    known.force(i) = random.whole(1, 9);
  }
  pose(known, gap);
  return known;
}

// Programmes are one thing and bodies another. The next one is a body whose solution is known, too.
//
// A line force on a half-plane moves a surface point at the distance r by
// \f$ -\tfrac{2}{\pi} \ln(r/c) \f$, if forces are measured such that \f$ E/(1-\nu^2) = 1 \f$ and
// points at the distance c stay where they are. Spread over an element of length h it is the mean
// of that, and the integral of the logarithm is elementary:
// \f[ \int \ln\frac{|s|}{c}\,ds = s\left(\ln\frac{|s|}{c} - 1\right). \f]
// All elements are equal, so the influence depends on the distance alone: n numbers make the whole
// matrix.
//
// Under the parabola the exact solution is Hertz's, under the flat punch the pressure is infinite
// at the edges. Its integral over an element is not.
Indentation half_plane_indentation(Index n, Punch punch) {
  require_argument(n > 0, "half_plane_indentation: needs at least one pair, got n = ", n);
  const double h = 2.0 / static_cast<double>(n);
  const double far = 2;  // where the displacement is taken as zero
  const auto integral = [far](double s) {
    return s == 0 ? 0 : s * (std::log(std::abs(s) / far) - 1);
  };
  Eigen::VectorXd influence(n);  // of a force at the distance k h
  for (Index k = 0; k < n; ++k) {
    const double r = static_cast<double>(k) * h;
    influence(k) = -2 / (pi * h) * (integral(r + h / 2) - integral(r - h / 2));
  }
  const bool flat = punch == Punch::Flat;
  Indentation made;
  made.half_width = flat ? 1 : 0.6;
  const double b = made.half_width;
  made.total_force = flat ? 1 : pi * b * b / 4;
  const double depth =
      flat ? 2 / pi * std::log(2 * far) : b * b / 2 * (std::log(2 * far / b) + 0.5);
  made.position.resize(n);
  made.force.resize(n);
  made.problem = {Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    const double x = (static_cast<double>(2 * i + 1) / static_cast<double>(n)) - 1;
    const auto share = [&](double end) { return flat ? share_flat(end) : share_parabola(end, b); };
    made.position(i) = x;
    made.force(i) = made.total_force * (share(x + h / 2) - share(x - h / 2));
    made.problem.free_gap(i) = (flat ? 0 : x * x / 2) - depth;
    for (Index j = 0; j < n; ++j) made.problem.compliance(i, j) = influence(std::abs(i - j));
  }
  return made;
}

// For two pairs \f$ G = \begin{pmatrix} 1 & 2 \\ 2 & 5 \end{pmatrix} \f$ and \f$ d = (-1, -1) \f$:
// the force 1 on the first pair closes it and opens the second by \f$ 2 - 1 = 1 \f$. The answer is
// as simple for any n; Lemke's method passes \f$ 2^n \f$ bases on the way to it.
ContactProblem fathi(Index n) {
  require_argument(n > 0, "fathi: needs at least one pair, got n = ", n);
  Eigen::MatrixXd L = Eigen::MatrixXd::Identity(n, n);
  L.triangularView<Eigen::StrictlyLower>().setConstant(2);
  return {L * L.transpose(), Eigen::VectorXd::Constant(n, -1)};
}

// With a matrix that is not symmetric there is no energy, and nothing forbids a long way either.
//
// For two pairs \f$ M = \begin{pmatrix} 1 & 2 \\ 0 & 1 \end{pmatrix} \f$ and \f$ q = (-6, -4) \f$:
// the force 4 on the second pair closes it and opens the first by \f$ 8 - 6 = 2 \f$. All numbers
// are powers of two or their differences, so up to \f$ n = 50 \f$ a double holds them exactly.
ContactProblem murty(Index n) {
  require_argument(n > 0 && n <= 50, "murty: n must be from 1 to 50, so that 2^n is exact, got ",
                   n);
  ContactProblem problem{Eigen::MatrixXd::Identity(n, n), Eigen::VectorXd(n)};
  problem.compliance.triangularView<Eigen::StrictlyUpper>().setConstant(2);
  for (Index i = 0; i < n; ++i)
    problem.free_gap(i) =
        std::ldexp(1, static_cast<int>(i + 1)) - std::ldexp(1, static_cast<int>(n + 1));
  return problem;
}

}  // namespace signorini
