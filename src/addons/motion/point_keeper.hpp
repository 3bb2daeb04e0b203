// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What bodies that move want to know of their pairs, beside the rows.
#pragma once
#include "signorini/contact/kept_points.hpp"

namespace signorini {

/// A point without references to what lives no longer than an interface.
/// \param interface  of source and target
/// \param point      on it
/// \param share      by which it counts in its pair [-]
/// \return the same point
[[nodiscard]] KeptPoint kept_point(const Interface& interface, const PairPoint& point,
                                   double share);

/// \return who keeps points for contact_curvature()
[[nodiscard]] const PointKeeper& point_keeper();

}  // namespace signorini
