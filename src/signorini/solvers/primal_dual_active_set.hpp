/// \file
/// The primal-dual active set method, which is a semi-smooth Newton method.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

struct Iterate;
struct ScaledProblem;

/// Solves a contact problem by exchanging all wrong pairs at once.
///
/// Take the pairs that overlap as closed, compute the forces that close them exactly, release every
/// pair in tension, close every pair that now overlaps, and repeat
/// [\ref HintermuellerItoKunisch2002]. This is fast but can run in circles. When a set of closed
/// pairs comes back, only the wrong pair with the lowest number changes sides from then on, which
/// for a positive definite G ends after finitely many steps [\ref Murty1974]. A pair counts as
/// wrong only beyond the rounding errors of its own force or gap. Of pairs that depend on each other,
/// those that overlapped most are closed.
///
/// With friction a pair has four statuses instead of two: Newton's method for the conditions written with projections
/// [\ref AlartCurnier1991], which arrives in five to ten steps for hundreds of pairs, or runs in circles. With rigid
/// modes the resultant is kept, and the first set are the pairs that would be nearer than the gap their share of the
/// load makes.
///
/// Where `options.start` says what the pairs of a similar problem do, the exchange begins there, and if it does not arrive,
/// again from the start.
///
/// \param problem  any, F positive semidefinite
/// \param options  `iteration_limit` 0 stands for 10 n_c + 10 sets, with friction for 50
/// \return `Solved` with forces and gaps >= 0, `IterationLimit` or `Breakdown`. `iterations` are sets of all pairs;
///   `factorisations` has those of coarse_iterate() as well
/// \throws std::invalid_argument as check_problem(); where pairs have friction and there are no rigid modes, as check_finite(): F
///   need not be symmetric then
[[nodiscard]] ContactState primal_dual_active_set(const ContactProblem& problem,
                                                  const SolverOptions& options = {});

/// The default: on ordinary contact its own few steps are all that is needed.
/// \return the member of the family, with quasi_active_set(), fischer_burmeister() and lemke() to ask after it
[[nodiscard]] Solver primal_dual_active_set();

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

/// \param problem  scaled
/// \return how many sets are looked at if the caller sets no limit
[[nodiscard]] Eigen::Index most_exchanges(const ScaledProblem& problem);

}  // namespace signorini
