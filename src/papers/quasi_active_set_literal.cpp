#include "papers/quasi_active_set_literal.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "papers/surrogate_dual.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_factor.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<Index> pressed(const VectorXd& force) {
  std::vector<Index> rows;
  for (Index i = 0; i < force.size(); ++i)
    if (force(i) > 0) rows.push_back(i);
  return rows;
}

/// One run on the equilibrated problem: forces >= 0 and the gaps that belong to them.
class LiteralMethod {
 public:
  LiteralMethod(const ContactProblem& problem, const SolverOptions& options, QuasiActiveRows rows);
  QuasiActiveRun run();

 private:
  /// VIO: pairs that overlap.
  [[nodiscard]] std::vector<Index> violated(const ActiveSetSolution& point) const;
  /// QAS, chosen among these. \PaperEq{XuanLi2002, 37}
  [[nodiscard]] std::vector<Index> quasi_active(std::vector<Index> rows) const;
  /// Puts the largest overlap first; overlaps that differ by rounding only keep their order.
  void sort_by_violation(std::vector<Index>& rows) const;
  /// Pairs without gap.
  [[nodiscard]] std::vector<Index> tight(const ActiveSetSolution& point) const;
  /// Gaps that belong to the forces.
  void place(ActiveSetSolution& point) const;
  /// One entry of the history.
  void note(const ActiveSetSolution& point, Index overlapping);
  /// The problem with some rows alone and given gaps of them: forces that are never tensile.
  /// The paper's (28) does not converge, so the weights are found exactly.
  /// \PaperEq{XuanLi2002, 38}, \PaperEq{XuanLi2002, 39}
  bool solve(const std::vector<Index>& rows, const VectorXd& gap, ActiveSetSolution& best);
  /// u^0, u^1, ..., u^k: \PaperEq{XuanLi2002, 30} to \PaperEq{XuanLi2002, 32}, moved by
  /// \PaperEq{XuanLi2002, 36}.
  bool outer_loop();
  /// Whether the present point is the best one for the pairs that are tight at it.
  [[nodiscard]] bool close_to(const ActiveSetSolution& best) const;
  /// The tight pairs alone and the way there. \PaperEq{XuanLi2002, 33} to \PaperEq{XuanLi2002, 35}
  bool last_step();
  /// The end is the solution if the rows that are tight there have no better one.
  void judge();

  const ContactProblem& problem_;
  ScaledProblem scaled_;
  QuasiActiveRows choice_;
  double tolerance_;
  double largest_overlap_;  // without contact
  Index limit_;
  ActiveSetSolution now_;
  QuasiActiveRun way_;
  Report report_;
};

LiteralMethod::LiteralMethod(const ContactProblem& problem, const SolverOptions& options,
                             QuasiActiveRows rows)
    : problem_(problem),
      scaled_(equilibrate(problem)),
      choice_(rows),
      tolerance_(options.tolerance) {
  const Index n = scaled_.free.size();
  limit_ = options.iteration_limit > 0 ? options.iteration_limit : 100 * n + 1000;
  largest_overlap_ = n > 0 ? std::max(0.0, -scaled_.free.minCoeff()) : 0;
  now_.force.setZero(n);
  place(now_);
}

void LiteralMethod::place(
    ActiveSetSolution& point) const {  // with unit diagonal no |G_ij| exceeds 1
  const double unit = static_cast<double>(point.force.size() + 1) * epsilon;
  point.movement = scaled_.free + scaled_.compliance * point.force;
  point.movement_rounding = unit * (scaled_.free.array().abs() + point.force.sum());
}

std::vector<Index> LiteralMethod::violated(const ActiveSetSolution& point) const {
  std::vector<Index> rows;
  for (Index i = 0; i < point.movement.size(); ++i)
    if (point.movement(i) < -std::max(point.movement_rounding(i), tolerance_ * largest_overlap_))
      rows.push_back(i);
  return rows;
}

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

