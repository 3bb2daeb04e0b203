// # Sets of pairs, and a problem with some pairs alone
//
// The paper says "the violated constraints" and "a quasi-active set" of them. A program has to say
// which. A pair is *violated* if it overlaps by more than rounding and by more than a small part of
// the first overlap; it is *tight* if its gap is below the square root of that part. Which of the
// violated pairs are *quasi-active* is left open by the paper. There are two readings, and two limiting
// cases of ours.
//
// The problem with these pairs alone is solved through the surrogate dual, as in the paper, but
// with the one rule for its weights that ends by itself. So whatever goes wrong outside is not the
// fault of the inside.

#include "papers/literal_method.hpp"

#include <algorithm>
#include <cmath>

#include "papers/surrogate_dual.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_factor.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

// The run starts without forces, on the equilibrated problem: gaps of different pairs can then be
// compared.
LiteralMethod::LiteralMethod(const ContactProblem& problem, const SolverOptions& options,
                             QuasiActiveRows rows, QuasiActivePool pool)
    : problem_(problem),
      scaled_(equilibrate(problem)),
      choice_(rows),
      pool_(pool),
      used_(static_cast<std::size_t>(problem.free_gap.size())),
      tolerance_(options.tolerance) {
  const Index n = scaled_.free.size();
  limit_ = options.iteration_limit > 0 ? options.iteration_limit : 100 * n + 1000;
  largest_overlap_ = n > 0 ? std::max(0.0, -scaled_.free.minCoeff()) : 0;
  now_.force.setZero(n);
  place(now_);
}

// Gaps are computed anew from the sum of all forces and not from step to step, so that rounding
// does not add up.
// With a unit diagonal no entry of G exceeds 1, so the rounding of a gap is at most that of its own
// terms, d and the sum of the forces.
void LiteralMethod::place(
    ActiveSetSolution& point) const {  // with unit diagonal no |G_ij| exceeds 1
  const double unit = static_cast<double>(point.force.size() + 1) * epsilon;
  point.movement = scaled_.free + scaled_.compliance * point.force;
  point.movement_rounding = unit * (scaled_.free.array().abs() + point.force.sum());
}

// Rounding is not an overlap, and neither is what the loop leaves of a limit that it tends to. Both are
// small beside the first overlap; the larger one decides.
bool LiteralMethod::overlaps(const ActiveSetSolution& point, Index row) const {
  return point.movement(row) <
         -std::max(point.movement_rounding(row), tolerance_ * largest_overlap_);
}

// The list is in increasing order, as all sets of pairs are.
std::vector<Index> LiteralMethod::violated(const ActiveSetSolution& point) const {
  std::vector<Index> rows;
  for (Index i = 0; i < point.movement.size(); ++i)
    if (overlaps(point, i)) rows.push_back(i);
  return rows;
}

// After the first step the paper looks outside of the rows of that step, and repeats this. If that
// means the rows of the last step only, nothing changes, because these are satisfied. If it means the
// rows of all earlier steps, a pair is taken once, and the loop ends at the latest when all are used.
std::vector<Index> LiteralMethod::unused(std::vector<Index> rows) const {
  if (pool_ == QuasiActivePool::AllPairs) return rows;
  const auto taken = [this](Index i) { return used_[static_cast<std::size_t>(i)]; };
  rows.erase(std::remove_if(rows.begin(), rows.end(), taken), rows.end());
  return rows;
}

// Overlaps that are equal by symmetry differ by rounding, and each compiler would sort them in its
// own way. So only a difference larger than both roundings counts. That is no order for std::sort,
// because it is not transitive; so the largest is moved to the front, then the largest of the rest.
void LiteralMethod::sort_by_violation(std::vector<Index>& rows) const {
  const auto larger = [this](Index one, Index other) {
    return now_.movement(one) + now_.movement_rounding(one) + now_.movement_rounding(other) <
           now_.movement(other);
  };
  for (auto first = rows.begin(); first != rows.end(); ++first) {
    auto worst = first;
    for (auto row = first; row != rows.end(); ++row)
      if (larger(*row, *worst)) worst = row;
    std::rotate(first, worst, worst + 1);
  }
}

// A pair depends on others if its row is a sum of theirs. The factor of the pairs taken so far
// finds that out: the pivot of such a pair is zero. What it accepts is the set.
// The order in which pairs are offered is the whole difference between the two readings: by number, or
// the largest overlap first. In the limiting cases the answer is known without a factor.
std::vector<Index> LiteralMethod::quasi_active(std::vector<Index> rows) const {
  if (choice_ == QuasiActiveRows::AllViolated || rows.empty()) return rows;
  if (choice_ != QuasiActiveRows::IndependentByIndex) sort_by_violation(rows);
  if (choice_ == QuasiActiveRows::MostViolated) return {rows.front()};
  ActiveSetFactor basis(0, static_cast<Index>(rows.size()));
  ActiveSetFactor::Candidates candidates{rows,
                                         now_.movement(rows),
                                         now_.movement_rounding(rows),
                                         {},
                                         Eigen::MatrixXd(0, rows.size()),
                                         scaled_.compliance(rows, rows)};
  basis.append(candidates, ActiveSetFactor::Choice::All, basis.capacity());
  rows = basis.rows();
  std::sort(rows.begin(), rows.end());
  return rows;
}

// Two gaps are small for different reasons: pairs at which the loop has arrived, and pairs that it
// only approaches. Both belong to the last problem. So the bound is wider here than for an overlap.
// With the usual tolerance an overlap counts from \f$ 10^{-12} \f$ of the first one on, and a pair
// is tight with a gap of up to \f$ 10^{-6} \f$ of it. A pair that overlaps by more is not tight.
std::vector<Index> LiteralMethod::tight(const ActiveSetSolution& point) const {
  const double small = std::sqrt(tolerance_) * largest_overlap_;
  std::vector<Index> rows;
  for (Index i = 0; i < point.movement.size(); ++i)
    if (std::abs(point.movement(i)) <= std::max(point.movement_rounding(i), small))
      rows.push_back(i);
  return rows;
}

// Forces are found as in the paper, weights (38) and a total force (39). If the pairs contradict
// each other, the proof is carried over to the whole problem, with zeros for the other pairs.
// An empty set has no forces. If the weights end where a pair touches without force, rounding may
// hide that they have arrived; the certificate then says whether they have.
bool LiteralMethod::solve(const std::vector<Index>& rows, const VectorXd& gap,
                          ActiveSetSolution& best) {
  best.force.setZero(scaled_.free.size());
  if (!rows.empty()) {
    const ContactProblem part{scaled_.compliance(rows, rows), gap(rows)};
    const ContactState state = surrogate_dual(part, WeightRule::FullyCorrective);
    report_.factorisations += state.report.factorisations;
    if (state.report.status == SolveStatus::Infeasible) {
      report_.status = SolveStatus::Infeasible;
      way_.state.farkas_certificate.setZero(scaled_.free.size());
      way_.state.farkas_certificate(rows) =
          scaled_.scale(rows).cwiseProduct(state.farkas_certificate);
    } else {
      report_.status = SolveStatus::Breakdown;
    }
    // Where a pair touches without force, rounding can keep the weights from ending at the solution.
    const bool right = state.report.status == SolveStatus::IterationLimit &&
                       certify(part, state).worst() <= tolerance_;
    if (state.report.status != SolveStatus::Solved && !right) return false;
    const double total = state.force.sum();
    if (total > 0) {
      const VectorXd weights = state.force / total;                     // (38)
      best.force(rows) = total_contact_force(part, weights) * weights;  // (39)
    }
  }
  return true;
}

}  // namespace signorini
