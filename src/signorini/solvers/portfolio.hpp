/// \file
/// Any problem by any member of the family, and by others where it does not arrive.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Solves a problem of any kind: asks a member, then those that it names in `others`, until one solves it.
///
/// Each answer is a claim that certify() has confirmed on the data of the problem, so the order decides about time only, but
/// where a problem has several solutions. Members that do not take the problem are passed over. Where bodies have rigid modes
/// and no pair has friction, augmented_lagrangian() with the same member is the last one.
/// \param problem  any
/// \param solver   a member
/// \param options  handed to it; who limits the iterations of a member wants that member, and no other is asked
/// \return what the last one says, with the iterations and the history of all, one behind the other
/// \throws ProblemError if the member takes no friction and the problem has it
/// \throws std::invalid_argument as check_problem() and the solver
[[nodiscard]] ContactState solve(const ContactProblem& problem, const Solver& solver,
                                 const SolverOptions& options = {});

}  // namespace signorini
