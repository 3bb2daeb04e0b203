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

/// How far loads go on as in the last step: their changes, seen along those of that step.
/// \param past   the state before a step \param time  of the step [time] \param model  with parts
/// \return over these; 0 if loads turn
[[nodiscard]] double share_gone_on(const PathState& past, double time, const Model& model);

/// Where a step leads if its pairs do what they did last. Of one model u and forces are linear in the loads as long as they do.
/// \param past   the state before the step, with the way to it \param time  of the step [time] \param model  with parts
/// \return u in two parts and forces; nothing unless all loads go on in one proportion, and but for bodies that stay and that supports hold
[[nodiscard]] std::optional<PrimalDual> expected(const PathState& past, double time,
                                                 const Model& model);

/// The way of a step. \param from, to  solutions before and after it \return their difference; empty unless both are in two parts
[[nodiscard]] PrimalDual way(const PrimalDual& from, const PrimalDual& to);

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
