/// \file
/// The family of solvers, and how to find one by its name.
#pragma once
#include <string>
#include <vector>

#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// The whole family: a line each.
/// \return all members, in the order of lists and tables
[[nodiscard]] const std::vector<Solver>& all_solvers();

/// \return the members that take problems without friction
[[nodiscard]] const std::vector<Solver>& solvers();

/// \return the members that take friction, the one to use first
[[nodiscard]] const std::vector<Solver>& friction_solvers();

/// Looks up a member.
/// \param name  of the solver
/// \return the member
/// \throws ProblemError listing the known names if there is none
[[nodiscard]] const Solver& find_solver(const std::string& name);

}  // namespace signorini
