#include "addons/certified/known_forces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "addons/certified/undetermined.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Rows = std::vector<Index>;

/// Solves at most. The signs seldom change after the second.
constexpr int most_solves = 4;

/// The system of the pairs that are closed, or might be.
class Estimate {
 public:
  Estimate(const RefinementData& data, std::shared_ptr<const ActiveSetSystem> system,
           VectorXd rounding)
      : data_(data), system_(std::move(system)), rounding_(std::move(rounding)) {}

  /// The forces of all rows that the worst rounding found makes.
  [[nodiscard]] VectorXd worst() const;
  /// Whether forces of all rows do nothing to any body, and could as well be others.
  [[nodiscard]] bool idle(const VectorXd& force) const;
  /// A force of 1, scaled, on each of some rows, with what the system answers so that no gap moves.
  [[nodiscard]] VectorXd beside(const Rows& others) const;

 private:
  /// What forces of rows() close given movements of rows(), as forces of all rows.
  [[nodiscard]] VectorXd answer(const VectorXd& top, const VectorXd& bottom) const;

  const RefinementData& data_;
  std::shared_ptr<const ActiveSetSystem> system_;
  VectorXd rounding_;
};

VectorXd Estimate::answer(const VectorXd& top, const VectorXd& bottom) const {
  const Rows& rows = system_->rows;
  VectorXd force = VectorXd::Zero(rounding_.size());
  force(rows) = system_->solve(top, bottom).first;
  return force.cwiseProduct(data_.scaled.scale);
}

VectorXd Estimate::worst() const {
  const Rows& rows = system_->rows;
  const VectorXd size = rounding_.cwiseProduct(data_.scaled.scale)(rows);
  const VectorXd bottom = VectorXd::Zero(data_.scaled.rigid.cols());
  VectorXd sign(size.size());
  for (Index k = 0; k < sign.size(); ++k) sign(k) = k % 2 == 0 ? 1 : -1;
  VectorXd most = VectorXd::Zero(rounding_.size());
  for (int solve = 0; solve < most_solves; ++solve) {
    VectorXd force = answer(size.cwiseProduct(sign), bottom);
    if (!(largest(force) > largest(most))) break;
    most = std::move(force);
    for (Index k = 0; k < sign.size(); ++k)
      sign(k) = most(rows[static_cast<std::size_t>(k)]) < 0 ? -1 : 1;
  }
  return most;
}

VectorXd Estimate::beside(const Rows& others) const {
  const ScaledProblem& scaled = data_.scaled;
  VectorXd one = VectorXd::Zero(rounding_.size());
  for (const Index row : others) one(row) = 1;
  VectorXd bottom = VectorXd::Zero(scaled.rigid.cols());
  if (bottom.size() > 0) bottom = scaled.rigid.transpose() * one;
  const VectorXd moved = scaled.compliance * one;
  return one.cwiseProduct(scaled.scale) - answer(moved(system_->rows), bottom);
}

bool Estimate::idle(const VectorXd& force) const {
  const auto& A = data_.programme.A;
  const VectorXd push = A.transpose() * force;
  const VectorXd terms = A.cwiseAbs().transpose() * force.cwiseAbs();
  return largest(push) <= std::sqrt(epsilon) * largest(terms);
}

}  // namespace

ForceUncertainty force_uncertainty(const RefinementData& data, const RefinedSolution& refined,
                                   const PrimalDual& solution,
                                   std::vector<ContactStatus> statuses) {
  const double most = largest(solution.force);
  if (!refined.system || most == 0) return {};
  const VectorXd rounding = movement_rounding(data.programme, solution);
  std::shared_ptr<const ActiveSetSystem> system = refined.system;
  bool as_refined = true;
  const auto roundings =
      2 * static_cast<double>(closed_pairs(statuses).size() + 1);  // as in check_signs()
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    const Index pair = static_cast<Index>(i);
    if (statuses[i] != ContactStatus::Open || refined.movement(pair) > roundings * rounding(pair))
      continue;
    statuses[i] = ContactStatus::Stick;
    as_refined = false;
  }
  ActiveSet set = active_set(statuses, data.scaled.law);
  Rows rows = system->rows;
  if (!as_refined) {  // those that rounding may have opened repeat the others, not the other way round
    std::sort(rows.begin(), rows.end());
    std::stable_partition(set.closed.begin(), set.closed.end(), [&rows](Index row) {
      return std::binary_search(rows.begin(), rows.end(), row);
    });
    system = std::make_shared<const ActiveSetSystem>(active_set_system(data.scaled, set));
    rows = system->rows;
    std::sort(set.closed.begin(), set.closed.end());
  }
  if (rows.empty()) return {};
  const Estimate estimate(data, system, rounding);
  std::sort(rows.begin(), rows.end());
  Rows repeated;
  std::set_difference(set.closed.begin(), set.closed.end(), rows.begin(), rows.end(),
                      std::back_inserter(repeated));
  ForceUncertainty uncertainty;
  VectorXd force = estimate.worst();
  uncertainty.share = std::min(1.0, largest(force) / most);
  if (estimate.idle(force)) uncertainty.share = 0;
  if (!repeated.empty()) {
    const VectorXd other = estimate.beside(repeated);
    if (!estimate.idle(other)) {
      force = other;
      uncertainty.share = 1;
    }
  }
  if (!(uncertainty.share > 0)) return {};
  force.cwiseAbs().maxCoeff(&uncertainty.pair);
  if (const Index slip = uncertainty.pair - static_cast<Index>(statuses.size()); slip >= 0)
    uncertainty.pair = data.scaled.law.pair[static_cast<std::size_t>(slip)];
  return uncertainty;
}

}  // namespace signorini
