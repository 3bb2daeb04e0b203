// Rows that nearly repeat each other, rows of very different size, and too many of them.
#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "support/classes/classes.hpp"
#include "support/problems.hpp"

namespace signorini_test {

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Pairs of rows that differ by `angle`; both of a pair are closed or open, and pressed differently.
Instances near_parallel(double angle) {
  Instances made;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Index n = random.whole(4, 12);
    MatrixXd A(n, n);
    VectorXd force = VectorXd::Zero(n);
    VectorXd gap = VectorXd::Zero(n);
    const MatrixXd first = random_rows(random, n, n);
    const MatrixXd turn = random_rows(random, n, n);
    for (Index i = 0; i < n; ++i) {
      const bool twin = i % 2 == 1;
      A.row(i) = first.row(i);
      if (twin) A.row(i) = A.row(i - 1) + angle * turn.row(i);
      const bool closed = twin ? force(i - 1) > 0 : random.whole(0, 2) > 0;
      (closed ? force : gap)(i) = random.uniform(0.5, 2);
    }
    made.push_back(closest_point(text("seed ", seed, ", ", n, " rows"), A,
                                 random_rows(random, n, 1), force, gap));
    // What rounding of G does to u, or leaving out one row of each pair, whichever is less.
    made.back().accuracy = std::max(1e-10, std::min(1e-15 / (angle * angle), 100 * angle));
  }
  return made;
}

}  // namespace

Instances near_parallel_4() { return near_parallel(1e-4); }
Instances near_parallel_8() { return near_parallel(1e-8); }
Instances near_parallel_12() { return near_parallel(1e-12); }

Instances scaled_rows() {
  Instances made;
  for (Instance plain : built_backwards()) {
    Random random(made.size());
    VectorXd row(plain.gap.size());
    for (Index i = 0; i < row.size(); ++i) row(i) = std::pow(10.0, random.uniform(-8, 8));
    plain.problem = with_rows(plain.problem, row);
    plain.force = plain.force.cwiseQuotient(row);
    plain.gap = plain.gap.cwiseProduct(row);
    made.push_back(plain);
  }
  return made;
}

Instances many_violated() {
  Instances made;
  for (const Index n : {2, 5, 20})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      Random random(seed);
      const Index m = n == 2 ? 10 : 4 * n;
      MatrixXd A = random_rows(random, m, n);
      VectorXd force = VectorXd::Zero(m);
      for (Index i = 0; i < n; ++i) force(i) = random.uniform(0.5, 2);
      const VectorXd push =
          A.transpose() * force;  // u0 - u: every row turned so that it is violated
      VectorXd gap = VectorXd::Zero(m);
      for (Index i = 0; i < m; ++i) {
        const double overlap = A.row(i).dot(push);
        if (i >= n && overlap < 0) A.row(i) *= -1;
        if (i >= n) gap(i) = 0.5 * std::abs(overlap);
      }
      made.push_back(closest_point(text("n = ", n, ", m = ", m, ", seed ", seed), A,
                                   random_rows(random, n, 1), force, gap));
    }
  return made;
}

}  // namespace signorini_test
