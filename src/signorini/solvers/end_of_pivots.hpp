// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What the last basis of Lemke's method says of the problem.
#pragma once
#include "signorini/problem/active_set_system.hpp"
#include "signorini/solvers/dictionary.hpp"

namespace signorini {

/// Where a path ended, in scaled numbers.
struct EndOfPivots {
  ActiveSetSolution solution;           ///< forces and gaps
  std::vector<ContactStatus> statuses;  ///< `n_c`
  Report report;                        ///< with the status that the numbers deserve
  Eigen::VectorXd proof = {};           ///< `n_c` that nothing solves the problem [force], or empty
};

/// The end of a path on which z_0 has left the basis. \param scaled  M and q \param dictionary  of the last basis
/// \param report  of the pivots \return forces and gaps found anew from M and q: `Solved`, `Infeasible` with the proof if M is symmetric,
///   `Breakdown` if rounding spoiled the basis
[[nodiscard]] EndOfPivots last_basis(const ScaledProblem& scaled, const Dictionary& dictionary,
                                     Report report);

/// The end of a path on which nothing blocks the entering variable. \param scaled  M and q \param dictionary  of the last basis
/// \param entering  variable \param report  of the pivots \return `Infeasible` with the proof if M is symmetric and the ray is one; else `Ray`
[[nodiscard]] EndOfPivots ray(const ScaledProblem& scaled, const Dictionary& dictionary,
                              Eigen::Index entering, Report report);

/// Where a path stands, which is no solution. \param scaled  M and q \param dictionary  of the last basis \param report  of the
/// pivots, with its status \return forces of the basis, those that rounding made negative 0, and their gaps
[[nodiscard]] EndOfPivots last_point(const ScaledProblem& scaled, const Dictionary& dictionary,
                                     Report report);

}  // namespace signorini
