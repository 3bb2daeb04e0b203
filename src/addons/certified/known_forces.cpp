#include "addons/certified/known_forces.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Rows = std::vector<Index>;

/// Solves at most. The signs seldom change after the second.
constexpr int most_solves = 4;

/// \return whether a row is one of some
auto in(Rows rows) {
  std::sort(rows.begin(), rows.end());
  return [rows = std::move(rows)](Index row) {
    return std::binary_search(rows.begin(), rows.end(), row);
  };
}

/// The system of the pairs that are closed, or might be. Those that rounding may have opened stick; they come last, so that they
/// repeat the others, not the other way round.
std::shared_ptr<const ActiveSetSystem> touching_system(const RefinementData& data,
                                                       const RefinedSolution& refined,
                                                       const VectorXd& rounding,
                                                       std::vector<ContactStatus>& statuses) {
  const std::vector<ContactStatus> as_refined = statuses;
  const auto roundings =
      2 * static_cast<double>(closed_pairs(statuses).size() + 1);  // as in check_signs()
  for (Index pair = 0; pair < static_cast<Index>(statuses.size()); ++pair)
    if (statuses[at(pair)] == ContactStatus::Open &&
        !(refined.movement(pair) > roundings * rounding(pair)))
      statuses[at(pair)] = ContactStatus::Stick;
  if (statuses == as_refined) return refined.system;
  ActiveSet set = active_set(statuses, data.scaled.law);
  std::stable_partition(set.closed.begin(), set.closed.end(), in(refined.system->rows));
  return std::make_shared<const ActiveSetSystem>(active_set_system(data.scaled, set));
}

/// Forces of all rows that a system answers given movements of its rows with.
struct Estimate {
  const RefinementData& data;
  const ActiveSetSystem& system;

  [[nodiscard]] VectorXd answer(const VectorXd& top, const VectorXd& bottom) const {
    VectorXd force = VectorXd::Zero(data.scaled.scale.size());
    force(system.rows) = system.solve(top, bottom).first;
    return force.cwiseProduct(data.scaled.scale);
  }

  /// The forces that the worst signs of roundings make.
  [[nodiscard]] VectorXd worst(const VectorXd& rounding) const {
    const VectorXd size = rounding.cwiseProduct(data.scaled.scale)(system.rows);
    VectorXd sign(size.size());
    Rows rising = system.rows;
    std::sort(rising.begin(), rising.end());
    for (Index k = 0; k < sign.size(); ++k) {
      const auto place = std::lower_bound(rising.begin(), rising.end(), system.rows[at(k)]);
      sign(k) = (place - rising.begin()) % 2 == 0 ? 1 : -1;
    }
    VectorXd most = VectorXd::Zero(rounding.size());
    for (int solve = 0; solve < most_solves; ++solve) {
      const VectorXd force =
          answer(size.cwiseProduct(sign), VectorXd::Zero(data.scaled.rigid.cols()));
      if (!(largest(force) > largest(most))) break;
      most = force;
      sign = (most(system.rows).array() < 0).select(VectorXd::Constant(sign.size(), -1), 1.0);
    }
    return most;
  }

  /// A force of 1, scaled, on each of some rows, with what the system answers so that no gap moves.
  [[nodiscard]] VectorXd beside(const Rows& others) const {
    VectorXd one = VectorXd::Zero(data.scaled.scale.size());
    one(others).setOnes();
    VectorXd bottom;
    if (data.scaled.rigid.cols() > 0) bottom = data.scaled.rigid.transpose() * one;
    const VectorXd moved = data.scaled.compliance * one;
    return one.cwiseProduct(data.scaled.scale) - answer(moved(system.rows), bottom);
  }

  /// Whether forces of all rows do nothing to any body, and could as well be others.
  [[nodiscard]] bool idle(const VectorXd& force) const {
    const auto& A = data.programme.A;
    const VectorXd push = A.transpose() * force;
    const VectorXd terms = A.cwiseAbs().transpose() * force.cwiseAbs();
    return largest(push) <= std::sqrt(epsilon) * largest(terms);
  }
};

}  // namespace

VectorXd movement_rounding(const QuadraticProgramme& programme, const PrimalDual& solution) {
  const VectorXd moved = programme.A.cwiseAbs() * solution.displacement.cwiseAbs();
  return 0.5 * epsilon * (programme.initial_gap.cwiseAbs() + moved);
}

ForceUncertainty force_uncertainty(const RefinementData& data, const RefinedSolution& refined,
                                   const PrimalDual& solution,
                                   std::vector<ContactStatus> statuses) {
  const double most = largest(solution.force);
  if (!refined.system || most == 0) return {};
  const VectorXd rounding = movement_rounding(data.programme, solution);
  const auto system = touching_system(data, refined, rounding, statuses);
  if (system->rows.empty()) return {};
  const Estimate estimate{data, *system};
  VectorXd force = estimate.worst(rounding);
  ForceUncertainty uncertainty;
  uncertainty.share = estimate.idle(force) ? 0 : std::min(1.0, largest(force) / most);
  Rows repeated = active_set(statuses, data.scaled.law).closed;
  repeated.erase(std::remove_if(repeated.begin(), repeated.end(), in(system->rows)), repeated.end());
  if (!repeated.empty()) {
    if (const VectorXd other = estimate.beside(repeated); !estimate.idle(other)) {
      force = other;
      uncertainty.share = 1;
    }
  }
  if (!(uncertainty.share > 0)) return {};
  force.cwiseAbs().maxCoeff(&uncertainty.pair);
  if (const Index slip = uncertainty.pair - static_cast<Index>(statuses.size()); slip >= 0)
    uncertainty.pair = data.scaled.law.pair[at(slip)];
  return uncertainty;
}

}  // namespace signorini
