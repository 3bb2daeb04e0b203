// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Goals as they are written on a command line, and the goal that is meant if none is.
#pragma once
#include <string>

#include "addons/estimate/goal.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// The goal that is meant if none is named, and why.
struct DefaultGoal {
  Goal goal;        ///< what is meant
  std::string why;  ///< in words; empty if there is nothing to say
};

/// The contact force, unless equilibrium says what it is, or there are several contacts or none: then the displacement
/// of the boundary that is loaded, or, if none is, of the first source.
/// \param scene  any \param plan  of it
/// \return the goal
/// \throws ProblemError if there is neither a contact nor a loaded boundary
[[nodiscard]] DefaultGoal default_goal(const Scene& scene, const Plan& plan);

/// Reads a goal: `force`, `peak` or `width`, each followed by `:CONTACT` if there are several contacts; or
/// `displacement:BODY.boundary.x`, or `.y`, of which the body may be left out if there is only one.
/// \param word  to be read
/// \param plan  of the scene: the middle of a peak or a width is where the gap is smallest before loading
/// \return the goal
/// \throws ProblemError saying what was expected
[[nodiscard]] Goal goal_in_words(const std::string& word, const Plan& plan);

}  // namespace signorini
