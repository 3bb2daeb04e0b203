/// \file
/// Exercise 13.3 - a body that no support holds. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace ex13_3 {

/// A body that can move in one way without being strained, and what it may touch.
struct FloatingBody {
  Eigen::MatrixXd stiffness;    ///< K `n x n`, symmetric; K x = 0 for multiples of the motion only
  Eigen::VectorXd motion;       ///< m `n`, the rigid motion [-]
  Eigen::VectorXd load;         ///< p `n` [force]
  Eigen::MatrixXd A;            ///< `n_c x n`: gap = initial_gap - A u
  Eigen::VectorXd initial_gap;  ///< g `n_c` [length]
};

/// How it comes to rest.
struct Rest {
  Eigen::VectorXd force;         ///< lambda `n_c` [force], compression > 0; exactly 0 of open pairs
  double amplitude = 0;          ///< a: u - a m is zero at the unknown that is held
  Eigen::VectorXd displacement;  ///< u `n` [length]
};

/// Finds rest if it is known which pairs are closed: \f$ K u = p - A^T\lambda \f$, their gaps are zero, all other forces are.
///
/// Whether signs are right is not asked: a force that comes out negative, or a gap that does, says that other pairs are closed.
/// \param body    any; the closed rows of A and balance determine forces and amplitude
/// \param held    number of an unknown that moves with m
/// \param closed  numbers of the closed pairs, at least one, each once
/// \return forces, amplitude and displacements; forces and displacements do not depend on `held`
/// \throws std::invalid_argument if the motion does not move the unknown that is held
/// \throws signorini::ProblemError if the motion leaves all closed gaps as they are: nothing stops it
[[nodiscard]] Rest rest_of(const FloatingBody& body, Eigen::Index held,
                           const std::vector<Eigen::Index>& closed);

}  // namespace ex13_3
