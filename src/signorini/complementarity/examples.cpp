#include "signorini/complementarity/examples.hpp"

#include <algorithm>
#include <numeric>

#include "signorini/core/errors.hpp"
#include "signorini/core/random.hpp"

namespace signorini {
namespace {

using Eigen::Index;

Eigen::MatrixXd random_matrix(Random& random, Index rows, Index cols) {
  Eigen::MatrixXd matrix(rows, cols);
  for (Index j = 0; j < cols; ++j)
    for (Index i = 0; i < rows; ++i) matrix(i, j) = random.uniform(-1, 1);
  return matrix;
}

/// The first `count` of a random order of 0, ..., n - 1.
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

}  // namespace

KnownProgramme rosen_suzuki(Index n, Index m, std::uint64_t seed) {
  require(n > 0 && m > 0, "rosen_suzuki: sizes must be positive, got n = ", n, ", m = ", m);
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
  const Eigen::VectorXd stretched = programme.stiffness * known.displacement;
  programme.load = stretched + programme.A.transpose() * known.force;
  programme.initial_gap = programme.A * known.displacement + gap;
  known.energy = 0.5 * known.displacement.dot(stretched) - programme.load.dot(known.displacement);
  return known;
}

}  // namespace signorini
