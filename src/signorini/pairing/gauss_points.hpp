/// \file
/// The gaps between the Gauss points of one boundary and the sides of another.
#pragma once
#include "signorini/contact/gap_operators.hpp"

namespace signorini {

/// One pair per Gauss point of every side of the source that faces the target, 1 to 6 of them on a
/// side, 2 unless asked otherwise. \PaperEq{LinEtAl, 37}
///
/// Every pair has a force of its own, so that there are as many forces as Gauss points, however few
/// nodes there are to press against each other: with linear sides the gaps of two points and the
/// next are already dependent. Forces and pressures are then not unique; see chapter 10.
/// \param source   the boundary whose Gauss points are paired
/// \param target   the boundary whose sides they face
/// \param options  `points` on every side of the source
/// \return pairs in walking order of the source, without nodes; `unpaired` are the nodes whose sides
///   have no pair
/// \throws ProblemError as in GapOperator, and if `points` is not 0 to 6
[[nodiscard]] Pairs gauss_points(const Surface& source, const Surface& target,
                                 const GapOptions& options);

}  // namespace signorini
