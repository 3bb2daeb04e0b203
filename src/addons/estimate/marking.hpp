// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Which edges to halve for a smaller error.
#pragma once
#include <vector>

#include "addons/estimate/edges.hpp"
#include "addons/estimate/estimate.hpp"

namespace signorini {

/// Marks the cheapest refinement lines whose halving leaves a part of the error.
///
/// Halving one leaves a quarter of what falls to it, for as many new nodes as it has edges. Lines
/// are taken by what they lose for a node, also for the second and further times, until no more than
/// `part` is left and there are `growth` times the nodes, or all lines are that have a share. The interior part falls to cells by the sizes of their shares, and from these to
/// their refinement lines by Estimate::first_direction, of triangles to their longest side; what gap and reading
/// add, to the closed sides of the sources by the third power of their lengths; the free boundary, to
/// the sides where contact ends; the outline, to the sides that it leaves.
/// \param model     that was solved
/// \param solution  of it
/// \param estimate  of the goal
/// \param part      of the error that may be left, above 0 and up to 1 [-]
/// \param growth    least nodes of the finer mesh by those of this one, 1 or more [-]
/// \return of each body
[[nodiscard]] std::vector<MarkedEdges> mark_elements(const Model& model, const Solution& solution,
                                                     const Estimate& estimate, double part,
                                                     double growth);

/// Marks where a mesh is too coarse for an estimate.
///
/// In contacts of too few closed pairs, the sides with a closed pair, as often as would close enough, if all
/// pairs have nodes: Gauss points are refused by estimates(). Between n closed pairs there are n - 1 sides, so that halving
/// these surely closes 2 n - 1; of one pair it may close a second. And
/// what is one cell thick: cells whose corners belong to no cell with a corner inside the body, or inside what is of one
/// material. There no polynomial is fitted, see recovered(), and stresses recovered by means know nothing across: edges inside are halved, or
/// all of a cell that has none.
/// \param model     that was solved
/// \param solution  of it
/// \param few       contacts of fewer closed pairs than that are refined, unless all of their pairs are open
/// \return of each body; nothing if there is no such place
[[nodiscard]] std::vector<MarkedEdges> marks_where_coarse(const Model& model,
                                                          const Solution& solution,
                                                          std::size_t few);

}  // namespace signorini
