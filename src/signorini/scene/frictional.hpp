/// \file
/// The road from a condensed problem to a solution if there is friction.
#pragma once
#include <string>

#include "signorini/scene/solution.hpp"

namespace signorini {

/// The programme with the slips that friction resists.
/// \param model  from build(), with friction
/// \return K, p, A, g with `n_c` rows of slips, -T and the initial slips, after those of the gaps
[[nodiscard]] QuadraticProgramme with_slips(const Model& model);

/// Takes the slips out of a condensed problem that was made of gaps and slips.
/// \param friction           T and the law of `n_c` pairs
/// \param[in,out] condensed  with `2 n_c` rows; then those of the gaps, and all in `condensed.friction`
void set_friction_apart(const FrictionModel& friction, Condensed& condensed);

/// Solves the condensed problem with friction and recovers displacements.
///
/// Forces are corrected until the gaps, slips and nodal forces that the displacements give, from the
/// original data and in twice the working precision, are those of the condensed problem.
/// \param model      from build(), with friction
/// \param condensed  from condense() of it
/// \param solver     name in friction_solvers()
/// \param[in,out] ledger  receives the phases `contact`, `refinement` and `recovery`
/// \return as solve(), with `friction` whether it is solved or not, and a note if others may exist
/// \throws ProblemError for an unknown name
[[nodiscard]] Solution solve_frictional(const Model& model, const Condensed& condensed,
                                        const std::string& solver, Ledger& ledger);

/// Displacements of every body.
/// \param model         from build()
/// \param displacement  `n` unknowns [length]
/// \return `n_nodes x 2` of each body [length]
[[nodiscard]] std::vector<NodeArray> displacements_of_bodies(const Model& model,
                                                             const Eigen::VectorXd& displacement);

/// Says how bodies move along a direction that nothing stops.
/// \param model   with `n_r` rigid modes
/// \param escape  `n_r` amplitudes, or empty
/// \return the sentences of the modes that take part; empty if there are none
[[nodiscard]] std::string escape_in_words(const Model& model, const Eigen::VectorXd& escape);

}  // namespace signorini
