/// \file
/// Weighted gaps: the gap of a pair is an average over the edges of the source around its node.
#pragma once
#include "signorini/contact/gap_operators.hpp"

namespace signorini {

/// Mortar pairs with dual functions psi_i of the source's corners:
///
/// \f[ gap_i = \frac{1}{w_i}\int \psi_i(x)\,(x - \bar x)\cdot n\,d\Gamma,\qquad
///     w_i = \int\psi_i\,d\Gamma, \f]
///
/// with the closest place \f$ \bar x \f$ of the target and its normal n there. The pressure is
/// \f$ \sum_i p_i\psi_i \f$ on both sides, so uniform p_i are the same uniform pressure for the source and for
/// the target, exactly so as far as the integrals are exact. On Quadrature::Segments they are wherever sides
/// are straight, with the operator's own 2 points per segment (3 if either side has 3-node edges, for curved
/// ones). On Quadrature::SourceEdges (2 points, else 1 to 16) kinks within an edge are smeared: the number of
/// points tells how much. One point cannot tell the two ends of an edge apart: forces are then not unique.
///
/// The points of the source that face nothing are left out, see dual_basis() for edges partly covered.
///
/// Edges with 3 nodes carry the linear functions of their corners, and their midpoints make no pair. A
/// quadratic function per node has its drawbacks: that of a corner is negative on half of the edge, so that
/// positive forces need not be pressure, and an edge covered by half gives a node a negative weight. The
/// linear functions need not resolve what the edge can: the patch test holds, and forces remain unique,
/// which three functions per edge against a target of the same mesh size are close to losing.
/// \param source   boundary of the source
/// \param target   boundary of the target
/// \param options  number of nodes, thickness, whether S is wanted, rule
/// \return pairs in walking order of the corners of the source; `unpaired` are the corners without weight,
///   and the midpoints of edges of which no point faces the target
/// \throws ProblemError as GapOperator::pair, or if `points` is out of range
[[nodiscard]] Pairs mortar(const Surface& source, const Surface& target, const GapOptions& options);

}  // namespace signorini
