// # Ways that hardly become shorter
//
// Where corrections lead away from each other, an iteration does without how contact forces turn. Then it leaves of its way a
// share q, and where pressure is high q may be near 1, or near -1 if it swings from side to side. Such ways are a geometric
// series whose sum is known. Let \f$ d_k \f$ be the way that an iteration finds and \f$ \omega_k \f$ the share of it that
// is gone; then
// \f[ \omega_k = \omega_{k-1}\,\frac{d_{k-1}\cdot(d_{k-1} - d_k)}{|d_{k-1} - d_k|^2} \f]
// is where the line through the last two ways comes nearest to none. With all of the way gone and \f$ d_k = q\,d_{k-1} \f$ it is
// 1/(1 - q): half of a way that swings, ten times a way that shrinks by a tenth. This is known as Aitken's relaxation.
//
// Newton's method far from its end has long ways too, and its own are better. So two in a row must be slow before one is
// changed.

#include "addons/motion/slow_ways.hpp"

#include <algorithm>

namespace signorini {
namespace {

constexpr int patience = 2;

}  // namespace

bool SlowWays::is_slow(const Eigen::VectorXd& way,
                       const std::vector<ContactStatus>& statuses) const {
  return way_.size() == way.size() && statuses == statuses_ && way.norm() > 0.5 * way_.norm();
}

double SlowWays::share(const Eigen::VectorXd& way,
                       const std::vector<ContactStatus>& statuses) const {
  constexpr double least = 0.1;
  constexpr double most = 20;
  if (slow_ < patience || !is_slow(way, statuses)) return 1;
  const Eigen::VectorXd change = way_ - way;
  const double share = share_ * way_.dot(change) / change.squaredNorm();
  return share > 0 ? std::clamp(share, least, most) : 1;
}

void SlowWays::gone(const Eigen::VectorXd& way, const std::vector<ContactStatus>& statuses,
                    double share) {
  if (is_slow(way, statuses))
    ++slow_;
  else if (slow_ < patience || statuses != statuses_)
    slow_ = 0;
  way_ = way;
  statuses_ = statuses;
  share_ = share;
}

}  // namespace signorini
