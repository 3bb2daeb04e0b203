/// \file
/// What a solver is. To add one: write `NAME.cpp` with a function of this signature, declare
/// it in `NAME.hpp` and add its line to the table in papers/solver_table.cpp; the conformance suite finds it.
/// A member that is the default of something, or that another one asks, is returned by a function of its name in members.cpp.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// What can be hard about a problem.
enum class Trait {
  Ordinary,        ///< none of these, but many pairs that act on each other in any way
  Asymmetric,      ///< the matrix is not symmetric: no contact, but a complementarity problem
  Dependent,       ///< gap rows that repeat or contradict each other: G is singular
  Infeasible,      ///< nothing satisfies all conditions, because gap rows contradict each other
  Degenerate,      ///< pairs that touch without force, or of which only the sum of forces is known
  IllConditioned,  ///< nearly dependent rows, a condition of G above about 1e7
  Slow,            ///< built to make a method take a very long way
  Several,         ///< more than one pair closes
  Friction         ///< pairs have friction
};

/// \param trait  any
/// \return "ordinary", "asymmetric", "dependent", "infeasible", "degenerate", "ill-conditioned",
///   "slow", "several pairs" or "friction"
[[nodiscard]] const char* to_string(Trait trait);

/// Whether a solver takes an effect.
enum class Takes {
  No,    ///< it throws std::invalid_argument
  Also,  ///< with or without it
  Only   ///< it is made for nothing else
};

/// One member of the family. What most members have is the default; the functions below give the others a name.
struct Solver {
  const char* name;     ///< as in find_solver() and in scene files
  const char* summary;  ///< one line for lists
  /// Solves a problem. It may claim `Solved` only if all conditions hold to rounding, and throws
  /// std::invalid_argument as check_problem(), for what it does not take or for more than `largest` pairs.
  ContactState (*solve)(const ContactProblem& problem, const SolverOptions& options);
  Eigen::Index largest = 0;  ///< most pairs it accepts; 0: no bound
  /// Traits of problems on which it may end without a solution, and then says so. One that lists
  /// Asymmetric throws for such a matrix where no pair has friction.
  std::vector<Trait> may_fail = {};
  Takes friction = Takes::No;  ///< whether it takes slips
  /// Whether it takes rigid modes itself, or needs the springs of solve()
  bool rigid_modes = false;
  /// Return the members that certified_solve() asks one by one where this one breaks down: rounding that leads one
  /// method astray mostly does not meet the other
  std::vector<Solver (*)()> others = {};

  /// \param traits  on which it may fail \return the member with them
  Solver& may_fail_on(std::vector<Trait> traits) {
    may_fail = std::move(traits);
    return *this;
  }
  /// \param takes  whether it takes slips \return the member with it
  Solver& with_friction(Takes takes) {
    friction = takes;
    return *this;
  }
  /// \return the member, taking rigid modes
  Solver& with_rigid_modes() {
    rigid_modes = true;
    return *this;
  }
  /// \param members  functions that return those to ask after it \return the member with them
  Solver& before(std::vector<Solver (*)()> members) {
    others = std::move(members);
    return *this;
  }
};

/// Whether a member says that it may fail on a trait.
/// \param solver  a member
/// \param trait   of a problem
/// \return whether its table line lists it
[[nodiscard]] bool may_fail(const Solver& solver, Trait trait);

/// \param solver  a member
/// \param pairs   of a problem
/// \return why it does not take so many, or nothing if it does
[[nodiscard]] std::string too_many(const Solver& solver, Eigen::Index pairs);

/// Whether a problem is of a kind that a member takes; rigid modes apart, which `rigid_modes` tells.
/// \param solver   a member
/// \param problem  any
/// \return whether it takes so many pairs, friction if there is any, and a matrix like this one
[[nodiscard]] bool takes(const Solver& solver, const ContactProblem& problem);

}  // namespace signorini
