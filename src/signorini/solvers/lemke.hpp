/// \file
/// Lemke's complementary pivoting.
#pragma once
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Solves w = M z + q, w, z >= 0, w^T z = 0 by complementary pivoting [\ref Lemke1965].
///
/// An artificial force z_0 opens all gaps at once: w = M z + c z_0 + q with the covering vector c > 0.
/// From there on the partner of the variable that has just left the basis enters it, until z_0 leaves.
/// Ties are broken by the lexicographic rule, as if q were perturbed by different powers of a tiny
/// number [\ref CottlePangStone1992], so that no basis comes back. The forces of the last basis are
/// then found anew from the data.
///
/// If G is symmetric and positive semidefinite, the method ends with a solution or with a ray that
/// proves that there is none. In both cases it can pass 2^n bases [\ref Fathi1979]; which problems
/// take so long depends on c.
///
/// \param problem   G and d, or any M and q
/// \param covering  c `n_c` > 0 [length], as q
/// \param options   `iteration_limit` 0 stands for 2^min(n_c, 20) + 100 n_c pivots
/// \return `Solved`; `Infeasible` with the proof, read off a ray; `Ray` if the ray proves nothing, as
///   for a matrix that is no compliance; `IterationLimit`; `Breakdown` if rounding spoiled the last
///   basis. `iterations` counts pivots, the one that brings z_0 in is the first
/// \throws std::invalid_argument unless c has one positive, finite entry per pair, or as check_finite()
[[nodiscard]] ContactState lemke(const ContactProblem& problem, const Eigen::VectorXd& covering,
                                 const SolverOptions& options = {});

/// The same, with ones as covering vector of the equilibrated problem: neither units nor the scale of
/// a row change a pivot.
///
/// A path that grows too long is left for one with another covering vector, as which problems take 2^n pivots
/// depends on it: the first may take n_c^2 + 100 n_c pivots, each later one twice as many as the one before. The
/// vectors are always the same, entries between 1 and 2.
/// \param problem  G and d, or any M and q
/// \param options  as above, for all paths together
/// \return as above; `iterations` counts the pivots of all paths
/// \throws std::invalid_argument as check_finite()
[[nodiscard]] ContactState lemke(const ContactProblem& problem, const SolverOptions& options = {});

}  // namespace signorini
