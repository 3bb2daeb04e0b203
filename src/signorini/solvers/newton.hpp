/// \file
/// Newton's method for contact equations, with a line search and an exact end.
#pragma once
#include "signorini/problem/contact_equations.hpp"
#include "signorini/solvers/iterate.hpp"

namespace signorini {

/// Takes Newton steps, each as far as \f$ \tfrac12|\Phi|^2 \f$ falls (Armijo's rule). If J is singular to working
/// precision, so that its step does not point downhill, the step follows the gradient \f$ J^T\Phi \f$, which
/// exists even where \f$ \Phi \f$ has kinks [\ref DeLucaFacchineiKanzow1996].
///
/// Newton's method ends near a solution, not on it: as soon as two iterates agree on what the pairs do,
/// solve_active_set() solves the equations of these statuses, and of those which that solution asks for, and the result is
/// kept if it is a solution.
/// \param problem  scaled
/// \param form     of the law of friction
/// \param limit    on the iterations in `iterate.report`
/// \param[in,out] iterate  where to start, and where it ended
void follow_newton(const ScaledProblem& problem, const Formulation& form, Eigen::Index limit,
                   Iterate& iterate);

/// Newton steps with friction if the caller sets no limit.
inline constexpr Eigen::Index newton_limit = 25;

}  // namespace signorini
