/// \file
/// Any problem by any member of the family: an augmented Lagrangian for the balance along rigid modes.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Solves a problem of any kind with a member of the family.
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
/// is left in it. A member that takes rigid modes first tries the whole problem at once, and the springs
/// come in where that fails, if no pair has friction. Nothing is to be tuned: on equilibrated data \f$ P = (R^T R)^{-1} \f$ and rho is the
/// trace of G, twice as much after each pass that did not halve the spring forces. The first anchor is
/// where the body meets the first obstacle when it follows its load.
///
/// Whether forces >= 0 can balance r at all is decided before, by the point of the cone of all
/// \f$ R^T\lambda \f$ that is closest to r: what is missing there is the unbounded direction.
/// \param problem  any
/// \param solver   a member
/// \param options  handed to it
/// \return what the member says; with rigid modes `Infeasible` with `unbounded_direction` if the load pulls the body away,
///   or with the vector y of ContactState if gaps contradict each other; `IterationLimit` after 100 passes; `Breakdown` where
///   the member has a feasible state only, of which springs still carry a part. If fewer
///   pairs close than there are modes, the amplitude is one of many
/// \throws ProblemError if the member takes no friction and the problem has it
/// \throws std::invalid_argument as check_problem() and the solver
[[nodiscard]] ContactState solve(const ContactProblem& problem, const Solver& solver,
                                 const SolverOptions& options = {});

}  // namespace signorini
