/// \file
/// Semismooth Newton method for the Fischer-Burmeister equations of contact.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Solves a contact problem, or any linear complementarity problem, as a system of equations.
///
/// One equation per pair says that pair is open or closed: \PaperEq{LinEtAl, 28}
/// \f[ \Phi_i(\lambda) = \varphi(gap_i, \lambda_i) = 0,\qquad gap = d + G\lambda, \f]
/// with fischer_burmeister(). Its Newton step from \f$ J = D_a G + D_b \f$, the diagonal matrices of
/// the two slopes, is taken as far as \f$ \tfrac12|\Phi|^2 \f$ falls (Armijo's rule). If J is singular
/// to working precision, so that its step does not point downhill, the step follows the gradient
/// \f$ J^T\Phi \f$, which exists even where \f$ \Phi \f$ has kinks [\ref DeLucaFacchineiKanzow1996]. For a
/// positive definite G every point where the gradient vanishes is the solution; for other matrices
/// it need not be, and the method says so.
///
/// All is done on the equilibrated problem, where gap and force have one unit: with a length against a
/// force the steps would depend on the choice of units. There, a force counts as the gap that such
/// forces on all pairs make: phi(gap, force_scale * lambda) with the largest row sum of |G| as force_scale. Without
/// that factor the steps grow with the number of pairs, for a beam of 200 pairs from 15 to 55.
///
/// Newton's method ends near the solution, not on it: as soon as two iterates agree on which pairs
/// are closed, that set is solved exactly, and the result is kept if all signs are right beyond
/// rounding.
///
/// With friction there is one more equation per slip, see nested_friction; no pair of unknowns u+ and u- as in
/// friction_split() is needed. With rigid modes it starts from the least forces that balance the load, for one mode of
/// equal pairs the equal share of each, and from the amplitudes of least gaps; see ContactEquations.
///
/// \param problem  any; without friction and rigid modes F may be any square matrix
/// \param options  `iteration_limit` 0 stands for 10 n_c + 100 steps, with friction for 25
/// \return `Solved`; `Breakdown` if \f$ |\Phi| \f$ falls no
///   more at a point that is no solution, as happens if nothing solves the problem; `IterationLimit`.
///   `report.history` holds \f$ |\Phi| \f$ relative to its first value as `residual`
/// \throws std::invalid_argument as check_finite(), with rigid modes as check_problem()
[[nodiscard]] ContactState fischer_burmeister(const ContactProblem& problem,
                                              const SolverOptions& options = {});

/// \return the member of the family, with primal_dual_active_set() and lemke() to ask after it
[[nodiscard]] Solver fischer_burmeister();

}  // namespace signorini
