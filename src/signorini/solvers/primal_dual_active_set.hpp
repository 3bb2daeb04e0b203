/// \file
/// Primal-dual active set method with a safeguard that makes it finite.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Solves a contact problem by exchanging all wrong pairs at once.
///
/// Take the pairs that overlap as closed, compute the forces that close them exactly, release every
/// pair in tension, close every pair that now overlaps, and repeat
/// [\ref HintermuellerItoKunisch2002]. This is fast but can run in circles. When a set of closed
/// pairs comes back, only the wrong pair with the lowest number changes sides from then on, which
/// for a positive definite G ends after finitely many steps [\ref Murty1974]. A pair counts as
/// wrong only beyond the rounding errors of its own force or gap.
///
/// Where 64 pairs or more overlap at the start, the same method solves every second one of them alone, and those of
/// these again, until few are left. Closed at the start are then the pairs between closed ones. It saves most of
/// the steps, and those that it costs are on smaller problems.
///
/// Two things keep pairs that depend on each other from stopping it. Of a set with a singular block only
/// independent pairs are closed, those that overlapped most first. And where the exchange does not arrive
/// - single pairs change sides and meet a singular block, or 10 n_c + 10 sets were not enough, or rounding
/// hides the answer, or there is none - quasi_active_set() takes over from the start: its dual energy rises
/// at every step, so that it needs no regular block to end.
///
/// With friction a pair has four statuses instead of two, see primal_dual_iterations(): Newton's method for the
/// conditions written with projections [\ref AlartCurnier1991], which arrives in five to ten steps for hundreds
/// of pairs, or runs in circles. In that case frictional pairs are made soft, see follow_soft_pairs(); then Newton's
/// method of fischer_burmeister() starts anew, and the pivots of lemke() end it. With rigid modes the resultant is
/// kept, the first set are the pairs that would be nearer than the gap their share of the load makes, and the same
/// methods follow; then there is solve() with springs.
///
/// Where `options.start` says what the pairs of a similar problem do, the exchange begins there; if it does not arrive,
/// all is as without it.
///
/// \param problem  any, F positive semidefinite
/// \param options  `iteration_limit` for the exchange with all pairs and quasi_active_set() together; 0 stands for 10 n_c + 10
///   and what that takes, with friction for 50 exchanges, after which nothing else comes if there is a limit
/// \return `Solved` with forces and gaps >= 0; `Infeasible` with `unbounded_direction` if no forces balance r; otherwise what the
///   last method says. `iterations` and `history` are those of all methods, one behind the other, with all
///   pairs; `factorisations` has those of every second pair as well
/// \throws std::invalid_argument as check_problem(); where pairs have friction and there are no rigid modes, as check_finite(): F
///   need not be symmetric then
[[nodiscard]] ContactState primal_dual_active_set(const ContactProblem& problem,
                                                  const SolverOptions& options = {});

/// The default: with its fall-back it solves the same random condensed problems as `quasi_active_set`, 99.8 % of the
/// feasible ones, and on ordinary contact its own few steps are all it needs.
/// \return the member of the family, with fischer_burmeister() and lemke() to ask after it
[[nodiscard]] Solver primal_dual_active_set();

}  // namespace signorini
