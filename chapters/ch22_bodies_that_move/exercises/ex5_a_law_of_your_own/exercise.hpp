/// \file
/// Exercise 22.5 - a law of your own for finite strain, as the library asks for one. Do not change this file.
#pragma once
#include "addons/motion/finite_strain.hpp"

namespace ex22_5 {

using signorini::Components;
using signorini::Lame;
using signorini::StressResponse;

/// Rubber whose volume is kept by a quadratic: the energy mu/2 (F : F - 3 - 2 ln J) + lambda/4 (J^2 - 1 - 2 ln J) per volume
/// before strain, with J = det F.
/// \param lame      lambda >= 0 and mu > 0 [force/length^2]
/// \param H         F - 1, det F > 0: 11, 12, 21, 22 and 33, that across the plane [-]. May be as small as 1e-12: stresses keep
///   ten of their digits
/// \param response  is filled: P, its derivative, and the energy, of which no digits are asked for small H
void stress(const Lame& lame, const Components& H, StressResponse& response);

/// \return that law as a member of strain_laws(), by the name of "quadratic_volume"
[[nodiscard]] signorini::StrainLaw quadratic_volume();

}  // namespace ex22_5
