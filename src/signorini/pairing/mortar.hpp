/// \file
/// Weighted gaps: the gap of a pair is an average over the edges of the source around its node.
///
/// The word is from domain decomposition: the pressure is the mortar between two meshes that do not
/// match. Node to segment lets forces act at points, mortar lets a pressure act along the surface.
#pragma once
#include "signorini/contact/gap_operators.hpp"

namespace signorini {

/// Mortar pairs with dual functions psi_i of the nodes of the source:
///
/// \f[ gap_i = \frac{1}{w_i}\int \psi_i(x)\,(x - \bar x)\cdot n\,d\Gamma,\qquad
///     w_i = \int\psi_i\,d\Gamma, \f]
///
/// with the closest place \f$ \bar x \f$ of the target and its normal n there. The
/// pressure is \f$ \sum_i p_i\psi_i \f$ on both sides, so equal p_i are the same uniform pressure for the
/// source and for the target, exactly so as far as the integrals are exact. On Quadrature::Segments they are
/// wherever sides are straight, with the operator's own 2 points per segment (3 if either body has sides of
/// three nodes, for curved ones). On Quadrature::SourceEdges (2 points, or 1 to 16) kinks within an edge are
/// smeared: the number of points is the knob that tells how much [\ref FarahPoppWall2015]. One point cannot tell the two ends of an
/// edge apart: forces are then not unique.
///
/// A side of three nodes counts as two edges: its functions psi are those of straight lines between
/// neighbouring nodes, while positions and displacements follow the parabola. Dual parabolas would do worse:
/// that of an end is negative on half of its side, so that positive forces need not be pressure, a side covered
/// by half would give it a negative weight, and pressures scatter up to six times as much in Hertz's problem.
/// Lines from corner to corner give smoother pressures, but half as many.
///
/// Points of the source that face nothing are left out; see dual_basis() for edges that are partly covered.
/// \param source   boundary of the source
/// \param target   boundary of the target
/// \param options  number of nodes, depth, whether S is wanted, rule
/// \return pairs in walking order of the nodes of the source; `unpaired` are the nodes without weight
/// \throws ProblemError as GapOperator::pair, or if `points` is out of range
/// \throws std::invalid_argument as Interface
[[nodiscard]] Pairs mortar(const Surface& source, const Surface& target, const GapOptions& options);

}  // namespace signorini
