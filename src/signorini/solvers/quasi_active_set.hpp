/// \file
/// The quasi-active-set method with the safeguard that makes it finite and exact.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Solves a contact problem by letting whole groups of violated pairs join the closed ones.
///
/// The idea is the paper's: a group of the pairs that the present solution violates, the *quasi-active
/// set*, proposes what to close next, \PaperEq{XuanLi2002, 37}. Two things differ from its equations
/// (30)-(36). The objective is never moved: forces of earlier steps are kept, and may vanish again.
/// And a proposal counts only if the dual energy rises, as in a dual active-set method
/// [\ref GoldfarbIdnani1983]. Each step
///  1. projects the most violated pairs off the closed ones and lets those join that raise the dual
///     energy most, skipping pairs that depend on others;
///  2. drops every pair in tension and solves again until none is left; if the energy has not risen,
///     goes back and moves from the old forces towards the new ones until the first vanishes, opens
///     its pair, and goes on so until none pulls;
///  3. if all violated pairs depend on the closed ones, presses the most violated one while the
///     others yield: the first force that vanishes leaves, and if none does, nothing solves the
///     problem and the response proves it.
/// Every step ends with forces that are the best for their set of pairs, each better than the one
/// before. There are finitely many sets, so the method ends, for any positive semidefinite G.
///
/// Rows that repeat others but for less than the root of what rounding does to G can only change places with
/// them: where the energy does not rise, pairs that joined or left, and a pair whose proof does not hold, are
/// passed over until it does. The certificate of the end says whether their overlap was rounding.
///
/// \param problem  G positive semidefinite, and d
/// \param options  `iteration_limit` 0 stands for 10 n_c + 100
/// \return `Solved`, `Infeasible` with `farkas_certificate`, `IterationLimit`, or `Breakdown` if rounding
///   leaves no way on
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ContactState quasi_active_set(const ContactProblem& problem,
                                            const SolverOptions& options = {});

/// \return the member of the family
[[nodiscard]] Solver quasi_active_set();

}  // namespace signorini
