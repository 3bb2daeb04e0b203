// Scenes of load steps for the tests.
#pragma once
#include <string>
#include <vector>

#include "addons/steps/steps.hpp"

namespace signorini_test {

/// Of the tip of the slider.
inline constexpr double slider_friction = 0.5;

/// One triangle, whose tip is pressed by 1 along x on a wall and pulled along y by `pull`: by symmetry its stiffness
/// is diagonal, so that the pressure on the wall is 1 whatever happens along it.
signorini::Scene slider(const signorini::History& pull, const std::vector<double>& times);

/// A slab on rough ground that bends: pressed until time 1, then dragged to and fro by its right side, to 0.01 times
/// `drag[k]` at time k + 2.
signorini::Scene slab(int steps_per_leg, const std::vector<double>& drag);

/// All steps of a path that needs no halving.
std::vector<signorini::Step> steps_of(const signorini::Scene& scene,
                                      const signorini::PathState& from = {});

/// A step that was taken twice from one state.
struct TakenTwice {
  signorini::PathState before;
  signorini::Step step;
  signorini::Step blind;  ///< without what the state knows of the last way
};

/// All steps of a path, each of them twice: all are solved, and their forces agree.
/// \param scene  with load steps \param part  of the largest force by which others may differ
std::vector<TakenTwice> steps_taken_twice(const signorini::Scene& scene, double part);

/// What write_state() writes.
std::string written(const signorini::PathState& state);

}  // namespace signorini_test
