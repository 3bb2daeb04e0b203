/// \file
/// Exercise 13.5 - what every node should carry if the load is beside the middle. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex13_5 {

/// A rigid strip on a half-plane.
struct Strip {
  double half_width;        ///< a [length], > 0
  double load;              ///< P [force/length], > 0
  double eccentricity = 0;  ///< e: the load acts at x = e [length]
};

/// Forces that the nodes below a strip should carry: the pressure, integrated over the share of each node.
///
/// Up to |e| = a/2 the pressure is \f$ P\,(1 + 2ex/a^2) / (\pi\sqrt{a^2 - x^2}) \f$. Beyond, the far edge lifts off, and what still
/// bears is a strip of the half-width b = 2 (a - |e|) at the loaded edge, whose load is b/2 beside its own middle.
/// \param strip     with its load
/// \param position  `n` increasing, across the whole strip [length]; a share reaches from the middle to the left neighbour to
///   the middle to the right one, that of the first node begins and that of the last one ends at the node itself
/// \return `n` forces [force/length], compression > 0; 0 where nothing bears
/// \throws std::invalid_argument unless a and P are positive and |e| < a: beyond, the strip topples
[[nodiscard]] Eigen::VectorXd shares(const Strip& strip, const Eigen::VectorXd& position);

}  // namespace ex13_5
