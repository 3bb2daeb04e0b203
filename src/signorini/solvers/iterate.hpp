// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Where the methods for all kinds of contact start, and how they end.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/problem/active_set_system.hpp"

namespace signorini {

/// Where a method stands: the numbers, what they say of each pair, and the report so far.
struct Iterate {
  ActiveSetSolution solution;           ///< the end if `confirmed`, else the last iterate
  std::vector<ContactStatus> statuses;  ///< `n_c`
  Report report;                        ///< its status is set at the end
  std::string reason = {};              ///< why the method stopped, if it did
  bool confirmed = false;               ///< whether it solves the problem

  /// Says how a method ends here. \param status  of the run \param why  in words; null: as before
  void stop(SolveStatus status, const char* why = nullptr);
};

/// What statuses say is closed, the surest first. Of rows that repeat each other a system keeps the first.
/// \param problem   scaled
/// \param statuses  `n_c`
/// \param doubt     `n_c` or more: the pair with the least is the surest; with friction they stay in order
/// \return the set
[[nodiscard]] ActiveSet surest_first(const ScaledProblem& problem,
                                     const std::vector<ContactStatus>& statuses,
                                     const Eigen::VectorXd& doubt);

/// The point from which all methods start, and what it says of the pairs: no forces; with friction forces
/// without friction, unless F has few entries, where these cost more than they are good for; for bodies with rigid
/// modes the least forces that balance r, and the amplitudes of least gaps.
/// \param problem  scaled
/// \return the point
[[nodiscard]] Iterate first_iterate(const ScaledProblem& problem);

/// Where to start from. Of many overlapping pairs most will open.
///
/// Where 64 pairs or more overlap, every second one of them is solved alone by primal_dual_iterations(), from those of
/// these again, until few are left; closed at the start are then the pairs between closed ones. It saves most of
/// the steps, and those that it costs are on smaller problems.
/// \param problem  scaled; with friction or rigid modes the start is first_iterate()
/// \return the start; its report counts the factorisations
[[nodiscard]] Iterate coarse_iterate(const ScaledProblem& problem);

/// Where to start from if a problem like this one is solved: no forces, and what its pairs do.
/// \param problem   scaled
/// \param statuses  `n_c`
/// \return the start
[[nodiscard]] Iterate iterate_from(const ScaledProblem& problem,
                                   const std::vector<ContactStatus>& statuses);

/// Solves the equations of the statuses of an iterate, and of those which that solution asks for, and keeps the result if it is a
/// solution. Without friction, pairs that end without a force are open then.
/// \param problem      scaled
/// \param force_scale  forces count so many times against gaps
/// \param[in,out] iterate  numbers and what they say of the pairs; `confirmed` with the solution, else only counts change
/// \return whether it is one
[[nodiscard]] bool ends_exactly(const ScaledProblem& problem, double force_scale, Iterate& iterate);

/// The state where a method ended.
/// \param problem  as it was posed
/// \param scaled   the same, equilibrated
/// \param iterate  the end
/// \return the state, `Solved` if the end was confirmed
[[nodiscard]] ContactState finished(const ContactProblem& problem, const ScaledProblem& scaled,
                                    Iterate iterate);

}  // namespace signorini
