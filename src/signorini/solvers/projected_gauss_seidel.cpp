#include "signorini/solvers/projected_gauss_seidel.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/closing/closed_pairs.hpp"
#include "signorini/closing/scaled_half.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Gaps that follow the forces, G given: all of them are kept.
class GapsOfCompliance {
 public:
  explicit GapsOfCompliance(const ScaledProblem& problem)
      : problem_(problem), gap_(problem.free_gap) {}
  [[nodiscard]] double gap(Index i) const { return gap_(i); }
  void press(Index i, double change) { gap_ += change * problem_.compliance.col(i); }
  void renew(const Eigen::VectorXd& force) {
    gap_ = problem_.free_gap;
    gap_.noalias() += problem_.compliance * force;
  }
  [[nodiscard]] const Eigen::VectorXd& gaps() const { return gap_; }
  [[nodiscard]] Eigen::VectorXd stiffness() const { return problem_.compliance.diagonal(); }

 private:
  const ScaledProblem& problem_;
  Eigen::VectorXd gap_;
};

/// Gaps that follow the forces, G = H^T H: H lambda is kept, and a gap is found when it is needed.
class GapsOfHalf {
 public:
  explicit GapsOfHalf(const ScaledHalf& problem)
      : problem_(problem), moved_(Eigen::VectorXd::Zero(problem.half.rows())) {}
  [[nodiscard]] double gap(Index i) const {
    return problem_.free_gap(i) + problem_.half.col(i).dot(moved_);
  }
  void press(Index i, double change) { moved_ += change * problem_.half.col(i); }
  void renew(const Eigen::VectorXd& force) { moved_.noalias() = problem_.half * force; }
  [[nodiscard]] Eigen::VectorXd gaps() const {
    return problem_.free_gap + problem_.half.transpose() * moved_;
  }
  [[nodiscard]] Eigen::VectorXd stiffness() const {
    return problem_.half.colwise().squaredNorm().transpose();
  }

 private:
  const ScaledHalf& problem_;
  Eigen::VectorXd moved_;
};

using Found = std::optional<std::pair<ClosedPairs, std::vector<Index>>>;

/// Sweeps 0 to 31, then every second one, every fourth from 64 on, and so on.
bool is_kept(Index sweep) {
  Index spacing = 1;
  while (sweep / spacing >= 32) spacing *= 2;
  return sweep % spacing == 0;
}

/// Sweeps over all pairs until the set of those with a force can be closed exactly.
template <typename Problem, typename Gaps>
class Sweeps {
 public:
  explicit Sweeps(const Problem& problem)
      : problem_(problem),
        gaps_(problem),
        stiffness_(gaps_.stiffness()),
        force_(Eigen::VectorXd::Zero(problem.free_gap.size())),
        closed_(static_cast<std::size_t>(problem.free_gap.size()), false) {}

  ContactState run(const SolverOptions& options) {
    const Index n = force_.size();
    const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 1000 + 10 * n;
    Index unchanged = 0;  // sweeps since the set has changed
    while (true) {
      unchanged = sweep() ? 0 : unchanged + 1;
      ++report_.iterations;
      gaps_.renew(force_);
      if (n > 0 && is_kept(report_.iterations - 1)) remember();
      const bool last = report_.iterations == limit;
      // A set that could not be closed is tried again now and then: the order of its forces matters.
      const bool power_of_two = (unchanged & (unchanged - 1)) == 0;
      if (!last && (unchanged == 0 || !power_of_two)) continue;
      const std::vector<Index> candidates = by_force();
      report_.factorisations += candidates.empty() ? 0 : 1;
      if (Found found = confirmed(problem_, candidates)) {
        report_.status = Status::Solved;
        return unscaled(problem_, found->first, std::move(found->second), report_);
      }
      if (last) return unfinished();
    }
  }

 private:
  /// \return whether the set of pairs with a force has changed
  bool sweep() {
    bool changed = false;
    for (Index i = 0; i < force_.size(); ++i) {
      if (stiffness_(i) == 0) continue;  // no force moves it
      const double force = std::max(0.0, force_(i) - gaps_.gap(i) / stiffness_(i));
      if (force != force_(i)) gaps_.press(i, force - force_(i));
      force_(i) = force;
      const bool closed = force > 0;
      changed = changed || closed != closed_[static_cast<std::size_t>(i)];
      closed_[static_cast<std::size_t>(i)] = closed;
    }
    return changed;
  }

  void remember() {
    const Eigen::VectorXd gap = gaps_.gaps();
    const double overlap = std::max(0.0, -gap.cwiseQuotient(problem_.scale).minCoeff());
    report_.history.push_back({(force_.array() > 0).count(),
                               ((gap.array() < 0) && (force_.array() == 0)).count(), overlap, 0,
                               -0.5 * force_.dot(problem_.free_gap + gap)});
  }

  /// Pairs with a force, the largest first.
  [[nodiscard]] std::vector<Index> by_force() const {
    std::vector<Index> order;
    for (Index i = 0; i < force_.size(); ++i)
      if (force_(i) > 0) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index i, Index j) { return force_(i) > force_(j); });
    return order;
  }

  ContactState unfinished() {
    report_.status = Status::IterationLimit;
    ClosedPairs now;
    now.force = force_;
    now.gap = gaps_.gaps();
    std::vector<Index> active = by_force();
    std::sort(active.begin(), active.end());
    return unscaled(problem_, now, std::move(active), report_);
  }

  const Problem& problem_;
  Gaps gaps_;
  Eigen::VectorXd stiffness_;
  Eigen::VectorXd force_;
  std::vector<bool> closed_;
  Report report_;
};

}  // namespace

ContactState projected_gauss_seidel(const ContactProblem& problem, const SolverOptions& options) {
  const ScaledProblem scaled = equilibrate_any(problem);
  for (Index i = 0; i < problem.free_gap.size(); ++i) {
    const bool zero = problem.compliance.row(i).isZero(0) && problem.compliance.col(i).isZero(0);
    if (problem.compliance(i, i) > 0 || zero) continue;
    ContactState state;  // its force cannot close this pair
    state.force.setZero(problem.free_gap.size());
    state.gap = problem.free_gap;
    return state;
  }
  return certified(problem, Sweeps<ScaledProblem, GapsOfCompliance>(scaled).run(options));
}

ContactState projected_gauss_seidel(const HalfProblem& problem, const SolverOptions& options) {
  const ScaledHalf scaled = equilibrate(problem);
  return Sweeps<ScaledHalf, GapsOfHalf>(scaled).run(options);
}

}  // namespace signorini
