/// \file
/// Contact as a linear programme with restricted basis entry, at once or in increments of load.
#pragma once
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// Solves a contact problem with the simplex method.
///
/// Forces and gaps obey n_c linear equations, gap - G force = d, and are not negative: the
/// constraints of a linear programme. Where d_i < 0, an *artificial* gap takes up the overlap, and the
/// simplex method drives the sum of the artificial gaps to zero. What is not linear, force times gap = 0,
/// is left to a rule of the pivots, *restricted basis entry*: a force may join the basis only if the
/// gap of its pair is not in it, and the other way round. This is Wolfe's method for quadratic programmes
/// [\ref Wolfe1959]. The contact analysis with which Xuan and Li compare their examples uses, says its title, a
/// linear programme in increments [\ref SimunovicSaigal1995]; this member takes the whole load at once
/// and does not follow it.
///
/// Why the rule does not block the way: let no allowed pivot lower the sum, and let y be the prices of the
/// equations. A gap in the basis has y_i = 0, a force in the basis (G y)_i = 0, and a pair with
/// neither has y_i <= 0 <= (G y)_i. So y^T G y <= 0. For a positive definite G that leaves y = 0, and
/// with it no artificial gap. If G is only semidefinite, the rule can stall; where all prices are
/// <= 0 then, -y proves that nothing solves the problem.
///
/// One pair changes per pivot, so there are at least as many pivots as closed pairs. Of equal
/// ratios the lexicographic rule chooses the row, so no basis comes back. The last basis is solved
/// exactly by confirmed().
///
/// \param problem  G positive semidefinite, and d
/// \param options  `iteration_limit` on pivots, 0 stands for 100 n_c + 100
/// \return `Solved`; `Infeasible` with its proof; `Breakdown` if no allowed pivot is left and neither
///   is shown; `IterationLimit`. `report.history` holds the sum of the artificial gaps relative to
///   the first one as `residual`
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ContactState linear_programme(const ContactProblem& problem,
                                            const SolverOptions& options = {});

/// The same with the load applied in equal increments: the last basis of one starts the next.
///
/// The gaps without contact are affine in the load, \f$ d(t) = g + t (d - g) \f$ with t from 0 to 1.
/// After an increment, the basis holds the pairs that were closed; only those that it leaves in
/// tension or in overlap get artificial numbers, and the pivots follow the pairs as they close and
/// open along the way. Without friction the answer depends on the load alone and not on the way.
/// \param problem      G and d at the full load
/// \param initial_gap  g `n_c` [length]: the gaps without any load
/// \param increments   how many, at least 1
/// \param options      `iteration_limit` on the pivots of one increment, as in linear_programme()
/// \return one state per increment, each with the pivots of this increment only; the last one is at
///   the full load unless its status is not `Solved`
/// \throws std::invalid_argument as check_problem(), or if g has another size or there is no increment
[[nodiscard]] std::vector<ContactState> incremental_linear_programme(
    const ContactProblem& problem, const Eigen::VectorXd& initial_gap, Eigen::Index increments,
    const SolverOptions& options = {});

}  // namespace signorini
