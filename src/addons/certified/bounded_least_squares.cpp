#include "addons/certified/bounded_least_squares.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// An active set of weights that are at no bound.
class WeightsInUse {
 public:
  explicit WeightsInUse(const BoundedWeights& all)
      : all_(all),
        weight_(VectorXd::Zero(all.direction.rows())),
        rounding_(static_cast<double>(all.direction.rows() + all.direction.cols()) * epsilon *
                  all.target.norm()) {}

  /// \return D^T w - t at the end
  VectorXd run() {
    const Index most_rounds = 10 * weight_.size() + 100;
    for (Index round = 0; round < most_rounds; ++round) {
      const VectorXd missing = this->missing();
      const Index next = entering(missing);
      if (next < 0) break;
      const VectorXd before = weight_;
      used_.push_back(next);
      while (!used_.empty() && !step()) continue;
      if (this->missing().norm() < missing.norm()) continue;
      weight_ = before;  // rounding, or too large
      break;
    }
    VectorXd way = -missing();
    // The difference of two close numbers. What it must be orthogonal to, generators that are at no bound, gives back
    // the digits that it lost.
    if (used_.empty()) return way;
    const MatrixXd Q = column_span(all_.direction(used_, Eigen::all).transpose()).basis;
    for (int sweep = 0; sweep < 2; ++sweep) way -= Q * (Q.transpose() * way);
    return way;
  }

 private:
  [[nodiscard]] VectorXd missing() const {
    return all_.target - all_.direction.transpose() * weight_;
  }

  /// \return the weight at a bound that gains most by leaving it; -1 if none gains
  [[nodiscard]] Index entering(const VectorXd& missing) const {
    VectorXd gain = all_.direction * missing;
    for (Index i = 0; i < gain.size(); ++i)  // at its upper bound a weight can only fall
      if (weight_(i) > 0) gain(i) = weight_(i) == all_.most(i) ? -gain(i) : 0;
    for (const Index i : used_) gain(i) = 0;
    Index next = 0;
    return gain.size() == 0 || gain.maxCoeff(&next) <= rounding_ ? -1 : next;
  }

  /// The best weights of those in use, of any sign, while the others stay at their bounds.
  [[nodiscard]] VectorXd best() const {
    VectorXd rest = all_.target;
    for (Index i = 0; i < weight_.size(); ++i)
      if (std::find(used_.begin(), used_.end(), i) == used_.end())
        rest -= weight_(i) * all_.direction.row(i).transpose();
    return least_norm_solution(all_.direction(used_, Eigen::all).transpose(), rest);
  }

  /// Goes towards the best weights as far as the bounds allow; those that meet theirs are in use no more.
  /// \return whether none met its bound
  bool step() {
    const VectorXd best = this->best();
    double part = 1;
    for (std::size_t k = 0; k < used_.size(); ++k) {
      const double now = weight_(used_[k]), end = best(static_cast<Index>(k));
      const double most = all_.most(used_[k]);
      if (end <= 0) part = std::min(part, now / (now - end));
      if (end > most) part = std::min(part, (most - now) / (end - now));
    }
    std::vector<Index> kept;
    for (std::size_t k = 0; k < used_.size(); ++k) {
      double& now = weight_(used_[k]);
      const double end = best(static_cast<Index>(k)), most = all_.most(used_[k]);
      now += part * (end - now);
      const bool low = part < 1 && end <= 0 && now <= rounding_;  // a small one that grows stays
      const bool high = part < 1 && now >= most - rounding_;
      if (low) now = 0;
      if (high) now = most;
      if (!low && !high) kept.push_back(used_[k]);
    }
    const bool free = kept.size() == used_.size();
    used_ = std::move(kept);
    return free;
  }

  const BoundedWeights& all_;
  VectorXd weight_;
  double rounding_;
  std::vector<Index> used_;
};

}  // namespace

VectorXd bounded_least_squares(const BoundedWeights& all) { return WeightsInUse(all).run(); }

}  // namespace signorini
