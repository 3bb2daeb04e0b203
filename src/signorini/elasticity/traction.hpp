/// \file
/// What a stress does to a face: the part along its normal and the part along the face.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// The force per area on a face of a body.
struct Traction {
  double normal;  ///< sigma_n [force/length^2], tension > 0: minus the contact pressure
  Eigen::Vector2d tangential;  ///< along the face, on the body [force/length^2]
};

/// Splits the traction \f$ \sigma n \f$ of a plane stress tensor.
///
/// \f[ \sigma_n = n^T\sigma n, \f] \PaperEq{LinEtAl, 5}
/// \f[ \tau = \sigma n - \sigma_n n, \f] \PaperEq{LinEtAl, 7}
/// \param stress  (sigma_x, sigma_y, tau_xy) of the body [force/length^2], tension > 0
/// \param normal  out of the body, length 1
/// \return both parts
[[nodiscard]] inline Traction traction(const Eigen::Vector3d& stress,
                                       const Eigen::Vector2d& normal) {
  const Eigen::Vector2d whole(stress(0) * normal.x() + stress(2) * normal.y(),
                              stress(2) * normal.x() + stress(1) * normal.y());
  const double along = whole.dot(normal);
  return {along, whole - along * normal};
}

}  // namespace signorini
