#include <cmath>
#include <stdexcept>
#include <string>

#include "exercise.hpp"

namespace ex11_3 {

static void require_positive(double x, const char* what) {
  if (!(x > 0) || !std::isfinite(x))
    throw std::invalid_argument(std::string(what) + " must be positive and finite");
}

static void require_printed(const Printed& row) {
  require_positive(row.half_width, "the half-width");
  require_positive(row.peak, "the peak");
  if (row.b_digits < 0 || row.q_digits < 0)
    throw std::invalid_argument("the digits behind a point cannot be fewer than 0");
}

static void require_contact(const Contact& contact) {
  require_positive(contact.load, "the load");
  require_positive(contact.radius, "the radius");
  require_positive(contact.modulus, "the modulus");
}

static const double pi = std::acos(-1.0);

double carried(const Printed& row) {
  require_printed(row);
  return pi * row.half_width * row.peak / 2;
}

bool is_rounding(const Printed& row, double load) {
  require_printed(row);
  require_positive(load, "the load");
  const double b_off = 0.5 * std::pow(10, -row.b_digits), q_off = 0.5 * std::pow(10, -row.q_digits);
  const double least =
      pi / 2 * std::fmax(0, row.half_width - b_off) * std::fmax(0, row.peak - q_off);
  const double most = pi / 2 * (row.half_width + b_off) * (row.peak + q_off);
  return least <= load && load <= most;
}

double pi_in_half_width(const Printed& row, const Contact& contact) {
  require_printed(row);
  require_contact(contact);
  return 4 * contact.load * contact.radius / (contact.modulus * row.half_width * row.half_width);
}

double pi_in_peak(const Printed& row, const Contact& contact) {
  require_printed(row);
  require_contact(contact);
  return contact.load * contact.modulus / (contact.radius * row.peak * row.peak);
}

}  // namespace ex11_3
