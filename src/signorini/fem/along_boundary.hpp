// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Integrals along a boundary, and what forces add up to.
///
/// Loads, shares of a boundary and resultants are all integrals over its sides. They differ only in
/// what is summed, so the loop stands here once, with three Gauss points on every side: exact for
/// polynomials of degree 5. On a body of revolution a uniform pressure on a curved side needs just
/// that: degree 2 for the shape functions, 1 for the tangent, 2 for the radius.
///
/// A Resultant also sums the *sizes* of its forces. Two forces of 1 that pull against each other
/// add up to 0, and rounding of that 0 has the size of 1. Whoever asks whether forces balance
/// divides by this.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "signorini/fem/element.hpp"
#include "signorini/fem/side_curve.hpp"

namespace signorini {

/// A Gauss point of a side of a boundary.
struct BoundaryPoint {
  const SideCurve& side;    ///< that it lies on; the shape functions are those of its nodes()
  Eigen::Vector3d N;        ///< shape functions there [-]
  Eigen::Vector2d tangent;  ///< dx/dxi [length], in walking order
  AnchoredPoint point;      ///< where it is
  double weight;            ///< of the Gauss rule: times |tangent| a part of the length [-]
};

/// Calls a function at the Gauss points of every side of a boundary, in walking order.
/// \param mesh   that has the boundary
/// \param name   of the boundary
/// \param visit  gets a BoundaryPoint
/// \param rule   of a side; empty: three points
/// \throws ProblemError if there is no such boundary, or it has no sides
template <typename Visit>
void integrate_boundary(const Mesh& mesh, const std::string& name, Visit&& visit,
                        const std::function<std::vector<GaussPoint>(const SideCurve&)>& rule = {}) {
  for (const SideCurve& side : side_curves(mesh, name)) {
    const auto at = [&](const GaussPoint& gauss) {
      visit(BoundaryPoint{side, side.shape(gauss.xi).value, side.tangent(gauss.xi),
                          side.point(gauss.xi), gauss.weight});
    };
    if (rule)
      for (const GaussPoint& gauss : rule(side)) at(gauss);
    else
      for (const GaussPoint& gauss : gauss_line(3)) at(gauss);
  }
}

/// What forces add up to, and what they would if nothing cancelled.
struct Resultant {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< their sum [force]
  double moment = 0;       ///< about where the arms begin, anticlockwise > 0 [force length]
  double all_forces = 0;   ///< sum of their sizes [force]
  double all_moments = 0;  ///< sum of arm times size [force length]

  /// \param arm  from the point that moments are taken about [length] \param one  of the forces there
  void add(const Eigen::Vector2d& arm, const Eigen::Vector2d& one) {
    force += one;
    moment += arm.x() * one.y() - arm.y() * one.x();
    all_forces += one.norm();
    all_moments += arm.norm() * one.norm();
  }
};

}  // namespace signorini
