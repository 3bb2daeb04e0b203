// Sweeps over pairs that rub, where the exchange of all wrong pairs at once runs in circles.
#include <Eigen/SparseCore>
#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "signorini/solvers/newton.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The force that makes a row stand still if no other changes.
double still(const ScaledProblem& problem, const Rows& F, Index row, const VectorXd& force) {
  const double stiff = problem.compliance(row, row);
  return stiff > 0 ? force(row) - (problem.free(row) + F.row(row).dot(force)) / stiff : force(row);
}

/// The bound of a friction force.
double bound(const ScaledProblem& problem, Index slip, double normal) {
  return normal > 0 ? problem.law.coefficient(slip) * normal + problem.law.cohesion(slip) : 0;
}

/// Each pair in turn gets the normal force that closes it, then the friction force that holds it, within its bound.
void sweep(const ScaledProblem& problem, const Rows& F, VectorXd& force) {
  const Index pairs = problem.pairs();
  std::size_t k = 0;
  for (Index i = 0; i < pairs; ++i) {
    force(i) = std::max(0.0, still(problem, F, i, force));
    if (k == problem.law.pair.size() || problem.law.pair[k] != i) continue;
    const Index slip = static_cast<Index>(k++);
    const double most = bound(problem, slip, force(i));
    force(pairs + slip) = std::clamp(still(problem, F, pairs + slip, force), -most, most);
  }
}

/// What forces say of the pairs.
std::vector<Motion> motions_of_forces(const ScaledProblem& problem, const VectorXd& force) {
  const Index pairs = problem.pairs();
  std::vector<Motion> motions(static_cast<std::size_t>(pairs), Motion::Open);
  for (Index i = 0; i < pairs; ++i)
    if (force(i) > 0) motions[static_cast<std::size_t>(i)] = Motion::Stick;
  for (std::size_t k = 0; k < problem.law.pair.size(); ++k) {
    const Index slip = static_cast<Index>(k);
    const double most = bound(problem, slip, force(problem.law.pair[k]));
    Motion& motion = motions[static_cast<std::size_t>(problem.law.pair[k])];
    if (motion == Motion::Open) continue;
    if (force(pairs + slip) >= most) motion = Motion::Backward;
    if (force(pairs + slip) <= -most) motion = Motion::Forward;
  }
  return motions;
}

}  // namespace

void follow_sweeps(const ScaledProblem& problem, Attempt& attempt) {
  const Rows F = problem.compliance.sparseView(0, 0);
  const double size = static_cast<double>(problem.free.size());
  const double price = static_cast<double>(std::max<Index>(F.nonZeros(), 1));
  const double most = size * size * size / price;
  VectorXd force = first_attempt(problem).closure.force;
  VectorXd before = VectorXd::Constant(force.size(), -1);  // which no normal force is
  std::vector<Motion> last = motions_of_forces(problem, force);
  std::vector<Motion> tried;
  std::ptrdiff_t fewest = problem.pairs();
  Index done = 0;
  for (Index sweeps = 1; static_cast<double>(sweeps) <= most && force != before; sweeps *= 2) {
    for (; done < sweeps && force.allFinite(); ++done) {
      before = force;
      sweep(problem, F, force);
    }
    if (!force.allFinite()) return;
    std::vector<Motion> motions = motions_of_forces(problem, force);
    const std::ptrdiff_t kept =
        std::inner_product(motions.begin(), motions.end(), last.begin(), std::ptrdiff_t{0},
                           std::plus<>(), std::equal_to<>());
    const std::ptrdiff_t changes = problem.pairs() - kept;
    if (changes <= fewest && motions != tried) {
      fewest = changes;
      tried = motions;
      attempt.motions = motions;
      attempt.closure.force = force;
      attempt.closure.movement = problem.free + F * force;
      attempt.closure.amplitude.resize(0);
      exchange_motions(problem, 3, attempt);
      if (attempt.confirmed) return;
    }
    last = std::move(motions);
  }
}

}  // namespace signorini
