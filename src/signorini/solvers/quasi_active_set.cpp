#include "signorini/solvers/quasi_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/closing/closed_pairs.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/solvers/group_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Rows = std::vector<Index>;

Index limit_of(const SolverOptions& options, Index count) {
  return options.iteration_limit > 0 ? options.iteration_limit : 10 * count + 100;
}

/// Gaps of scaled pairs under the forces of a basis, and what rounding may have done to them.
void gaps_of_pairs(const ScaledProblem& scaled, const ClosedBasis& basis, VectorXd& gap,
                   VectorXd& rounding) {
  VectorXd force;
  basis.solve(force);
  gap = scaled.free_gap;
  rounding = scaled.free_gap.cwiseAbs();
  for (Index k = 0; k < basis.size(); ++k) {
    const auto column = scaled.compliance.col(basis.rows()[static_cast<std::size_t>(k)]);
    gap += force(k) * column;
    rounding += std::abs(force(k)) * column.cwiseAbs();
  }
  rounding *= static_cast<double>(basis.size() + 1) * epsilon;
}

GapRows rows_of(const ScaledProblem& scaled, const VectorXd& weight) {
  GapRows rows;
  rows.count = rows.rank = scaled.free_gap.size();
  rows.weight = &weight;
  rows.gaps = [&scaled](const ClosedBasis& basis, VectorXd& gap, VectorXd& rounding) {
    gaps_of_pairs(scaled, basis, gap, rounding);
  };
  rows.fetch = [&scaled](const ClosedBasis& basis, const VectorXd& gap, const VectorXd& rounding,
                         ClosedBasis::Candidates& candidates) {
    const Rows& list = candidates.rows;
    candidates.gap = gap(list);
    candidates.rounding = rounding(list);
    candidates.cross = scaled.compliance(basis.rows(), list);
    candidates.block = scaled.compliance(list, list);
  };
  return rows;
}

Rows sorted_active(const ClosedBasis& basis, Index equations) {
  Rows active;
  active.reserve(basis.rows().size());
  for (const Index row : basis.rows())
    if (row >= equations) active.push_back(row);
  std::sort(active.begin(), active.end());
  return active;
}

}  // namespace

ContactState quasi_active_set(const ContactProblem& problem, const SolverOptions& options) {
  const ScaledProblem scaled = equilibrate(problem);
  const VectorXd ones = VectorXd::Ones(scaled.free_gap.size());
  const GapRows rows = rows_of(scaled, ones);
  Report report;
  GroupActiveSet method(rows, ClosedBasis(0, rows.count), report, limit_of(options, rows.count));
  ClosedPairs closed;
  VectorXd proof;
  for (Index round = 0;; ++round) {
    report.status = method.run();
    if (report.status == Status::Infeasible) {
      proof = contradiction(scaled, method.basis().rows(), method.pressed());
      if (proof.size() > 0) break;
      method.pass_over();
      continue;
    }
    closed = close_pairs(scaled, sorted_active(method.basis(), 0));
    if (!closed.solvable && report.status == Status::Solved) report.status = Status::Breakdown;
    if (report.status != Status::Solved) break;
    const VectorXd force = closed.force(method.basis().rows());
    const VectorXd rounding = closed.force_rounding(method.basis().rows());
    const VectorXd tension = (-force - rounding).cwiseMax(0.0);
    const double trusted = std::pow(epsilon, -0.2);  // as in ClosedBasis::smallest_distance()
    const bool overlap = (closed.gap.array() < -trusted * closed.gap_rounding.array()).any();
    if (!overlap && (tension.size() == 0 || tension.maxCoeff() == 0)) break;
    if (round >= rows.count) break;  // sets come back: the certificate will say whether it matters
    method.basis().set_force(force);
    method.release(tension);
  }
  if (report.status == Status::Infeasible)  // where the method stood
    closed = close_pairs(scaled, sorted_active(method.basis(), 0));
  if (!closed.solvable) closed.gap = scaled.free_gap;
  ContactState state =
      unscaled(scaled, closed, sorted_active(method.basis(), 0), std::move(report));
  state.infeasibility = std::move(proof);
  return certified(problem, std::move(state));
}

}  // namespace signorini
