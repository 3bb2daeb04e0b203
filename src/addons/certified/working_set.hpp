// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Contact of many candidates of which few close: only pairs that may close are condensed.
#pragma once
#include <optional>

#include "addons/certified/certified_solve.hpp"
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Whether a working set is worth trying, by counts alone.
///
/// Chapter 21 has the measure: m pairs whose m^3 exceeds three times the operations of the factor cost more than the factor
/// does, if they are dense. A compliance of less than 256 rows is half a megabyte, which stays in the cache of a processor:
/// leaving rows out of it saves nothing that could be measured. Pairs with friction, rigid motions, equations, load steps and
/// bodies that move look at the compliance of all pairs: their proofs speak of it, or the next load does.
/// \param plan        of the scene, or its model
/// \param pairs       n_c of the largest system, see largest_of(): pairs of two systems share no dense matrix
/// \param operations  of the factor of K
/// \return whether it is
[[nodiscard]] bool working_set_pays(const Plan& plan, Eigen::Index pairs, double operations);

/// Solves a model whose compliance was left out. The set begins with the pairs that overlap or touch without contact forces;
/// of more than the factor pays for, with every second, third, ... of them: a load may make all pairs overlap where few will
/// close. What these do is not refined, as long as it says who else may close. certified_solve() of the set alone gives forces
/// and displacements. Pairs outside that do not stay open there come in
/// with neighbours, twice as many in every round, and it is solved again from where it stood. What the last set
/// found is then a claim for all pairs, with no force on the others, and the certificate looks at all of it.
/// \param model      from build(), see working_set_pays()
/// \param condensed  of it, without its compliance
/// \param solver     a member that takes such problems
/// \param options    handed to it
/// \param ledger     gets phases `condensation`, with the count `condensed pairs` of all rounds, `contact` and `refinement`
/// \return the end, if it is Solved and the certificate of all pairs holds; nothing also where the cubes of the sizes of the sets
///   come to half of that of all pairs: what was tried in vain costs half of what is done then
[[nodiscard]] std::optional<CertifiedSolution> working_set_solution(const Model& model,
                                                                    const Condensed& condensed,
                                                                    const Solver& solver,
                                                                    const SolverOptions& options,
                                                                    Ledger& ledger);

}  // namespace signorini
