/// \file
/// Tries every set of closed pairs: slow, and certain.
#pragma once
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Most pairs that enumerate() accepts: 4096 sets.
inline constexpr Eigen::Index largest_enumeration = 12;

/// Solves a small contact problem, or w = M z + q with any matrix, by looking at all 2^n_c sets of
/// closed pairs.
///
/// A set is a solution if its forces and the gaps of the open pairs are not negative beyond
/// rounding. Of several (a pair that just touches may be called open or closed) the one with the
/// fewest pairs is returned. Of a symmetric positive semidefinite M, sets with
/// a singular block are left out: another set gives the same displacements. Of another matrix their least-norm
/// solution is tried; a solution may be missed.
///
/// \param problem  of at most 12 pairs
/// \param options  not used: every set that could be better than the best so far is tried
/// \return `Solved`; `Infeasible` if no set fits and there is a proof that passes verify_farkas(); otherwise `Breakdown`
/// \throws std::invalid_argument if there are more than 12 pairs, or as check_finite()
[[nodiscard]] ContactState enumerate(const ContactProblem& problem,
                                     const SolverOptions& options = {});

}  // namespace signorini
