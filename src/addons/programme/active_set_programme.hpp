/// \file
/// The methods that grow an active set on a quadratic programme, condensed on demand.
#pragma once
#include "addons/programme/dense_programme.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace signorini {

/// quasi_active_set() for a quadratic programme, without forming G: only the columns of pairs that join are
/// ever condensed, gaps come from A and u. The end is refined from K, p, A and g in twice the working
/// precision and goes on if that shows another set; certificate and proof of infeasibility are left to solve().
///
/// \param programme  K, p, A, g
/// \param options    `iteration_limit` 0 stands for 10 m + 100
/// \return u, forces, gaps and status
/// \throws std::invalid_argument, ProblemError as condense()
[[nodiscard]] DenseSolution quasi_active_set(const DenseProgramme& programme,
                                             const SolverOptions& options = {});

/// goldfarb_idnani() for a quadratic programme, in the same way.
/// \param programme  K, p, A, g
/// \param options    `iteration_limit` 0 stands for 100 m + 100; `start` says which inequalities are closed at first
/// \return as above
/// \throws std::invalid_argument, ProblemError as condense()
[[nodiscard]] DenseSolution goldfarb_idnani(const DenseProgramme& programme,
                                            const SolverOptions& options = {});

/// A method for programmes.
using ProgrammeMethod = DenseSolution (*)(const DenseProgramme& programme,
                                          const SolverOptions& options);

/// How a member solves a programme without condensing it to the pairs first.
/// \param solver  a member
/// \return one of the two functions above for the members of their names; else null
[[nodiscard]] ProgrammeMethod on_programmes(const Solver& solver);

}  // namespace signorini
