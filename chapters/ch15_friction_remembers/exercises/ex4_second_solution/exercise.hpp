/// \file
/// Exercise 15.4 - all solutions of one pair with friction. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace ex15_4 {

/// One pair: gap = gap + F_nn lambda + F_nt tau, slip = slip + F_tn lambda + F_tt tau.
struct Pair {
  Eigen::Matrix2d compliance;  ///< F, symmetric positive definite; normal first [length/force]
  double free_gap = 0;         ///< gap without forces [length]; overlap < 0
  double free_slip = 0;        ///< slip without forces [length]
  double coefficient = 0;      ///< mu >= 0 [-]
  double cohesion = 0;         ///< c >= 0, of a closed pair [force]
};

/// A solution.
struct Answer {
  signorini::ContactStatus contact_status;  ///< what the pair does
  double force;                             ///< lambda [force], compression > 0
  double friction;                          ///< tau [force], on the source along the tangent
};

/// All solutions, each with a motion of its own: open with gap >= 0; stuck with |tau| <= mu lambda + c; sliding
/// forward with slip > 0 and tau = -(mu lambda + c), or backward with slip < 0 and the other bound. lambda >= 0 of
/// all that are closed.
/// \param pair  any
/// \return the answers, in the order open, stick, forward, backward
[[nodiscard]] std::vector<Answer> all_answers(const Pair& pair);

}  // namespace ex15_4
