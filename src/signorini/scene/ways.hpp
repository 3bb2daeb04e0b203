/// \file
/// How a condensed model is solved: the way of the library, and the place where an add-on puts its own.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "signorini/scene/solution.hpp"
#include "signorini/solvers/refined_solve.hpp"

namespace signorini {

/// The signature of solve() of a condensed model.
using SolveCondensed = Solution (*)(const Model& model, const Condensed& condensed,
                                    const Solver& solver, Ledger ledger,
                                    const SolverOptions& options);

/// The way of the library: refined_solve(), and what readers want of its end.
/// \param model      from build()
/// \param condensed  from condense() of it
/// \param solver     a member of its family that takes friction where pairs have friction
/// \param ledger     goes on in the solution, with the phases `contact`, `refinement`, `recovery`
/// \param options    handed to the solver
/// \return the solution
/// \throws as solve()
[[nodiscard]] Solution solve_plainly(const Model& model, const Condensed& condensed,
                                     const Solver& solver, Ledger ledger,
                                     const SolverOptions& options);

/// Whether a way makes what it needs of the compliance itself. \param model  from build() \param factor  of its K
/// \return whether condense_as_needed() may leave the compliance out for it
using LeavesCompliance = bool (*)(const Model& model, const Factor& factor);

/// Puts another way in the place of solve_plainly(), for all that solve() is asked from now on. A program does so at its
/// beginning. \param another  the way of an add-on \param leaves  of which models it makes the compliance; null: of none
void set_solve(SolveCondensed another, LeavesCompliance leaves = nullptr);

/// \param model  from build() \param factor  of its K \return what the way that is set says
[[nodiscard]] bool leaves_compliance(const Model& model, const Factor& factor);

/// condense() for who hands the result to solve() and looks at no compliance: it is left out where the way that is set makes
/// what it needs of it. \param model  from build() \param ledger  receives the phases `factor` and `condensation`
/// \return the small problem; `compliance` has no rows where it was left out
/// \throws ProblemError as condense()
[[nodiscard]] Condensed condense_as_needed(const Model& model, Ledger& ledger);

/// \param condensed  from condense() or condense_as_needed()
/// \return whether it has its compliance
[[nodiscard]] bool is_complete(const Condensed& condensed);

/// Makes the compliance that was left out.
/// \param model      that was condensed
/// \param condensed  from condense_as_needed()
/// \param ledger     receives more of the phase `condensation`
/// \return what condense() would have returned
[[nodiscard]] Condensed completed(const Model& model, Condensed condensed, Ledger& ledger);

/// A way that asks another one, several times if need be.
using SolveAround = Solution (*)(SolveCondensed way, const Model& model, const Condensed& condensed,
                                 const Solver& solver, Ledger ledger,
                                 const SolverOptions& options);

/// Puts a way around that of set_solve(), for models with equations. A program does so at its beginning.
/// \param another  the way of an add-on
void set_solve_around(SolveAround another);

/// \param condensed  from condense(); must outlive what is returned
/// \param ledger     counts the operations of every solve; must outlive it too
/// \return the condensed problem, and how to solve with K
[[nodiscard]] CondensedProgramme condensed_programme(const Condensed& condensed, Ledger& ledger);

/// Refuses numbers for which solvers blame their caller: here they are those of the scene.
/// \param problem  condensed
/// \throws ProblemError unless check_finite() takes it
void check_numbers(const ContactProblem& problem);

/// Runs a method, and lets check_numbers() say what it blames its caller for.
/// \param problem  condensed
/// \param method   without arguments
/// \return what it returns
template <typename Method>
auto in_these_units(const ContactProblem& problem, Method&& method) {
  try {
    return method();
  } catch (const std::invalid_argument&) {
    check_numbers(problem);
    throw;
  }
}

/// Makes of an end what readers want: pressures, displacements of the bodies, the balance of the certificate, and notes.
/// \param model      that was solved
/// \param condensed  from condense() of it
/// \param end        of it; without displacements only its state is taken over
/// \param notes      that are known so far
/// \param ledger     goes on in the solution, with the phase `recovery`, in which checks are asked
/// \return the solution
[[nodiscard]] Solution recovered(const Model& model, const Condensed& condensed, RefinedEnd end,
                                 std::vector<std::string> notes, Ledger ledger);

}  // namespace signorini
