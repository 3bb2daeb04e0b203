/// \file
/// How far loads can go that were not solved.
#pragma once
#include <optional>

#include "addons/steps/steps.hpp"

namespace signorini {

/// Until when contact and friction can balance the loads of a step, by balanced_share(): these are linear between the
/// rows of histories.
/// \param begin    where the step begins [time]
/// \param end      where it ends, beyond `begin` [time]
/// \param model    from build() of a scene with load steps
/// \param problem  condensed, of which F, R and the law are looked at
/// \return the time [time]; nothing if no loads are refuted, or even those at a row where they begin
[[nodiscard]] std::optional<double> balanced_until(double begin, double end, const Model& model,
                                                   ContactProblem problem);

/// The share of a step that failed after which some pair can no longer do what it did last, with loads that grow in
/// proportion: one that sticks would slide, or one that is closed be pulled. Forces are linear in the loads until then.
/// \param past     where the step begins
/// \param problem  condensed, at its end
/// \return the share, from 0 to 1 [-]; nothing if no such change can be foreseen
[[nodiscard]] std::optional<double> first_change(const PathState& past,
                                                 const ContactProblem& problem);

/// Plans, builds, condenses and solves a scene as solve() does, and finds out how much of its loads it holds, see below.
/// \param scene  without load steps
/// \return the solution, with its limit if there is one
/// \throws ProblemError as solve()
[[nodiscard]] Solution solve_to_limit(const Scene& scene);

/// Solves a scene, and finds out how much of its loads one with friction holds, if it was not solved and no proof says
/// why: with the loads, temperatures and given displacements grown from nothing in proportion, also those of relations and rigid
/// sides, by solve_steps(). Gaps, interferences and bounds are there from the beginning. A scene that is solved costs nothing more.
/// \param scene      without load steps
/// \param model      from build() of it
/// \param condensed  from condense() of that
/// \param ledger     goes on in the solution
/// \return the solution, with its limit if there is one, or a note if the path reached the full load
[[nodiscard]] Solution solve_to_limit(const Scene& scene, const Model& model,
                                      const Condensed& condensed, Ledger ledger);

}  // namespace signorini
