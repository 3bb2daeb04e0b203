/// \file
/// Partial slip below a cylinder: the pressure first, then a tangential force that grows.
#pragma once

namespace signorini {

/// A contact of Hertz between bodies of one material, with friction; tangential forces come after
/// the pressure, which they do not change [\ref Mindlin1949] [\ref Johnson1985].
struct PartialSlip {
  double half_width;            ///< b of the contact, hertz_half_width() [length], > 0
  double peak_pressure;         ///< q_0, hertz_peak_pressure() [force/length^2], > 0
  double friction_coefficient;  ///< mu [-], > 0
};

/// Largest tangential force: \f$ \mu P = \mu\,\pi b q_0 / 2 \f$. Beyond there is no equilibrium.
/// \param slip  any
/// \return force [force/length]
/// \throws std::invalid_argument unless all three numbers are positive
[[nodiscard]] double slip_limit(const PartialSlip& slip);

/// Half-width of the part that sticks while the tangential force Q grows from 0:
/// \f$ c = b \sqrt{1 - |Q| / (\mu P)} \f$.
/// \param slip   any
/// \param force  Q [force/length], at most slip_limit() either way
/// \return c [length]
/// \throws std::invalid_argument as slip_limit(), or if |Q| is beyond the limit
[[nodiscard]] double stick_half_width(const PartialSlip& slip, double force);

/// Traction while Q grows from 0, with \f$ s(x, c) = \sqrt{\max(0, 1 - x^2 / c^2)} \f$:
/// \f$ \mu q_0\,[s(x, b) - (c / b)\,s(x, c)] \f$ with the sign of Q.
/// \param slip   any
/// \param force  Q [force/length]
/// \param x      from the middle of the contact [length]
/// \return traction [force/length^2], along Q > 0 where Q > 0
/// \throws std::invalid_argument as stick_half_width()
[[nodiscard]] double slip_traction(const PartialSlip& slip, double force, double x);

/// Traction after Q grew from 0 to `turned` and came back to `force`.
///
/// The way back is a growth by `turned` - `force` with twice the friction, the other way:
/// \f$ 2 \mu q_0\,[s(x, b) - (c_2 / b)\,s(x, c_2)],\ c_2 = b \sqrt{1 - (Q_1 - Q) / (2 \mu P)} \f$ is
/// taken off. At Q = -Q_1 the traction is that of growth to -Q_1, and the past is forgotten.
/// \param slip    any
/// \param turned  Q_1 where the force turned [force/length], not negative
/// \param force   Q now [force/length], from -Q_1 to Q_1
/// \param x       from the middle of the contact [length]
/// \return traction [force/length^2]
/// \throws std::invalid_argument as stick_half_width(), or if Q is out of range
[[nodiscard]] double slip_traction_back(const PartialSlip& slip, double turned, double force,
                                        double x);

}  // namespace signorini
