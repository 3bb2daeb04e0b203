/// \file
/// The portfolio between two proofs: that nothing solves a problem, and that nothing else does.
#pragma once
#include "signorini/problem/scaled.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Solves a problem of any kind as the solve() of the portfolio does, and says what can be proved about it.
///
/// Before any method is asked, infeasible_resultant() looks for a proof that no contact forces balance the load. Where the
/// member names others, at_rest() is asked before them, and with friction soft_pairs() before the last. A matrix of any kind that no member solved is
/// refuted by farkas_certificate() where that can be; a solution with friction comes with its uniqueness().
/// \param problem  any
/// \param solver   a member
/// \param options  handed to it
/// \param[in,out] scaled  the problem, equilibrated: gets the system of the last set; null: nobody has it
/// \return as solve(); `Infeasible` with `unbounded_direction` or `farkas_certificate`
/// \throws ProblemError, std::invalid_argument as solve()
[[nodiscard]] ContactState solve_with_proofs(const ContactProblem& problem, const Solver& solver,
                                             SolverOptions options = {},
                                             ScaledProblem* scaled = nullptr);

}  // namespace signorini
