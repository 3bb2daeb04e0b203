// # Rows on demand
//
// A method that grows a set of closed pairs asks little of the rows: all gaps under the present
// forces, and the products of a few rows with each other. ConstraintRows has one function for each.
// So the same method works on a condensed problem, where G is known, and on a programme, where K is
// factored and rows are condensed when they are asked for. This file is the first case. Its rows
// have unit diagonal, which is what the triangular factor of the next set expects: a pivot is then
// the squared distance of a row from those that are closed.

#include "signorini/problem/constraint_rows.hpp"

#include <cmath>
#include <vector>

#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Rows = std::vector<Index>;

// \f$ d + G\lambda \f$, where only the forces of the basis are not zero. A sum of m + 1 terms may
// be wrong by m + 1 roundings of the sum of their magnitudes. With d = -3, G = 1 and the force 3
// the gap is 0, and \f$ 2\varepsilon\,(3 + 3) \f$, which is 2.7e-15, may be rounding. Without that
// number a closed pair could look like an overlap for ever.
void gaps_of_pairs(const ScaledProblem& scaled, const ActiveSetFactor& basis, VectorXd& gap,
                   VectorXd& rounding) {
  VectorXd force;
  basis.solve(force);
  gap = scaled.free;
  rounding = scaled.free.cwiseAbs();
  for (Index k = 0; k < basis.size(); ++k) {
    const auto column = scaled.compliance.col(basis.rows()[static_cast<std::size_t>(k)]);
    gap += force(k) * column;
    rounding += std::abs(force(k)) * column.cwiseAbs();
  }
  rounding *= static_cast<double>(basis.size() + 1) * epsilon;
}

}  // namespace

// The functions look at the scaled problem and do not copy it: it must outlive them.
ConstraintRows rows_of(const ScaledProblem& scaled, const VectorXd& weight) {
  ConstraintRows rows;
  rows.count = rows.rank = scaled.free.size();
  rows.unit = &scaled.scale;
  rows.weight = &weight;
  rows.gaps = [&scaled](const ActiveSetFactor& basis, VectorXd& gap, VectorXd& rounding) {
    gaps_of_pairs(scaled, basis, gap, rounding);
  };
  // Everything is known already. The candidates are picked out of G: their products with the
  // basis, and with each other.
  rows.fetch = [&scaled](const ActiveSetFactor& basis, const VectorXd& gap,
                         const VectorXd& rounding, ActiveSetFactor::Candidates& candidates) {
    const Rows& list = candidates.rows;
    candidates.gap = gap(list);
    candidates.rounding = rounding(list);
    candidates.cross = scaled.compliance(basis.rows(), list);
    candidates.block = scaled.compliance(list, list);
  };
  return rows;
}

}  // namespace signorini
