// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The pairs of a model, found anew where its bodies have moved to.
#pragma once
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Finds the pairs of a model where its bodies stand, and writes `pairs`, `contact_of`, `law`, A and g: the gap is
/// \f$ g(\hat u) + N(\hat u)\,(u - \hat u) \f$ with the place \f$ \hat u \f$, and the slip is what the two sides have slid
/// along each other since the last step. Given displacements are those that the model has now.
/// \param scene         contacts, and of the bodies their supports
/// \param displacement  `n_nodes x 2` from the scene to where the bodies stand [length]
/// \param before        `n_nodes x 2` the same at the end of the last step [length]
/// \param[in,out] model  from build() of the scene; as it was if an error is thrown
/// \param keep_points   whether the pairs keep their points, see GapOptions
/// \throws ProblemError as GapOperator: a source that faces nothing, or lies in its target deeper than a cell
void place_bodies(const Scene& scene, const NodeArray& displacement, const NodeArray& before,
                  Model& model, bool keep_points = false);

/// Which pair is which, wherever it stands among the others: the number of its contact and the node of its source.
using PairName = std::pair<std::size_t, Eigen::Index>;

/// \param model  with pairs that have nodes
/// \return `n_c` names of its pairs
[[nodiscard]] std::vector<PairName> names_of_pairs(const Model& model);

/// What the pairs of a model do, by what others did that have the same name; open where there was none.
/// \param names     of the other pairs
/// \param statuses  as many
/// \param model     whose pairs are asked for
/// \return `n_c` statuses
[[nodiscard]] std::vector<ContactStatus> handed_on(const std::vector<PairName>& names,
                                                   const std::vector<ContactStatus>& statuses,
                                                   const Model& model);

}  // namespace signorini
