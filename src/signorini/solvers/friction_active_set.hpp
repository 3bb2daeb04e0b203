/// \file
/// Friction by exchanging what the pairs do: the active set method with four motions instead of two.
#pragma once
#include "signorini/problem/friction.hpp"
#include "signorini/solvers/friction_descent.hpp"

namespace signorini {

/// Solves a friction problem by exchanging the motions of all wrong pairs at once.
///
/// Take what each pair does as known, open, sticking, or sliding one way or the other, and solve the linear
/// equations of these motions exactly. From the result, a pair opens if its force is tensile, closes
/// if it overlaps, starts to slide if its friction force exceeds the bound, and stops if it slides along with
/// its friction force; and again. This is Newton's method for the conditions written with projections,
/// [\ref AlartCurnier1991], as primal_dual_active_set() is without friction. It arrives in few steps, five to
/// ten for hundreds of pairs, or runs in circles. In that case friction_newton() starts anew from
/// the forces without friction, and friction_lemke() ends it.
///
/// \param problem  F positive semidefinite, d, s, mu, c, R, r
/// \param options  `iteration_limit` 0 stands for 50 exchanges; with a limit nothing follows them
/// \return `Solved`; `Infeasible` with `escape` if no forces balance r; else what friction_lemke() said,
///   or with a limit `IterationLimit`. `uniqueness` is that of uniqueness()
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] FrictionState friction_active_set(const FrictionProblem& problem,
                                                const SolverOptions& options = {});

/// Exchanges of friction_active_set() if the caller sets no limit.
inline constexpr Eigen::Index exchange_limit = 50;

/// The exchanges alone, on a scaled problem.
/// \param problem  scaled by equilibrate()
/// \param limit    on the exchanges
/// \param[in,out] point  where to start, and where it ended; `closure.confirmed` if at a solution
void exchange_motions(const ScaledFriction& problem, Eigen::Index limit, FrictionPoint& point);

}  // namespace signorini
