// Whether every step of bodies that move solves what is there where they stand.
#pragma once
#include "addons/steps/steps.hpp"
#include "support/checked_scene.hpp"

namespace signorini_test {

/// Checks a step by meshes that are moved here and paired anew: equilibrium with K and p of the scene as it is, with
/// energy_forces() in the place of K u of bodies that have a law; gaps and forces of the pairs there, friction within its
/// bound, and slips that are those of the rows there to first order: `sliding` has by how much friction acts along them.
/// \param scene   with load steps, whose bodies move
/// \param model   of the step, for the frictional pairs
/// \param before  of all nodes, x and y of each, at the end of the step before; empty: none [length]
/// \param step    solved
/// \return its errors
SceneErrors check_motion(const signorini::Scene& scene, const signorini::Model& model,
                         const Eigen::VectorXd& before, const signorini::Step& step);

}  // namespace signorini_test
