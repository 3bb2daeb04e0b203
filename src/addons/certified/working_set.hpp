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
/// Chapter 21 has the measure: m rows whose m^3 exceeds three times the operations of the factor cost more than the factor
/// does, if they are dense. With friction, where a pair has two rows and few are tried first, half of that is worth saving.
/// A compliance of less than 256 rows is half a megabyte, which stays in the cache of a processor:
/// leaving rows out of it saves nothing that could be measured. Rigid motions, equations, load steps and
/// bodies that move look at the compliance of all pairs: their proofs speak of it, or the next load does. So does cohesion: of pairs
/// that it may hold there is more than one solution, and which one is found should not depend on where a set begins.
/// \param plan        of the scene, or its model
/// \param rows        gaps and slips of the largest system, see largest_of(): those of two systems share no dense matrix
/// \param operations  of the factor of K
/// \return whether it is
[[nodiscard]] bool working_set_pays(const Plan& plan, Eigen::Index rows, double operations);

/// Solves a model whose compliance was left out. The set begins with the pairs that overlap or touch without contact forces.
/// Where these are many, it begins with a sample, every second, third, ... of them: a load may make all pairs overlap where few will
/// close. Pairs outside that do not stay open come in with neighbours, twice as many in every round, those of a sample that ended up
/// open leave, and it is solved again from where it stood. certified_solve() of the set gives forces and displacements; a sample and
/// sets with friction wait until nobody enters. The result is a claim for all pairs, with no force on the others, and the certificate
/// looks at all of it.
///
/// With friction there is one solution if a matrix of all pairs says so, see uniqueness(). Where that of the set does not, that of all
/// pairs would not, and nothing is lost. Where it does, or is in doubt, all pairs are condensed. Other solutions are looked for among the
/// pairs of the set alone.
/// \param model      from build(), see working_set_pays()
/// \param condensed  of it, without its compliance
/// \param solver     a member that takes such problems
/// \param options    handed to it
/// \param ledger     gets phases `condensation`, with the count `condensed pairs` of all rounds, `contact` and `refinement`
/// \return the end, if it is Solved and the certificate of all pairs holds. Nothing also where the cubes of the sizes of the sets
///   come to half of that of all pairs: what was tried in vain costs half of what is done then. With friction nothing where the set has a
///   proof, a doubt or no slips, and where the model falls into systems that nothing connects
[[nodiscard]] std::optional<CertifiedSolution> working_set_solution(const Model& model,
                                                                    const Condensed& condensed,
                                                                    const Solver& solver,
                                                                    const SolverOptions& options,
                                                                    Ledger& ledger);

/// The same of gaps that are others, neither refined nor certified: what pairs would do then. Of uniqueness it says nothing.
/// \param model      from build()
/// \param condensed  of it, without its compliance
/// \param opens      `n_c` by how much gaps are larger than in the model [length]
/// \param solver     a member that takes such problems
/// \param options    handed to it; the set begins with the pairs that its `start` closes
/// \return of all pairs; nothing where a round is not solved or the sets are too large
[[nodiscard]] std::optional<ContactState> working_set_state(const Model& model,
                                                            const Condensed& condensed,
                                                            const Eigen::VectorXd& opens,
                                                            const Solver& solver,
                                                            const SolverOptions& options);

}  // namespace signorini
