#include "signorini/problem/constraint_rows.hpp"

#include <cmath>
#include <vector>

#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Rows = std::vector<Index>;

/// Gaps of scaled pairs under the forces of a basis, and what rounding may have done to them.
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

ConstraintRows rows_of(const ScaledProblem& scaled, const VectorXd& weight) {
  ConstraintRows rows;
  rows.count = rows.rank = scaled.free.size();
  rows.unit = &scaled.scale;
  rows.weight = &weight;
  rows.gaps = [&scaled](const ActiveSetFactor& basis, VectorXd& gap, VectorXd& rounding) {
    gaps_of_pairs(scaled, basis, gap, rounding);
  };
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
