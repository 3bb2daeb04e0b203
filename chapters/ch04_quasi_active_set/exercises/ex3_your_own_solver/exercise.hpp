/// \file
/// Exercise 4.3 - your own solver. Do not change this file.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace ex4_3 {

/// The line of the solver table for your method, as in src/papers/solver_table.cpp.
///
/// It may list the traits Asymmetric, Dependent, Infeasible and IllConditioned, and no other: a
/// positive definite G must be solved, however long it takes, and degenerate pairs as well. `solve`
/// throws as check_problem() says. The same problem gives the same bits; units change nothing but the
/// exponents; `SolverOptions::iteration_limit` is kept unless it is 0.
/// \return name, summary, solve and the traits it may fail on
[[nodiscard]] signorini::Solver my_solver();

}  // namespace ex4_3
