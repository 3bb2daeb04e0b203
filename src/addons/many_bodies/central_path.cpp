#include "addons/many_bodies/central_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

// What is compared with relative changes: 1 would let a factor vanish. The path does not depend on these numbers; only the number
// of steps does.

/// A step along the path is no longer than this.
constexpr double longest = 0.6;
/// Steps to the path are no longer than this, and only what is nearer goes along.
constexpr double longest_back = 0.8;
constexpr double near_path = 0.5;
/// Products may differ from m by this factor.
constexpr double uneven = 4;
/// Tries with the curvature of the path, before those without.
constexpr int curved_tries = 2;
constexpr int most_tries = 40;

}  // namespace

CentralPath::CentralPath(const Eigen::SparseMatrix<double>& compliance, const VectorXd& free,
                         FrictionLaw law, double wide)
    : scale_(VectorXd(compliance.diagonal()).cwiseSqrt().cwiseInverse()),
      F_(scale_.asDiagonal() * compliance * scale_.asDiagonal()),
      free_(scale_.cwiseProduct(free)),
      law_(std::move(law)),
      reach_(longest) {
  const Index pairs = free_.size() - static_cast<Index>(law_.pair.size());
  const VectorXd own = scale_.tail(free_.size() - pairs);
  law_.coefficient = law_.coefficient.cwiseProduct(VectorXd(scale_(law_.pair))).cwiseQuotient(own);
  law_.cohesion = law_.cohesion.cwiseQuotient(own);
  const double size = largest(free_);
  level_ = first_level_ = wide * size * size;
  force_.setZero(free_.size());
  force_.head(pairs).setConstant(size);
  room_ = rooms(force_, true);
  give_ = level_ * room_.cwiseInverse();
  lack_ = (free_ + F_ * force_ - movements(give_)) / level_;
}

VectorXd CentralPath::rooms(const VectorXd& force, bool cohesion) const {
  const Index slips = static_cast<Index>(law_.pair.size());
  VectorXd bound = law_.coefficient.cwiseProduct(VectorXd(force(law_.pair)));
  if (cohesion) bound += law_.cohesion;
  VectorXd room(force.size() + slips);
  room << force.head(force.size() - slips), bound + force.tail(slips), bound - force.tail(slips);
  return room;
}

VectorXd CentralPath::movements(const VectorXd& give) const {
  const Index slips = static_cast<Index>(law_.pair.size());
  VectorXd movement = give.head(give.size() - slips);
  movement.tail(slips) -= give.tail(slips);
  return movement;
}

bool CentralPath::factorise() {
  const Index slips = static_cast<Index>(law_.pair.size());
  const Index pairs = free_.size() - slips;
  const VectorXd soft = give_.cwiseQuotient(room_);
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < pairs; ++i) entries.emplace_back(i, i, soft(i));
  for (Index k = 0; k < slips; ++k) {
    const Index row = pairs + k;
    const double forward = soft(row);
    const double backward = soft(row + slips);
    entries.emplace_back(row, row, forward + backward);
    entries.emplace_back(row, law_.pair[at(k)], law_.coefficient(k) * (forward - backward));
  }
  Eigen::SparseMatrix<double> softness(free_.size(), free_.size());
  softness.setFromTriplets(entries.begin(), entries.end());
  return factor_.factorise(F_ + softness);
}

CentralPath::Change CentralPath::change(const VectorXd& products, const VectorXd& moves) const {
  const VectorXd given = products.cwiseQuotient(room_);
  Change result;
  result.force = factor_.solve(moves + movements(given));
  result.room = rooms(result.force, false);
  result.give = given - give_.cwiseProduct(result.room).cwiseQuotient(room_);
  return result;
}

CentralPath::Change CentralPath::sum(double a, const Change& one, double b, const Change& other) {
  return {a * one.force + b * other.force, a * one.room + b * other.room,
          a * one.give + b * other.give};
}

VectorXd CentralPath::relative(const Change& change) const {
  VectorXd both(2 * room_.size());
  both << change.room.cwiseQuotient(room_), change.give.cwiseQuotient(give_);
  return both;
}

bool CentralPath::step(const Change& back, double level_back, const Change& along, double unit,
                       double sign) {
  const double off = largest(relative(back));
  double part = off > longest_back ? longest_back / off : 1;
  double reach = off > near_path ? 0 : reach_;
  for (int tried = 0; tried < most_tries; ++tried) {
    const double forward = sign * reach * unit;
    const double level = level_ + part * level_back + forward;
    Change all = sum(part, back, forward, along);
    if (tried < curved_tries)
      all = sum(1, all, 1, change(-all.room.cwiseProduct(all.give), VectorXd::Zero(free_.size())));
    const VectorXd room = room_ + all.room;
    const VectorXd give = give_ + all.give;
    const VectorXd products = room.cwiseProduct(give);
    if (level > 0 && (room.array() > 0).all() && (give.array() > 0).all() &&
        (reach == 0 || (products.minCoeff() > level / uneven &&
                        products.maxCoeff() < uneven * level))) {
      if (reach > 0) reach_ = tried == 0 ? std::min(longest, 2 * reach) : reach;
      force_ += all.force;
      room_ = room;
      give_ = give;
      level_ = level;
      return true;
    }
    if (tried + 1 != curved_tries) reach *= 0.5;
    if (tried + 1 == curved_tries && reach > 0) reach = reach_;
    if (reach < 1e-4 * reach_) {
      if (reach == 0) part *= 0.5;
      reach = 0;
    }
  }
  return false;
}

bool CentralPath::advance() {
  if (!factorise()) return false;
  if (first_sign_ == 0) first_sign_ = factor_.sign();
  const VectorXd all = VectorXd::Ones(room_.size());
  const VectorXd missing = free_ + F_ * force_ - movements(give_) - level_ * lack_;
  const Change off = change(level_ * all - room_.cwiseProduct(give_), -missing);
  const Change along = change(all, lack_);
  const VectorXd way = relative(along);
  const double level_way = 1 / level_;
  // The part of `off` along the path is no way back.
  const double level_back = -way.dot(relative(off)) / (way.squaredNorm() + level_way * level_way);
  const Change back = sum(1, off, level_back, along);
  const double unit = 1 / std::max(largest(way), level_way);
  return std::isfinite(level_back) &&
         step(back, level_back, along, unit, factor_.sign() == first_sign_ ? -1 : 1);
}

bool CentralPath::follow(double part, Index most) {
  while (level_ > part * first_level_) {
    if (steps_ >= most || !advance()) return false;
    ++steps_;
  }
  return true;
}

}  // namespace signorini
