/// \file
/// What is known of partial slip in closed form, and by how much a computed one misses it.
#pragma once
#include <cmath>

#include "closed_form/cattaneo.hpp"
#include "closed_form/hertz.hpp"
#include "closed_form/moduli.hpp"
#include "cylinder.hpp"

namespace ch15 {

/// The cylinder pressed, without a push: P, and all of theory that follows from it.
struct Pressed {
  double P = 0;        ///< [N/mm]
  PartialSlip slip{};  ///< half-width b, largest pressure q0, mu
  double Q = 0;        ///< where the push turns [N/mm]

  /// \return the push: to Q at time 2, to -Q at 4, to Q again at 6
  [[nodiscard]] History push() const { return {"push", {1, 2, 4, 6}, {0, Q, -Q, Q}}; }
  /// Half-width of what has not slid since the push last turned. \param time  1 to 6 \return [mm]
  [[nodiscard]] double stuck(double time) const {
    const double now = push().at(time);
    if (time <= 2) return stick_half_width(slip, now);
    return slip.half_width *
           std::sqrt(1 - (time <= 4 ? Q - now : Q + now) / (2 * slip.friction_coefficient * P));
  }
  /// Shear on the plate. \param time  1 to 6 \param x  [mm] \return closed form [MPa]
  [[nodiscard]] double shear(double time, double x) const {
    const double now = push().at(time);
    if (time <= 2) return slip_traction(slip, now, x);
    return time <= 4 ? slip_traction_back(slip, Q, now, x) : -slip_traction_back(slip, Q, -now, x);
  }
};

/// What follows from the force. \param P  that presses the cylinder [N/mm] \param coefficient  of friction
/// \param share  of mu P at which the push turns \return all of it
inline Pressed pressed_with(double P, double coefficient = mu, double share = 0.6) {
  const double plane = plane_strain_modulus(resin.youngs_modulus, resin.poisson_ratio);
  const LineContact contact{R, contact_modulus(plane, plane), P};
  return {P,
          {hertz_half_width(contact), hertz_peak_pressure(contact), coefficient},
          share * coefficient * P};
}

/// \return the cylinder pressed
inline Pressed pressed_cylinder() {
  double P = 0;
  remember(by_force(cylinder({1}, pressing, {"push", {1}, {0}})),
           [&](const Model&, const Step& step) { P = step.solution.contact.force.sum(); });
  return pressed_with(P);
}

/// Misses of the shear within the contact. \param known  closed form \param time  of it \param model  of the
/// cylinder \param step  to be judged \return root of their mean square over mu q0 [-]
inline double miss(const Pressed& known, double time, const Model& model, const Step& step) {
  const Eigen::VectorXd found = shear_of(model, step);
  double sum = 0, length = 0;
  for (Index i = 0; i < found.size(); ++i) {
    const double x = model.pairs.position(i, 0), weight = model.pairs.weight(i);
    if (std::abs(x) > known.slip.half_width) continue;
    sum += weight * std::pow(found(i) - known.shear(time, x), 2);
    length += weight;
  }
  return std::sqrt(sum / length) / (known.slip.friction_coefficient * known.slip.peak_pressure);
}

/// What slip in total would miss in closed form: it has the shear of a push that grew to where it is. \param known
/// closed form \param time  1 to 6 \return as miss()
inline double forgotten(const Pressed& known, double time) {
  const int n = 1000;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double x = known.slip.half_width * ((2 * i + 1.) / n - 1);
    sum += std::pow(slip_traction(known.slip, known.push().at(time), x) - known.shear(time, x), 2);
  }
  return std::sqrt(sum / n) / (known.slip.friction_coefficient * known.slip.peak_pressure);
}

/// Half-width of what sticks, read from all of it: what friction has left there to its bound is, in closed form,
/// mu q0 sqrt(a^2 - x^2) / b. \param known  closed form \param model  of the cylinder \param step  of a push
/// that grows \return a [mm]
inline double stuck_half_width(const Pressed& known, const Model& model, const Step& step) {
  const ContactState& contact = step.solution.contact;
  const PartialSlip& slip = known.slip;
  const double coefficient = slip.friction_coefficient;
  double sum = 0, length = 0;
  for (Index i = 0; i < contact.friction.size(); ++i) {
    if (contact.contact_status[static_cast<std::size_t>(i)] != ContactStatus::Stick) continue;
    const double weight = model.pairs.weight(i), x = model.pairs.position(i, 0);
    const double left = (coefficient * contact.force(i) - std::abs(contact.friction(i))) / weight;
    sum +=
        weight * (x * x + std::pow(slip.half_width * left / (coefficient * slip.peak_pressure), 2));
    length += weight;
  }
  return std::sqrt(sum / length);
}

}  // namespace ch15
