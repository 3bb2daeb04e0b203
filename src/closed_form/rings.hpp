/// \file
/// Thick rings under pressure, and one ring in another: with clearance, without, or pressed in.
#pragma once

namespace signorini {

/// A ring, or a disc if its inner radius is 0.
struct Ring {
  double inner_radius;  ///< [length], not negative
  double outer_radius;  ///< [length], larger
  double modulus;       ///< E', plane_strain_modulus() or E in plane stress [force/length^2], > 0
  double ratio;         ///< nu', plane_strain_ratio() or nu in plane stress [-]
};

/// What presses on a ring [force/length^2], compression > 0.
struct RingPressure {
  double inside;   ///< p_i on the inner rim
  double outside;  ///< p_o on the outer rim
};

/// Stress in a ring [force/length^2], tension > 0.
struct RingStress {
  double radial;  ///< along the radius
  double hoop;    ///< across it
};

/// Displacement of a ring a < r < b, after Lame [\ref TimoshenkoGoodier1970]:
/// \f[ u = \frac{(1 - \nu') A\,r + (1 + \nu') B / r}{E'},\quad
///     A = \frac{p_i a^2 - p_o b^2}{b^2 - a^2},\quad B = \frac{(p_i - p_o)\,a^2 b^2}{b^2 - a^2}. \f]
/// \param ring  any
/// \param load  on its rims
/// \param r     from the centre [length], in the ring
/// \return u outwards [length]
/// \throws std::invalid_argument if radii or modulus are out of range, or r outside of the ring
[[nodiscard]] double ring_displacement(const Ring& ring, const RingPressure& load, double r);

/// Stress of a ring, \f$ \sigma_r = A - B / r^2,\ \sigma_\theta = A + B / r^2 \f$.
/// \param ring  any
/// \param load  on its rims
/// \param r     from the centre [length], in the ring
/// \return radial and hoop stress
/// \throws std::invalid_argument as ring_displacement()
[[nodiscard]] RingStress ring_stress(const Ring& ring, const RingPressure& load, double r);

/// What is equal on both sides of a closed gap.
///
/// The sides meet on one radius after the deformation, but rims b and c differ before it, and a
/// theory of small displacements has to choose.
enum class Meeting {
  EqualForce,    ///< per angle: the outer rim bears p_c b / c. Contact of nodes does the same
  EqualPressure  ///< both rims bear p_c, as in books; forces differ by the share of the gap
};

/// A ring in a ring.
struct NestedRings {
  Ring inner;                             ///< whose outer rim may touch
  Ring outer;                             ///< around it
  double pressure_inside = 0;             ///< on the inner rim of the inner ring [force/length^2]
  double pressure_outside = 0;            ///< on the outer rim of the outer ring [force/length^2]
  Meeting meeting = Meeting::EqualForce;  ///< what is equal on both sides
};

/// Clearance of two rings without load.
/// \param rings  any
/// \return inner radius of the outer ring less outer radius of the inner one [length]; minus the
///   interference of a press fit
[[nodiscard]] double ring_clearance(const NestedRings& rings);

/// Pressures on the four rims, in contact or not.
struct NestedPressure {
  RingPressure inner;  ///< of the inner ring; `outside` is the contact pressure p_c, 0 if open
  RingPressure outer;  ///< of the outer ring; `inside` is p_c, or p_c b / c for equal forces
};

/// Contact of two rings without friction: displacements at the rims differ by the clearance,
/// \f[ u_{in}(b;\,p_i, p_c) - u_{out}(c;\,p'_c, p_o) = c - b, \f]
/// one linear equation for p_c. A negative solution means that they do not touch.
/// \param rings  with their loads
/// \return pressures on all rims
/// \throws std::invalid_argument as ring_displacement()
[[nodiscard]] NestedPressure nested_pressure(const NestedRings& rings);

/// Pressure inside that just closes the gap; the one outside stays as it is.
/// \param rings  whose pressure_inside does not enter
/// \return pressure [force/length^2]; negative if they touch without it
/// \throws std::invalid_argument as ring_displacement(), or if the inner ring is a disc
[[nodiscard]] double closing_pressure(const NestedRings& rings);

}  // namespace signorini
