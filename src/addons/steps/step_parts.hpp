// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What steps of bodies that stay and of bodies that move have in common.
#pragma once
#include "addons/steps/steps.hpp"
#include "signorini/scene/step_loop.hpp"

namespace signorini {

/// \param model     that a function is asked about \param function  its name
/// \throws ProblemError unless the model is of a scene with load steps
void check_steps(const Model& model, const char* function);

/// Whether the numbers of a state are those of a model.
/// \param state  of a path \param model  with its pairs
/// \throws ProblemError if they are too many, too few, or not finite
void check_sizes(const PathState& state, const Model& model);

/// Lets the slips of a model count from where they were.
/// \param slip  `n_s` [length] \param[in,out] model  with g
void forget_slip(const Eigen::VectorXd& slip, Model& model);

/// u without contact forces at the time that a model was set to.
/// \param time   that time [time] \param model  with parts \param path  of it
/// \return `n` [length]
[[nodiscard]] Eigen::VectorXd free_displacement(double time, const Model& model,
                                                const CondensedPath& path);

/// \param past      the state before a step
/// \param time      of the step [time]
/// \param model     with its pairs
/// \param given     slips in total if no unknown moves
/// \param solution  of the step
/// \return the state after it
[[nodiscard]] PathState after(const PathState& past, double time, const Model& model,
                              const Eigen::VectorXd& given, const Solution& solution);

/// Whether u and forces of a model are linear in its loads until a pair changes, in numbers that one programme has: bodies stay, supports
/// hold them, and no bond joins them. \param model  any \return whether
[[nodiscard]] bool is_linear(const Model& model);

/// How far loads go on as in the last step.
/// \param past   the state before a step \param time  of the step [time] \param model  with parts
/// \return change of their factors in this step over that in the last one, along the last one; 0 if loads turn
[[nodiscard]] double share_gone_on(const PathState& past, double time, const Model& model);

/// Where a step ends if no pair changes: on the line through the last two.
/// \param past   the state before the step \param time  of the step [time] \param model  with parts
/// \return u in two parts and forces; nothing if loads do not go on in one proportion, the model is not linear, or the way of the
///   last step is not known
[[nodiscard]] std::optional<PrimalDual> extrapolated(const PathState& past, double time,
                                                     const Model& model);

/// The way of a step. \param from, to  solutions before and after it \return their difference; empty unless both are in two parts
[[nodiscard]] PrimalDual way_between(const PrimalDual& from, const PrimalDual& to);

/// A step of bodies that move: its pairs come and go, and take along what they know.
/// \param past    where the path is
/// \param time    of the step, beyond that [time]
/// \param model   gets the loads of that time, and stands where the step ends
/// \param path    of it
/// \param ledger  goes on in the solution
/// \return as step()
[[nodiscard]] Step moved_step(const PathState& past, double time, Model& model,
                              CondensedPath& path, Ledger ledger);

}  // namespace signorini
