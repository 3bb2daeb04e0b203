/// \file
/// Which edges to halve for a smaller error.
#pragma once
#include <vector>

#include "signorini/estimate/estimate.hpp"
#include "signorini/refinement/edges.hpp"

namespace signorini {

/// Marks the cheapest chords whose halving leaves a part of the error.
///
/// Halving a chord leaves a quarter of what falls to it, for as many new nodes as it has edges. Chords
/// are taken by what they lose for a node, also for the second and further times, until no more than
/// `part` is left. The interior part falls to cells by the sizes of their shares, and from these to
/// their chords by Estimate::first_direction, of triangles to their longest side; what gap and reading
/// add, to the closed sides of the sources by the third power of their lengths; the free boundary, to
/// the sides where contact ends.
/// \param model     that was solved
/// \param solution  of it
/// \param estimate  of the goal
/// \param part      of the error that may be left, above 0 and below 1 [-]
/// \return of each body
[[nodiscard]] std::vector<MarkedEdges> marks_for(const Model& model, const Solution& solution,
                                                 const Estimate& estimate, double part);

/// Marks the sides of contacts of few closed pairs, and those next to them.
/// \param model     that was solved
/// \param solution  of it
/// \param few       contacts of fewer closed pairs than that are refined, unless all of their pairs are open
/// \return of each body; nothing if there is no such contact
[[nodiscard]] std::vector<MarkedEdges> marks_where_few_close(const Model& model,
                                                             const Solution& solution,
                                                             std::size_t few);

}  // namespace signorini
