// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What the methods for all kinds of contact share: where they start, Newton's steps, and the exact end.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/problem/contact_equations.hpp"

namespace signorini {

/// Where a method stands: the numbers, what they say of each pair, and the report so far.
struct Iterate {
  ActiveSetSolution solution;           ///< the end if `confirmed`, else the last iterate
  std::vector<ContactStatus> statuses;  ///< `n_c`
  Report report;                        ///< its status is set at the end
  std::string reason = {};              ///< why the method stopped, if it did
  bool confirmed = false;               ///< whether it solves the problem
};

/// The point from which all methods start, and what it says of the pairs: no forces; with friction forces
/// without friction, unless F has few entries, where these cost more than they are good for; for bodies with rigid
/// modes the least forces that balance r, and the amplitudes of least gaps.
/// \param problem  scaled
/// \return the point
[[nodiscard]] Iterate first_iterate(const ScaledProblem& problem);

/// The state where a method ended.
/// \param problem  as it was posed
/// \param scaled   the same, equilibrated
/// \param iterate  the end
/// \return the state, `Solved` if the end was confirmed; with friction with its uniqueness()
[[nodiscard]] ContactState finished(const ContactProblem& problem, const ScaledProblem& scaled,
                                    Iterate iterate);

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

/// Exchanges the statuses of all wrong pairs at once: takes what each pair does as known, open, sticking, or
/// sliding one way or the other, and solves the linear equations of these statuses exactly. From the result, a
/// pair opens if its force is tensile, closes if it overlaps, starts to slide if its friction force exceeds the
/// bound, and stops if it slides along with its friction force; and again.
///
/// If a set comes back, only the first wrong pair changes from then on where bodies are held and no pair has friction
/// [\ref Murty1974]; else the method stops. Of pairs that depend on each other, those that overlapped most
/// stay closed.
/// \param problem  scaled
/// \param limit    on the exchanges
/// \param[in,out] iterate  where to start, and where it ended
void primal_dual_iterations(const ScaledProblem& problem, Eigen::Index limit, Iterate& iterate);

/// Exchanges with friction if the caller sets no limit.
inline constexpr Eigen::Index exchange_limit = 50;

/// Finds out what frictional pairs do by making them soft: each gets a compliance of its own in the way of every
/// force, which counts from the forces of the solution before [\ref Rockafellar1976b]. Soft pairs settle in a few
/// exchanges, one that starts from their statuses hardly has to change any, and with them the compliance becomes 0: it
/// is halved where primal_dual_iterations() settles, and four times as large where it does not. Where soft pairs no longer
/// change, primal_dual_iterations() may end it.
/// \param problem  scaled
/// \param[in,out] iterate  where to start; its report is continued, the rest is kept unless this is the end
void follow_soft_pairs(const ScaledProblem& problem, Iterate& iterate);

/// Follows Lemke's path through all kinds of contact, see lemke().
/// \param problem  scaled
/// \param options  of each path
/// \param[in,out] iterate  its report is continued
void follow_pivots(const ScaledProblem& problem, const SolverOptions& options, Iterate& iterate);

}  // namespace signorini
