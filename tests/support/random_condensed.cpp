// Chosen forces and gaps, or a chosen proof, and the problem that has them.
#include "support/random_condensed.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/random.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How columns of H follow others.
enum class Kind { Plain, Repeated, NearlyRepeated };

MatrixXd random_columns(Random& random, Index rows, Index columns, bool whole) {
  MatrixXd H(rows, columns);
  for (Index k = 0; k < H.size(); ++k)
    H.data()[k] = whole ? random.whole(-3, 3) : random.uniform(-1, 1);
  for (Index j = 0; j < columns; ++j)
    if (H.col(j).isZero(0)) H(random.whole(0, static_cast<int>(rows) - 1), j) = 1;
  return H;
}

/// Replaces about half of the columns behind the first by others, of any sign, plus a little.
void repeat_columns(Random& random, Kind kind, bool whole, MatrixXd& H) {
  const double little = std::ldexp(1, -random.whole(13, 40));  // 1.2e-4 to 9e-13
  for (Index j = 1; j < H.cols(); ++j) {
    if (random.whole(0, 1) == 0) continue;
    const Index like = random.whole(0, static_cast<int>(j) - 1);
    H.col(j) = H.col(like) * (random.whole(0, 2) == 0 ? -1 : 1);
    if (kind == Kind::NearlyRepeated)
      H.col(j) += little * random_columns(random, H.rows(), 1, whole);
  }
}

/// H^T H, exact where its entries are doubles.
MatrixXd products(const MatrixXd& H) {
  MatrixXd G(H.cols(), H.cols());
  for (Index i = 0; i < G.rows(); ++i)
    for (Index j = 0; j <= i; ++j) {
      ExactSum sum;
      for (Index k = 0; k < H.rows(); ++k) sum.add_product(H(k, i), H(k, j));
      G(i, j) = G(j, i) = sum.value();
    }
  return G;
}

/// gap - G force for forces and gaps of which at most one is not zero in every pair.
VectorXd any_solvable_gap(Random& random, const MatrixXd& G, bool whole, bool ties) {
  const Index n = G.rows();
  VectorXd force = VectorXd::Zero(n);
  VectorXd gap = VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) {
    const int side = random.whole(0, ties ? 3 : 1);  // 2 and 3: touches without force
    const double size = whole ? random.whole(1, 4) : random.uniform(0.01, 4);
    if (side == 0) force(i) = ties ? 1 : size;
    if (side == 1) gap(i) = ties ? 1 : size;
  }
  VectorXd d(n);
  for (Index i = 0; i < n; ++i) {
    ExactSum sum(gap(i));
    for (Index j = 0; j < n; ++j) sum.add_product(-G(i, j), force(j));
    d(i) = sum.value();
  }
  return d;
}

/// The same, drawn again while forces that nearly cancel hide behind overlaps so small that the rounding of G
/// decides whether the problem can be solved.
VectorXd solvable_gap(Random& random, const MatrixXd& G, bool whole, bool ties) {
  const VectorXd root = G.diagonal().cwiseSqrt();
  while (true) {
    const VectorXd d = any_solvable_gap(random, G, whole, ties);
    const double deepest = -d.cwiseQuotient(root).minCoeff();
    if (deepest <= 0 || deepest > 4 * root.maxCoeff() * std::ldexp(1, -26)) return d;
  }
}

/// Makes the last column the one that balances some others, all of whole numbers.
/// \return y with H y = 0
VectorXd balance_columns(Random& random, MatrixXd& H) {
  const Index last = H.cols() - 1;
  VectorXd y = VectorXd::Unit(H.cols(), last);
  while (y.sum() == 1 || H.col(last).isZero(0)) {
    H.col(last).setZero();
    for (Index j = 0; j < last; ++j) {
      const bool plain = (H.col(j).array() == H.col(j).array().round()).all();
      y(j) = plain ? std::max(0, random.whole(-1, 2)) : 0;
      H.col(last) -= y(j) * H.col(j);
    }
  }
  return y;
}

/// Whether y >= 0 with G y = 0 but for what rounding does to products, and d^T y < 0 beyond that.
bool holds(const ContactProblem& problem, const VectorXd& y) {
  const Index n = problem.free_gap.size();
  if (y.size() != n || !y.allFinite() || (y.array() < 0).any()) return false;
  const VectorXd root = problem.compliance.diagonal().cwiseSqrt();
  const double size = root.dot(y);
  ExactSum work;
  for (Index i = 0; i < n; ++i) {
    ExactSum moved;
    for (Index j = 0; j < n; ++j) moved.add_product(problem.compliance(i, j), y(j));
    if (std::abs(moved.value()) > 1e-12 * root(i) * size) return false;
    work.add_product(problem.free_gap(i), y(i));
  }
  return work.value() < -1e-12 * problem.free_gap.cwiseAbs().dot(y);
}

}  // namespace

RandomCondensed random_condensed(std::uint64_t seed) {
  Random random(seed);
  RandomCondensed result;
  result.feasible = random.whole(0, 5) != 0;
  const Index n = random.whole(result.feasible ? 2 : 3, 12);
  const Index rank = random.whole(1, static_cast<int>(n));
  const bool whole = !result.feasible || random.whole(0, 1) == 0;
  const bool ties = random.whole(0, 2) == 0;
  const Kind kind = static_cast<Kind>(random.whole(0, 2));
  MatrixXd H = random_columns(random, rank, n, whole);
  if (kind != Kind::Plain) repeat_columns(random, kind, whole, H);
  VectorXd y;
  if (!result.feasible) {
    H.col(0) = H.col(0).array().round();
    y = balance_columns(random, H);
  }
  const MatrixXd G = products(H);
  VectorXd d = solvable_gap(random, G, whole, ties);
  if (!result.feasible) {  // y of the last pair is 1
    ExactSum work(-random.whole(1, 3));
    for (Index i = 0; i + 1 < n; ++i) work.add_product(-d(i), y(i));
    d(n - 1) = work.value();
  }
  const int ratio = random.whole(0, 1) == 0 ? 0 : 27;  // 2^27 = 1.3e8
  VectorXd unit(n);
  for (Index i = 0; i < n; ++i) unit(i) = std::ldexp(1, random.whole(-ratio, ratio));
  result.problem = {unit.asDiagonal() * G * unit.asDiagonal(), unit.cwiseProduct(d)};
  const char* kinds[] = {"plain", "repeated", "nearly repeated"};
  result.name = text("seed ", seed, ", ", n, " pairs, rank ", rank, ", ",
                     kinds[static_cast<int>(kind)], whole ? ", whole" : "", ties ? ", ties" : "",
                     ratio == 0 ? "" : ", ratios", result.feasible ? "" : ", infeasible");
  return result;
}

Verdict verdict(const RandomCondensed& problem, const ContactState& state) {
  switch (state.report.status) {
    case SolveStatus::Solved:
      return problem.feasible && certify(problem.problem, state).holds() ? Verdict::Solved
                                                                         : Verdict::Wrong;
    case SolveStatus::Infeasible:
      return !problem.feasible && holds(problem.problem, state.farkas_certificate)
                 ? Verdict::Refuted
                 : Verdict::Wrong;
    case SolveStatus::Feasible:
    case SolveStatus::Ray:
    case SolveStatus::Jump:
    case SolveStatus::IterationLimit:
    case SolveStatus::Breakdown:
    case SolveStatus::SlidTooFar:
    case SolveStatus::TurnedTooFar:
      break;
  }
  return Verdict::Failed;
}

}  // namespace signorini_test
