/// \file
/// Exercise 17.4 - the smallest lie. Do not change this file.
#pragma once
#include "signorini/problem/certificate.hpp"

namespace ex17_4 {

/// The least share of a force by which it must be made larger, with all gaps left as they are, to be found out.
/// \param problem   as it was posed
/// \param state     a solution whose certificate is accepted
/// \param pair      whose force is changed, from 0
/// \param accepted  largest figure of a certificate that is accepted, 1e-15 or more [-]
/// \return the share, between one that is seen and one that is not which differ by less than a part in a million [-];
///   infinity if the force is 0, or if a share of 1 is not seen
[[nodiscard]] double smallest_lie(const signorini::ContactProblem& problem,
                                  const signorini::ContactState& state, Eigen::Index pair,
                                  double accepted);

}  // namespace ex17_4