std::vector<Index> LiteralMethod::tight(const ActiveSetSolution& point) const {
  const double small = std::sqrt(tolerance_) * largest_overlap_;
  std::vector<Index> rows;
  for (Index i = 0; i < point.movement.size(); ++i)
    if (point.movement(i) <= std::max(point.movement_rounding(i), small)) rows.push_back(i);
  return rows;
}

void LiteralMethod::note(const ActiveSetSolution& point, Index overlapping) {
  const VectorXd gap = point.movement.cwiseQuotient(scaled_.scale);
  const double dual_energy = -0.5 * point.force.dot(scaled_.free + point.movement);
  report_.history.push_back({(point.force.array() > 0).count(), overlapping,
                             std::max(0.0, gap.size() > 0 ? -gap.minCoeff() : 0.0), 0,
                             dual_energy});
}

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

bool LiteralMethod::outer_loop() {
  for (ActiveSetSolution step;; ++way_.outer_steps) {
    const std::vector<Index> overlapping = violated(now_);
    note(now_, static_cast<Index>(overlapping.size()));
    if (overlapping.empty()) return true;
    if (way_.outer_steps == limit_) {
      report_.status = SolveStatus::IterationLimit;
      return false;
    }
    const std::vector<Index> rows = quasi_active(overlapping);
    // (31): with the moved objective the free gaps are the present ones.
    if (!solve(rows, now_.movement, step)) return false;
    way_.steps.push_back({overlapping, rows, pressed(step.force)});
    now_.force += step.force;  // (36)
    place(now_);
  }
}

bool LiteralMethod::last_step() {
  way_.tight = tight(now_);
  ActiveSetSolution next;  // (33), with the first objective
  if (!solve(way_.tight, scaled_.free, next)) return false;
  place(next);
  way_.optimal = close_to(next);
  way_.left_over = violated(next);
  for (const Index i : way_.left_over)  // (34)
    way_.fraction =
        std::min(way_.fraction, now_.movement(i) / (now_.movement(i) - next.movement(i)));
  now_.force += way_.fraction * (next.force - now_.force);  // (35)
  place(now_);
  note(now_, static_cast<Index>(violated(now_).size()));
  return true;
}

bool LiteralMethod::close_to(const ActiveSetSolution& best) const {
  const double distance = (best.force - now_.force).dot(best.movement - now_.movement);  // squared
  const double energy = -0.5 * best.force.dot(scaled_.free + best.movement);
  return distance <= tolerance_ * energy;
}

void LiteralMethod::judge() {
  report_.status = SolveStatus::Feasible;
  const Report so_far = report_;
  ActiveSetSolution best;
  if (!solve(tight(now_), scaled_.free, best)) {
    report_ = so_far;
    way_.state.farkas_certificate.resize(0);
    return;
  }
  report_ = so_far;
  place(best);
  if (!violated(best).empty() || !close_to(best)) return;
  auto found = confirmed(scaled_, pressed(best.force));
  report_.status = found ? SolveStatus::Solved : SolveStatus::Breakdown;
  if (found) {
    now_ = std::move(found->first);
    way_.state.active = closed_pairs(found->second);
  }
}

QuasiActiveRun LiteralMethod::run() {
  if (outer_loop() && last_step()) judge();
  report_.iterations = static_cast<Index>(report_.history.size());
  const std::vector<Index> closed =
      report_.status == SolveStatus::Solved ? way_.state.active : pressed(now_.force);
  way_.state = finished(problem_, scaled_, now_, statuses_of(closed, now_.force.size()),
                        std::move(report_), std::move(way_.state.farkas_certificate));
  return std::move(way_);
}

}  // namespace

QuasiActiveRun run_quasi_active_set_literal(const ContactProblem& problem,
                                            const SolverOptions& options, QuasiActiveRows rows) {
  check_plain(problem, "quasi_active_set_literal");
  return LiteralMethod(problem, options, rows).run();
}

ContactState quasi_active_set_literal(const ContactProblem& problem, const SolverOptions& options) {
  return run_quasi_active_set_literal(problem, options).state;
}

double energy_gap(const ContactState& state) { return state.force.dot(state.gap); }

}  // namespace signorini
