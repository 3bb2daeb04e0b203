#include "closed_form/beam.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/bisection.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

/// Section constants and the load per length.
struct Section {
  double bending;  ///< E I [force length^2]
  double shear;    ///< kappa G A [force]
  double load;     ///< w = q b [force/length]
};

Section section_of(const BeamOnFoundation& beam) {
  require_argument(
      beam.length > 0 && beam.height > 0 && beam.width > 0 && beam.youngs_modulus > 0 &&
          beam.gap > 0 && beam.pressure >= 0,
      "beam: length, height, width, modulus and gap must be positive and the pressure not "
      "negative");
  const double area = beam.width * beam.height;
  const double G = beam.youngs_modulus / (2 * (1 + beam.poisson_ratio));
  return {beam.youngs_modulus * area * beam.height * beam.height / 12, 5.0 / 6.0 * G * area,
          beam.pressure * beam.width};
}

/// Timoshenko beam that touches from s on: what is known there.
struct TouchAt {
  double shear;       ///< of the tip force T, as it acts at s: T cosh((l - s) / lambda)
  double deflection;  ///< that the integrals of moment and shear give
  double clamp_shear;
};
TouchAt touch_at(const Section& beam, double length, double s) {
  const double lambda = std::sqrt(beam.bending / beam.shear);
  const double tanh = std::tanh((length - s) / lambda);
  // Shear, moment and rotation are continuous at s, which leaves one unknown, the shear there ...
  const double w = beam.load;
  const double at_s = w * s * s * s / 6 / (lambda * tanh * s + s * s / 2 + lambda * lambda);
  const double shear = w * s - at_s;                                 // at the clamp
  const double moment = at_s * (lambda * tanh + s) - w * s * s / 2;  // at the clamp
  // ... and the deflection, which must be the gap, decides on s.
  const double v =
      -(moment * s * s / 2 + shear * s * s * s / 6 - w * s * s * s * s / 24) / beam.bending +
      (shear * s - w * s * s / 2) / beam.shear;
  return {at_s, v, shear};
}

}  // namespace

double tip_contact_pressure(const BeamOnFoundation& beam) {
  return 8 * section_of(beam).bending * beam.gap / (beam.width * std::pow(beam.length, 4));
}

double line_contact_pressure(const BeamOnFoundation& beam) {
  return 9 * tip_contact_pressure(beam);
}

BeamContact euler_bernoulli(const BeamOnFoundation& beam) {
  const Section section = section_of(beam);
  const double l = beam.length;
  if (beam.pressure <= line_contact_pressure(beam)) {
    const double tip = 3 * section.load * l / 8 - 3 * section.bending * beam.gap / (l * l * l);
    return {l, std::max(0.0, tip), std::max(0.0, tip)};
  }
  const double s = std::pow(72 * section.bending * beam.gap / section.load, 0.25);
  return {s, section.load * s / 3 + section.load * (l - s), section.load * s / 3};
}

BeamContact timoshenko(const BeamOnFoundation& beam) {
  const Section section = section_of(beam);
  const double l = beam.length;
  if (touch_at(section, l, l).deflection <= beam.gap) {
    const double free_tip =
        section.load * l * l * (l * l / (8 * section.bending) + 1 / (2 * section.shear));
    const double softness = l * (l * l / (3 * section.bending) + 1 / section.shear);
    const double tip = std::max(0.0, (free_tip - beam.gap) / softness);
    return {l, tip, tip};
  }
  const double s = bisected(0, l, [&](double at) {
                     return touch_at(section, l, at).deflection < beam.gap;
                   }).second;
  const TouchAt touch = touch_at(section, l, s);
  const double lambda = std::sqrt(section.bending / section.shear);
  return {s, section.load * l - touch.clamp_shear, touch.shear / std::cosh((l - s) / lambda)};
}

double timoshenko_pressure(const BeamOnFoundation& beam, double x) {
  const double s = timoshenko(beam).touchdown;
  if (x < s || s >= beam.length) return 0;
  const Section section = section_of(beam);
  const double lambda = std::sqrt(section.bending / section.shear);
  // T sinh((l - x) / lambda), written so that it does not overflow in a slender beam
  const double decay = std::exp((s - x) / lambda) * -std::expm1(-2 * (beam.length - x) / lambda) /
                       (1 + std::exp(-2 * (beam.length - s) / lambda));
  return beam.pressure + touch_at(section, beam.length, s).shear * decay / (beam.width * lambda);
}

}  // namespace signorini
