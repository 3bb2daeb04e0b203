#include "signorini/solvers/goldfarb_idnani.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/closing/closed_factor.hpp"
#include "signorini/closing/closed_pairs.hpp"
#include "signorini/closing/refutation.hpp"
#include "signorini/closing/scaled_half.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;

const double infinity = std::numeric_limits<double>::infinity();

/// The method itself, on scaled numbers.
template <typename Problem, typename Basis>
class DualMethod {
 public:
  DualMethod(const Problem& problem, Basis basis)
      : problem_(problem), basis_(std::move(basis)), force_(problem.free_gap.size() + 1) {
    rows_.reserve(static_cast<std::size_t>(problem.free_gap.size()));
  }

  ContactState run(const SolverOptions& options) {
    const Index n = problem_.free_gap.size();
    limit_ = options.iteration_limit > 0 ? options.iteration_limit : 100 * n + 100;
    while (true) {
      basis_.gaps(rows_, force_, gap_, rounding_);
      for (const Index i : rows_) gap_(i) = 0;
      remember();
      Index pair = worst();
      // The forces carry the rounding of all steps so far; what that might explain is found anew.
      if (pair < 0 ||
          -gap_(pair) <= rounding_(pair) * static_cast<double>(report_.iterations + 1)) {
        std::vector<Index> active = rows_;
        std::sort(active.begin(), active.end());
        const ClosedPairs closed = close_pairs(problem_, active);
        report_.factorisations += active.empty() ? 0 : 1;
        if (solves(problem_, closed)) return solved(closed, std::move(active));
        if (closed.solvable) pair = refined(closed);
        if (pair < 0) return without_touching(closed);
      }
      if (!close(pair)) return ended(pair);
    }
  }

 private:
  /// The pair that overlaps most, or -1.
  [[nodiscard]] Index worst() const {
    Index pair = -1;
    for (Index i = 0; i < gap_.size(); ++i)
      if (gap_(i) < -rounding_(i) && (pair < 0 || gap_(i) < gap_(pair))) pair = i;
    return pair;
  }

  void remember() {
    if (gap_.size() == 0) return;
    const double overlap = std::max(0.0, -gap_.cwiseQuotient(problem_.scale).minCoeff());
    const Index count = (gap_.array() < -rounding_.array()).count();
    double energy = 0;  // -d.lambda - 1/2 lambda.G lambda, and W is closed
    for (Index k = 0; k < basis_.size(); ++k)
      energy -= 0.5 * force_(k) * problem_.free_gap(rows_[static_cast<std::size_t>(k)]);
    report_.history.push_back({basis_.size(), count, overlap, 0, energy});
  }

  /// Takes over the forces that close W exactly.
  /// \return the pair that overlaps by them, or -1
  Index refined(const ClosedPairs& closed) {
    for (std::size_t k = 0; k < rows_.size(); ++k)
      force_(static_cast<Index>(k)) = std::max(0.0, closed.force(rows_[k]));
    gap_ = closed.gap;
    rounding_ = closed.gap_rounding;
    return worst();
  }

  /// Presses a pair until it is closed.
  /// \return false if it cannot be closed, or at the limit
  bool close(Index pair) {
    double pressed = 0;
    while (report_.iterations < limit_) {
      const Index k = basis_.size();
      const double opening = basis_.press(rows_, pair);
      const double enough = opening > 0 ? -gap_(pair) / opening : infinity;
      Index first = -1;
      double step = enough;
      const double tiny = static_cast<double>(k + 1) * epsilon *
                          (k > 0 ? basis_.response().cwiseAbs().maxCoeff() : 0);
      for (Index j = 0; j < k; ++j)
        if (basis_.response()(j) > tiny && force_(j) < step * basis_.response()(j)) {
          step = force_(j) / basis_.response()(j);
          first = j;
        }
      if (std::isinf(step)) {
        impossible_ = true;
        return false;
      }
      force_.head(k) -= step * basis_.response();
      pressed += step;
      ++report_.iterations;
      if (first < 0) {
        force_(k) = pressed;
        basis_.join();
        rows_.push_back(pair);
        return true;
      }
      gap_(pair) += step * opening;
      drop(first);
    }
    return false;
  }

  void drop(Index position) {
    basis_.leave(position);
    rows_.erase(rows_.begin() + position);
    for (Index j = position; j < basis_.size(); ++j) force_(j) = force_(j + 1);
  }

  ContactState solved(const ClosedPairs& closed, std::vector<Index> active) {
    report_.status = Status::Solved;
    return unscaled(problem_, closed, std::move(active), report_);
  }

  /// The end if W has a pair that touches without force, which rounding made tensile.
  ContactState without_touching(const ClosedPairs& closed) {
    std::vector<Index> pressed;
    for (const Index i : rows_)
      if (closed.force(i) > closed.force_rounding(i)) pressed.push_back(i);
    if (auto found = confirmed(problem_, pressed))
      return solved(found->first, std::move(found->second));
    return last(Status::Breakdown);
  }

  ContactState ended(Index pair) {
    if (!impossible_) return last(Status::IterationLimit);
    Eigen::VectorXd y = contradiction(problem_, rows_, pair);
    ContactState state = last(y.size() > 0 ? Status::Infeasible : Status::Breakdown);
    state.infeasibility = std::move(y);
    return state;
  }

  /// Where the method stands, which is no solution.
  ContactState last(Status status) {
    report_.status = status;
    ClosedPairs now;
    now.force.setZero(problem_.free_gap.size());
    for (std::size_t k = 0; k < rows_.size(); ++k)
      now.force(rows_[k]) = force_(static_cast<Index>(k));
    now.gap = gap_;
    std::vector<Index> active = rows_;
    std::sort(active.begin(), active.end());
    return unscaled(problem_, now, std::move(active), report_);
  }

  const Problem& problem_;
  Basis basis_;
  std::vector<Index> rows_;  ///< W, in the order of the factor
  Eigen::VectorXd force_;    ///< of W, in this order
  Eigen::VectorXd gap_;
  Eigen::VectorXd rounding_;
  Report report_;
  Index limit_ = 0;
  bool impossible_ = false;
};

}  // namespace

ContactState goldfarb_idnani(const ContactProblem& problem, const SolverOptions& options) {
  const ScaledProblem scaled = equilibrate(problem);
  return certified(
      problem,
      DualMethod<ScaledProblem, ComplianceFactor>(scaled, ComplianceFactor(scaled)).run(options));
}

ContactState goldfarb_idnani(const HalfProblem& problem, const SolverOptions& options) {
  const ScaledHalf scaled = equilibrate(problem);
  ContactState state = DualMethod<ScaledHalf, HalfFactor>(scaled, HalfFactor(scaled)).run(options);
  if (state.report.status == Status::Infeasible && !refutes(problem, state.infeasibility)) {
    state.report.status = Status::Breakdown;
    state.infeasibility.resize(0);
  }
  return state;
}

}  // namespace signorini
