// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The pairs of a model, found anew where its bodies have moved to.
#pragma once
#include "signorini/scene/scene.hpp"
#include "signorini/scene/step_loop.hpp"

namespace signorini {

/// Finds the pairs of a model where its bodies stand, and writes `pairs`, `contact_of`, `law`, A and g: all of them count from
/// there. The gap is \f$ g(\hat u) + N(\hat u)\,d \f$ of unknowns that move by d, and the slip is what the two sides have
/// slid along each other since the last step. Supports move to where the model has them at the end of the step.
/// \param scene         contacts, and of the bodies their supports
/// \param displacement  of all nodes, from the scene to where the bodies stand
/// \param before        the same at the end of the last step
/// \param[in,out] model  from build() of the scene; as it was if an error is thrown
/// \throws ProblemError as GapOperator: a source that faces nothing, or lies in its target deeper than a cell
void place_bodies(const Scene& scene, const Displaced& displacement, const Displaced& before,
                  Model& model);

/// \param model  with bodies \return the diagonal of the smallest one [length]
[[nodiscard]] double smallest_size(const Model& model);

/// Lets gaps and slips of a model that was placed count from the scene: \f$ g - Au \f$ with all of u is what they are there.
/// \param displacement  of all nodes, where the bodies stand
/// \param[in,out] model  from place_bodies()
void count_from_the_scene(const Displaced& displacement, Model& model);

}  // namespace signorini
