/// \file
/// The family of solvers. To add one: write `NAME.cpp` with a function of this signature, declare
/// it in `NAME.hpp` and add its line to the table in solvers.cpp; the conformance suite finds it.
#pragma once
#include <string>
#include <vector>

#include "signorini/complementarity/problem.hpp"

namespace signorini {

/// One member of the family.
struct Solver {
  const char* name;     ///< as in find_solver() and in a scene
  const char* summary;  ///< one line for lists
  /// Solves a problem. It may claim `Solved` only if all conditions hold to rounding, and throws
  /// std::invalid_argument as check_problem() or for more than `largest` pairs.
  ContactState (*solve)(const ContactProblem& problem, const SolverOptions& options);
  Eigen::Index largest;  ///< most pairs it accepts; 0: no bound
};

/// The family.
/// \return all members, in the order of lists and tables
[[nodiscard]] const std::vector<Solver>& solvers();

/// Looks up a member.
/// \param name  of the solver
/// \return the member
/// \throws ProblemError listing the known names if there is none
[[nodiscard]] const Solver& find_solver(const std::string& name);

}  // namespace signorini
