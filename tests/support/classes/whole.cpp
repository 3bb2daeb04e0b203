// Problems in small whole numbers: G is exact, rows repeat and contradict each other exactly, and so are
// the answers: no rounding in this file.
#include <algorithm>
#include <cstdint>

#include "signorini/core/errors.hpp"
#include "support/classes/classes.hpp"
#include "support/random.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using Whole = Eigen::Matrix<std::int64_t, Eigen::Dynamic, Eigen::Dynamic>;

/// Elimination without fractions (Bareiss): all entries stay minors of the first matrix.
/// \param table  square matrix M and right side r; on return M is det(M) times the unit matrix
/// \return det(M); if it is not 0, the last column is det(M) M^-1 r
std::int64_t eliminate(Whole& table) {
  const Index n = table.rows();
  std::int64_t last = 1;
  for (Index k = 0; k < n; ++k) {
    if (table(k, k) == 0) return 0;  // of a semidefinite matrix: the leading minor is singular
    for (Index i = 0; i < n; ++i) {
      if (i == k) continue;
      const std::int64_t factor = table(i, k);
      for (Index j = 0; j <= n; ++j)
        table(i, j) = (table(i, j) * table(k, k) - factor * table(k, j)) / last;
    }
    last = table(k, k);
  }
  return last;
}

/// All sets of closed pairs, in whole numbers.
/// \param G  symmetric positive semidefinite
/// \param d  free gaps
/// \return the gaps of a solution, or nothing if there is none
VectorXd exact_gap(const Whole& G, const Whole& d) {
  const Index n = d.rows();
  for (unsigned set = 0; set < (1U << n); ++set) {
    std::vector<Index> closed;
    for (Index i = 0; i < n; ++i)
      if ((set >> i & 1U) != 0) closed.push_back(i);
    Whole table(static_cast<Index>(closed.size()), static_cast<Index>(closed.size()) + 1);
    table << Whole(G(closed, closed)), -Whole(d(closed, 0));
    const std::int64_t det = closed.empty() ? 1 : eliminate(table);
    if (det == 0) continue;  // the forces of another set do the same
    const Whole force = table.rightCols(1);
    const Whole gap = d * det + Whole(G(Eigen::all, closed)) * force;
    if ((force.array() >= 0).all() && (gap.array() >= 0).all())
      return gap.cast<double>() / static_cast<double>(det);
  }
  return {};
}

enum class Kind { Independent, Dependent, Infeasible };

/// 4000 random problems of 1 to 6 rows in 1 to 4 dimensions, those of one kind.
Instances whole_numbers(Kind kind) {
  Instances made;
  Random random(4000);
  for (int sample = 0; sample < 4000; ++sample) {
    const Index n = random.whole(1, 4);
    const Index m = random.whole(1, 6);
    MatrixXd A(m, n);
    for (Index k = 0; k < A.size(); ++k) A.data()[k] = random.whole(-2, 2);
    VectorXd d(m);
    for (Index i = 0; i < m; ++i) d(i) = random.whole(-4, 2);
    Instance instance{text("sample ", sample, ", n = ", n, ", m = ", m), {A * A.transpose(), d}};
    instance.programme = {MatrixXd::Identity(n, n), VectorXd::Zero(n), A, d, 0};
    const Whole G = instance.problem.compliance.cast<std::int64_t>();
    instance.gap = exact_gap(G, d.cast<std::int64_t>());
    Whole table(m, m + 1);
    table << G, Whole::Zero(m, 1);
    const Kind found = instance.gap.size() == 0 ? Kind::Infeasible
                       : eliminate(table) != 0  ? Kind::Independent
                                                : Kind::Dependent;
    if (found == Kind::Infeasible) instance.expected = SolveStatus::Infeasible;
    if (found == kind) made.push_back(instance);
  }
  return made;
}

}  // namespace

Instances whole_independent() { return whole_numbers(Kind::Independent); }
Instances whole_dependent() { return whole_numbers(Kind::Dependent); }
Instances whole_infeasible() { return whole_numbers(Kind::Infeasible); }

Instances wedged() {
  Instances made;
  for (const double width :
       {1.5, 1e-3, 1e-8}) {  // between two walls that are closer than the body is wide
    Eigen::Matrix2d G;
    G << 1, -1, -1, 1;
    made.push_back({text("too wide by ", width), {G, Eigen::Vector2d(-1, 1 - width)}});
    made.back().programme = {MatrixXd::Identity(1, 1), VectorXd::Zero(1), Eigen::Vector2d(1, -1),
                             Eigen::Vector2d(-1, 1 - width), 0};
  }
  made.push_back({"a pair that cannot move", {MatrixXd::Zero(1, 1), VectorXd::Constant(1, -1)}});
  for (Instance& instance : made) instance.expected = SolveStatus::Infeasible;
  return made;
}

Instances simplex_turned_out() {
  // Rows a_0, ..., a_n-1 and one that is minus a positive combination of them: with y = (weights, 1),
  // A^T y = 0, and g is chosen so that y.g = -1 or -10. Rows that are far away are added.
  Instances made;
  for (const Index n : {1, 2, 3, 6, 10, 30})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Random random(seed);
      const Index m = n + 1 + n / 2;
      MatrixXd A(m, n);
      VectorXd g(m);
      VectorXd point(n);
      for (Index k = 0; k < A.size(); ++k) A.data()[k] = random.whole(-3, 3);
      for (Index i = 0; i < n; ++i) point(i) = random.whole(-5, 5);
      for (Index i = 0; i < m; ++i) g(i) = random.whole(1, 9);
      A.row(n).setZero();
      g(n) = seed % 2 == 0 ? -1 : -10;
      for (Index i = 0; i < n; ++i) {
        const int weight = random.whole(1, 3);
        A.row(n) -= weight * A.row(i);
        g(n) -= weight * g(i);
      }
      made.push_back(
          from_programme(text("n = ", n, ", m = ", m, ", seed ", seed), projection(A, point, g)));
      made.back().expected = SolveStatus::Infeasible;
    }
  return made;
}

}  // namespace signorini_test
