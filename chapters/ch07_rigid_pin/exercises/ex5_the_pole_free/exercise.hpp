/// \file
/// Exercise 7.5 - the pole free. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex7_5 {

/// A plate whose pole is held, condensed to its pairs. The pole is none of them.
struct HeldPlate {
  Eigen::MatrixXd compliance;  ///< G `n x n`, symmetric positive definite [length/force]
  Eigen::VectorXd free_gap;    ///< d `n` [length]: gaps without contact forces, the pole held
  Eigen::VectorXd cosine;      ///< cos(theta) `n` of each pair [-]; 1 at the pole
  double load;                 ///< P, towards the pin along the pole [force]
};

/// What the pin bears.
struct Bearing {
  double pole_force;      ///< [force] >= 0
  double pole_gap;        ///< how far the pole has lifted off [length] >= 0
  Eigen::VectorXd force;  ///< `n` of the other pairs [force] >= 0
};

/// Lets go of the pole.
/// \param plate  with its pole held
/// \return forces and the gap of the pole; all conditions of contact hold at the pole too
/// \throws std::invalid_argument if sizes do not fit
/// \throws signorini::NotSolved if the load pulls the plate off the pin
[[nodiscard]] Bearing pole_free(const HeldPlate& plate);

}  // namespace ex7_5
