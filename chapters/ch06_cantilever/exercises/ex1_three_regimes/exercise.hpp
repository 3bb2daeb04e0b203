/// \file
/// Exercise 6.1 - a cantilever on a rigid foundation by hand. Do not change this file.
#pragma once

namespace ex6_1 {

/// A slender cantilever above a flat rigid foundation, clamped at x = 0, loaded towards it.
struct Cantilever {
  double length;             ///< l [length], positive
  double bending_stiffness;  ///< E I [force length^2], positive
  double gap;                ///< g, from the beam to the foundation [length], not negative
  double load;               ///< w [force/length], uniform; negative lifts the beam
};

/// How the foundation holds the beam.
struct FoundationContact {
  double touchdown;    ///< s, where contact begins [length]; l if only the tip touches or nothing
  double point_force;  ///< concentrated reaction at s [force], compression > 0
  double total_force;  ///< all of the reaction [force], compression > 0
};

/// Euler-Bernoulli beam in its three regimes: free, tip contact, line contact.
///
/// A load w deflects the free tip by w l^4 / 8EI, a force R at the tip lifts it by R l^3 / 3EI. In line
/// contact the beam lies flat on the foundation from s on: at s the deflection is g, the slope and the
/// moment are 0, and the shear force jumps. The three regimes join continuously in point and total
/// force.
/// \throws std::invalid_argument unless length and stiffness are positive and the gap is not negative
[[nodiscard]] FoundationContact touch_foundation(const Cantilever& beam);

}  // namespace ex6_1
