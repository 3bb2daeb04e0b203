/// \file
/// Exercise 11.2 - a wedge on a plate. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/scene/scene.hpp"

namespace ex11_2 {

/// Two bodies of one material, one of them with a blunt edge.
struct Wedge {
  double slope;        ///< t: the flanks rise by t |x| [-], small
  double modulus;      ///< E [force/length^2]
  double ratio;        ///< nu
  double load;         ///< P of the whole wedge [force/length]
  double core;         ///< width and depth of the even cells next to the tip [length]
  double size;         ///< width and depth of either body [length]
  Eigen::Index cells;  ///< of the core along the contact
};

/// The right halves of both bodies, ready to be solved: plane strain, 1 thick, element as in a new Body.
///
/// Body 0, "wedge": a make_half_space mesh mirrored at its surface, every node lifted by
/// t x (1 - y / size), so that the `base`, which is on top then, stays level. It carries P/2 as an even
/// pressure. Body 1, "plate": the same
/// mesh as it is, `base` fixed. Both are symmetric at x = 0, where nothing moves along x. The wedge is
/// the source, the plate the target. Cores have `cells` columns and 3/4 as many rows, 16 layers
/// around and a layer_grading of 3.
/// \param wedge  positive numbers, cells divisible by 4
/// \return the scene
[[nodiscard]] signorini::Scene wedge_on_plate(const Wedge& wedge);

/// Half-width of the contact under a wedge from the forces of its right half.
///
/// The pressure (E* t / pi) arcosh(a / x) has a second moment of another share of a^2 than an
/// ellipse: find it, and mind the correction for linear edges that exercise 11.1 knows.
/// \param position  `n` rising from 0 [length]
/// \param force     `n` >= 0 [force], at least one of them not zero
/// \return a [length]
[[nodiscard]] double wedge_half_width(const Eigen::VectorXd& position,
                                      const Eigen::VectorXd& force);

}  // namespace ex11_2
