/// \file
/// A set of closed pairs without friction, refined and judged.
#pragma once
#include <utility>
#include <vector>

#include "signorini/programme/refine.hpp"

namespace signorini_test {

/// A refinement and what it says of the pairs.
struct Refined : signorini::Refinement {
  bool confirmed = false;
};

/// \param programme  K, p, A, g
/// \param solve      K^-1
/// \param compliance G
/// \param start      where to start
/// \param closed     pairs
/// \param modes      N, or nothing
/// \return what refine() and judge() make of it
inline Refined refined(const signorini::QuadraticProgramme& programme,
                       const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve,
                       const Eigen::MatrixXd& compliance, signorini::PrimalDual start,
                       const std::vector<Eigen::Index>& closed, const Eigen::MatrixXd& modes = {}) {
  std::vector<signorini::Motion> motions(static_cast<std::size_t>(start.force.size()),
                                         signorini::Motion::Open);
  for (const Eigen::Index pair : closed)
    motions[static_cast<std::size_t>(pair)] = signorini::Motion::Stick;
  Refined result{signorini::refine(programme, solve, compliance, std::move(start),
                                   signorini::known_set(motions, {}), modes)};
  result.confirmed = signorini::judge(programme, {}, result, motions, modes).confirmed;
  return result;
}

}  // namespace signorini_test
