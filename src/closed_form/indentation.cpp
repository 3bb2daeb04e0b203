#include "closed_form/indentation.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/bisection.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

void check(const Indenter& indenter) {
  require_argument(indenter.modulus > 0 && indenter.size > 0 &&
                       (indenter.shape != IndenterShape::RoundedPunch || indenter.flat > 0),
                   "indenter: modulus, size and, of a rounded punch, flat must be positive, got ",
                   indenter.modulus, ", ", indenter.size, ", ", indenter.flat);
}

void check(const Indenter& indenter, double half_width) {
  check(indenter);
  const double least = indenter.shape == IndenterShape::RoundedPunch ? indenter.flat : 0;
  require_argument(half_width > least, "indenter: the half-width must be larger than ", least,
                   ", got ", half_width);
}

/// x ln|y| with the limit 0 at x = 0.
double times_log(double x, double y) { return x == 0 ? 0 : x * std::log(std::abs(y)); }

/// The bracket of the rounded punch; its two infinities at phi = phi_0 cancel.
double rounded_bracket(double phi, double phi0) {
  const double even = (pi - 2 * phi0) * std::cos(phi);
  const double sum = std::sin((phi + phi0) / 2);
  const double cosine = std::cos((phi + phi0) / 2);
  const double difference = std::sin((phi - phi0) / 2);
  const double other = std::cos((phi - phi0) / 2);
  // sin(2 y) = 2 sin y cos y, collected by factors: that of the difference has a vanishing weight.
  const double plus = std::sin(phi0) + std::sin(phi);
  const double minus = std::sin(phi0) - std::sin(phi);
  return even + times_log(plus, sum) - times_log(minus, cosine) + times_log(minus, difference) -
         times_log(plus, other);
}

}  // namespace

double indenter_gap(const Indenter& indenter, double x) {
  check(indenter);
  const double beyond = std::max(0.0, std::abs(x) - indenter.flat);
  switch (indenter.shape) {
    case IndenterShape::Parabola:
      return x * x / (2 * indenter.size);
    case IndenterShape::Quartic:
      return indenter.size * x * x * x * x;
    case IndenterShape::Wedge:
      return indenter.size * std::abs(x);
    case IndenterShape::RoundedPunch:
      return beyond * beyond / (2 * indenter.size);
  }
  return 0;
}

double indentation_load(const Indenter& indenter, double half_width) {
  check(indenter, half_width);
  const double E = indenter.modulus;
  const double a = half_width;
  switch (indenter.shape) {
    case IndenterShape::Parabola:
      return pi * E * a * a / (4 * indenter.size);
    case IndenterShape::Quartic:
      return 3 * pi / 4 * E * indenter.size * a * a * a * a;
    case IndenterShape::Wedge:
      return E * indenter.size * a;
    case IndenterShape::RoundedPunch: {
      const double phi0 = std::asin(indenter.flat / a);
      return E * a * a / (4 * indenter.size) * (pi - 2 * phi0 - std::sin(2 * phi0));
    }
  }
  return 0;
}

double indentation_half_width(const Indenter& indenter, double load) {
  check(indenter);
  require_argument(load > 0, "indenter: the load must be positive, got ", load);
  const double low = indenter.shape == IndenterShape::RoundedPunch ? indenter.flat : 0;
  double high = low > 0 ? 2 * low : 1;
  while (indentation_load(indenter, high) < load) high *= 2;
  return bisected(low, high, [&](double a) { return indentation_load(indenter, a) < load; }).second;
}

double indentation_pressure(const Indenter& indenter, double half_width, double x) {
  check(indenter, half_width);
  const double E = indenter.modulus;
  const double a = half_width;
  if (std::abs(x) >= a) return 0;
  const double root = std::sqrt((a - x) * (a + x));
  switch (indenter.shape) {
    case IndenterShape::Parabola:
      return E / (2 * indenter.size) * root;
    case IndenterShape::Quartic:
      return E * indenter.size * (2 * x * x + a * a) * root;
    case IndenterShape::Wedge:
      return E * indenter.size / pi * std::acosh(a / std::abs(x));
    case IndenterShape::RoundedPunch:
      return E * a / (2 * pi * indenter.size) *
             rounded_bracket(std::asin(std::abs(x) / a), std::asin(indenter.flat / a));
  }
  return 0;
}

}  // namespace signorini
