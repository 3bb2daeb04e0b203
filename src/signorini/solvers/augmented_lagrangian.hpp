/// \file
/// The augmented Lagrangian method for the balance along rigid modes.
#pragma once
#include <functional>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// Solves a problem without rigid modes and friction.
using HeldSolver = std::function<ContactState(const ContactProblem&)>;

/// Solves a problem with rigid modes by a method for held bodies.
///
/// Springs on the modes, of compliance rho and anchored at a, turn it into a contact problem with
/// \f$ G + \rho R P R^T \f$ and \f$ d + R (a - \rho P r) \f$. Its forces and the new amplitude
/// \f$ a + \rho P (R^T\lambda - r) \f$ satisfy every condition but one: the springs still carry
/// \f$ R^T\lambda - r \f$. So the anchor is moved there, and again: the method of multipliers, an augmented Lagrangian
/// [\ref Rockafellar1976], akin to the minimum that Xuan and Li move. As soon as a new set of closed
/// pairs W appears,
///
/// \f[ \begin{pmatrix} G_{WW} & R_W \\ R_W^T & 0 \end{pmatrix}
///     \begin{pmatrix} \lambda_W \\ a \end{pmatrix} =
///     \begin{pmatrix} -d_W \\ r \end{pmatrix} \f]
///
/// is solved and refined; if all signs are right beyond rounding, that is the solution, and no spring
/// is left in it. Nothing is to be tuned: on equilibrated data \f$ P = (R^T R)^{-1} \f$ and rho is the
/// trace of G, twice as much after each pass that did not halve the spring forces. The first anchor is
/// where the body meets the first obstacle when it follows its load.
/// \param problem     with rigid modes, without friction
/// \param solve_held  for the problems with springs
/// \return `Solved`; what `solve_held` says where it does not solve, with the vector y of ContactState if gaps contradict
///   each other; `IterationLimit` after 100 passes; `Breakdown` where it has a feasible state only, of which springs still
///   carry a part. If fewer pairs close than there are modes, the amplitude is one of many
/// \throws std::invalid_argument as check_problem() and `solve_held`
[[nodiscard]] ContactState augmented_lagrangian(const ContactProblem& problem,
                                                const HeldSolver& solve_held);

}  // namespace signorini
