/// \file
/// Exercise 19.4 - a stiffness that grows. Do not change this file.
#pragma once
#include "signorini/problem/problem.hpp"
#include "signorini/solvers/enumerate.hpp"

namespace ex19_4 {

/// Where the loop ended.
struct Ending {
  Eigen::VectorXd force;    ///< `n`, none negative [force]
  Eigen::Index passes = 0;  ///< problems with springs that were solved
  bool ended =
      false;  ///< whether no overlap is larger than the accuracy times the largest one without contact
};

/// Forces of springs that only press, beside forces that are kept: f = max(0, kept - stiffness * gap), gap = d + G f.
/// \param problem    `n` pairs
/// \param kept       `n` forces, none negative [force]
/// \param stiffness  of each spring, positive [force/length]
/// \return `n` f [force]
[[nodiscard]] inline Eigen::VectorXd on_springs(const signorini::ContactProblem& problem,
                                                const Eigen::VectorXd& kept, double stiffness) {
  signorini::ContactProblem soft = problem;  // f / k - kept / k + d + G f >= 0, complementary to f
  soft.compliance.diagonal().array() += 1 / stiffness;
  soft.free_gap -= kept / stiffness;
  return signorini::enumerate(soft).force;
}

/// The augmented Lagrangian, from forces of zero. After a pass that leaves more than a tenth of the largest overlap
/// before it, the springs of the next pass are ten times as stiff.
/// \param problem    a few pairs, without friction and rigid modes
/// \param stiffness  of the first springs, positive [force/length]
/// \param accuracy   largest overlap that may be left, over the largest one without contact [-]
/// \param most       passes, at least 1
/// \return the forces of the last pass; zero after one pass if nothing overlaps
[[nodiscard]] Ending augmented_lagrangian(const signorini::ContactProblem& problem,
                                          double stiffness, double accuracy, Eigen::Index most);

}  // namespace ex19_4
