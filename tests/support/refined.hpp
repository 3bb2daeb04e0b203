/// \file
/// A set of closed pairs without friction, refined and judged.
#pragma once
#include <utility>
#include <vector>

#include "signorini/problem/iterative_refinement.hpp"
#include "signorini/scene/rigid_modes.hpp"

namespace signorini_test {

/// A refinement and what it says of the pairs.
struct Refined : signorini::RefinedSolution {
  bool confirmed = false;
};

/// \param programme  K, p, A, g
/// \param solve      K^-1
/// \param compliance G
/// \param start      where to start
/// \param closed     pairs
/// \param modes      N, or nothing
/// \return what iterative_refinement() and check_signs() make of it
inline Refined refined(const signorini::QuadraticProgramme& programme,
                       const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve,
                       const Eigen::MatrixXd& compliance, signorini::PrimalDual start,
                       const std::vector<Eigen::Index>& closed, const Eigen::MatrixXd& modes = {}) {
  const Eigen::Index pairs = start.force.size();
  signorini::ContactProblem condensed{compliance, Eigen::VectorXd::Zero(pairs)};
  if (modes.cols() > 0) {
    condensed.rigid = signorini::rigid_gaps(programme.A, modes.sparseView());
    condensed.resultant = Eigen::VectorXd::Zero(modes.cols());
  }
  const std::vector<signorini::ContactStatus> statuses = signorini::statuses_of(closed, pairs);
  const signorini::ScaledProblem scaled = signorini::equilibrate(condensed);
  const signorini::RefinementData data{programme, solve, condensed, scaled, modes};
  const Eigen::VectorXd force = std::exchange(start.force, Eigen::VectorXd::Zero(pairs));
  Refined result{signorini::iterative_refinement(data, std::move(start), force, statuses)};
  result.confirmed = signorini::check_signs(data, result, statuses).confirmed;
  return result;
}

}  // namespace signorini_test
