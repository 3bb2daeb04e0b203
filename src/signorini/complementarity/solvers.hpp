/// \file
/// The family of solvers. To add one: write `NAME.cpp` with a function of this signature, declare it in
/// `NAME.hpp` and add its line to the table in solvers.cpp; the conformance suite then runs it.
#pragma once
#include <string>
#include <vector>

#include "signorini/complementarity/problem.hpp"

namespace signorini {

/// One member of the family.
struct Solver {
  const char* name;
  const char* summary;  ///< one line for lists
  ContactState (*solve)(const ContactProblem& problem, const SolverOptions& options);
  Eigen::Index largest;  ///< most pairs it accepts; 0: no bound
};

/// All members, in the order of lists and tables.
[[nodiscard]] const std::vector<Solver>& solvers();

/// The member called `name`. \throws ProblemError listing the known names
[[nodiscard]] const Solver& find_solver(const std::string& name);

}  // namespace signorini
