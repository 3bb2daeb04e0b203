/// \file
/// Elimination orders for the sparse factor.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// Which unknown stands at each place of the elimination order.
using EliminationOrder = std::vector<int>;

/// Nested dissection by coordinates: cut the unknowns in two halves across the longer side of their
/// bounding box, eliminate one half, the other half, and last those that join them; each half
/// likewise.
///
/// On a mesh the cut is a line of nodes, so that few unknowns are joined by elimination
/// [\ref George1973]. Unknowns with the same neighbours, as the two of a node mostly are, stay
/// together.
/// \param matrix     `n x n` compressed, symmetric pattern, both triangles
/// \param positions  `n x 2` where each unknown is [length]
/// \param last       unknowns that must come last, in whatever order dissection gives them
/// \return each unknown once, those of `last` at the end
/// \throws std::invalid_argument if sizes differ or `last` names an unknown twice or one that is
///   not there
[[nodiscard]] EliminationOrder nested_dissection(const Eigen::SparseMatrix<double>& matrix,
                                                 const NodeArray& positions,
                                                 const std::vector<Eigen::Index>& last = {});

/// Eigen's approximate minimum degree [\ref AmestoyDavisDuff1996], for matrices without
/// coordinates.
/// \param matrix  `n x n` symmetric pattern, both triangles
/// \param last    unknowns that must come last, in whatever order minimum degree gives them
/// \return each unknown once, those of `last` at the end
/// \throws std::invalid_argument as nested_dissection()
[[nodiscard]] EliminationOrder minimum_degree(const Eigen::SparseMatrix<double>& matrix,
                                              const std::vector<Eigen::Index>& last = {});

}  // namespace signorini
