/// \file
/// The family of solvers. To add one: write `NAME.cpp` with a function of this signature, declare
/// it in `NAME.hpp` and add its line to the table in as_printed/solver_table.cpp; the conformance suite finds it.
#pragma once
#include <string>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

struct DenseSolution;
struct FloatingProblem;
struct FloatingState;

/// What can be hard about a problem.
enum class Trait {
  Ordinary,        ///< none of these, but many pairs that act on each other in any way
  Asymmetric,      ///< the matrix is not symmetric: no contact, but a complementarity problem
  Dependent,       ///< gap rows that repeat or contradict each other: G is singular
  Infeasible,      ///< nothing satisfies all conditions, because gap rows contradict each other
  Degenerate,      ///< pairs that touch without force, or of which only the sum of forces is known
  IllConditioned,  ///< nearly dependent rows, a condition of G above about 1e7
  Slow,            ///< built to make a method take a very long way
  Several          ///< more than one pair closes
};

/// \param trait  any
/// \return "ordinary", "asymmetric", "dependent", "infeasible", "degenerate", "ill-conditioned",
///   "slow" or "several pairs"
[[nodiscard]] const char* to_string(Trait trait);

/// One member of the family.
struct Solver {
  const char* name;     ///< as in find_solver() and in a scene
  const char* summary;  ///< one line for lists
  /// Solves a problem. It may claim `Solved` only if all conditions hold to rounding, and throws
  /// std::invalid_argument as check_problem() or for more than `largest` pairs.
  ContactState (*solve)(const ContactProblem& problem, const SolverOptions& options);
  Eigen::Index largest = 0;  ///< most pairs it accepts; 0: no bound
  /// Traits of problems on which it may end without a solution, and then says so. One that lists
  /// Asymmetric throws for such a matrix.
  std::vector<Trait> may_fail = {};
  /// The same for a problem whose G is left as a product, or null: then G is multiplied out.
  ContactState (*solve_half)(const HalfProblem& problem, const SolverOptions& options) = nullptr;
  /// The same from K, p, A and g to the refined end, or null: then the programme is condensed.
  DenseSolution (*solve_programme)(const DenseProgramme& programme,
                                   const SolverOptions& options) = nullptr;
  /// The same with rigid modes as unknowns, or null: then springs hold them. It may end without a
  /// solution and says so.
  FloatingState (*solve_floating)(const FloatingProblem& problem,
                                  const SolverOptions& options) = nullptr;
};

/// Whether a member says that it may fail on a trait.
/// \param solver  a member
/// \param trait   of a problem
/// \return whether its table line lists it
[[nodiscard]] bool may_fail(const Solver& solver, Trait trait);

/// The family. A scene that names no solver takes `primal_dual_active_set`: with its fall-back it solves the
/// same random condensed problems as `quasi_active_set`, 99.8 % of the feasible ones, and on ordinary contact
/// its own few steps are all it needs.
/// \return all members, in the order of lists and tables
[[nodiscard]] const std::vector<Solver>& solvers();

/// Looks up a member.
/// \param name  of the solver
/// \return the member
/// \throws ProblemError listing the known names if there is none
[[nodiscard]] const Solver& find_solver(const std::string& name);

}  // namespace signorini
