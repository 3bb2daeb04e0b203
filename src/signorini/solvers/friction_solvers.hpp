/// \file
/// The methods for friction as a table, for lists and comparisons.
#pragma once
#include <string>
#include <vector>

#include "signorini/problem/friction.hpp"

namespace signorini {

/// A method for one load step with friction.
struct FrictionSolver {
  const char* name;     ///< as in find_friction_solver() and in a scene
  const char* summary;  ///< one line for lists
  /// Solves a problem. It may claim `Solved` only if the certificate holds, and throws
  /// std::invalid_argument as check_problem().
  FrictionState (*solve)(const FrictionProblem& problem, const SolverOptions& options);
  bool may_fail = false;  ///< whether it ends without a solution on ordinary problems, and says so
};

/// All methods, the one to use first.
/// \return the table
[[nodiscard]] const std::vector<FrictionSolver>& friction_solvers();

/// Looks up a method.
/// \param name  of the method
/// \return the method
/// \throws ProblemError listing the known names if there is none
[[nodiscard]] const FrictionSolver& find_friction_solver(const std::string& name);

}  // namespace signorini
