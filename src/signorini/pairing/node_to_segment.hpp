/// \file
/// The gaps between the nodes of one boundary and the sides of another.
#pragma once
#include "signorini/contact/gap_operators.hpp"

namespace signorini {

/// One pair per node of the source that faces the target. \PaperEq{LinEtAl, 22}
///
/// A node 3 of the source stands above the place 3' of a side of the target, whose nodes 1 and 2 carry
/// it: \f$ X_{3'} = N_1 X_1 + N_2 X_2 \f$, and with three nodes likewise. The gap opens with
/// \f$ g = g_0 + (U_3 - U_{3'})\cdot n \f$; n is the normal of the target. The weight of a node is
/// the integral of its shape function along the source, as for a rigid obstacle.
/// Uniform pressure is not transferred: what a node of the source gives to the target lands at one
/// place, not along the stretch that the node stands for.
/// \param source   the boundary whose nodes are paired
/// \param target   the boundary whose sides they face
/// \param options  the number of points and the quadrature mean nothing here
/// \return pairs in walking order of the source
/// \throws ProblemError as in GapOperator
[[nodiscard]] Pairs node_to_segment(const Surface& source, const Surface& target,
                                    const GapOptions& options);

}  // namespace signorini
