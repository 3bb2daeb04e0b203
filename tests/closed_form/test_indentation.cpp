#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/indentation.hpp"
#include "support/quadrature.hpp"

using namespace signorini;
using quadrature::pi;

namespace {

const Indenter all[] = {{IndenterShape::Parabola, 3, 0.7},
                        {IndenterShape::Quartic, 3, 0.7},
                        {IndenterShape::Wedge, 3, 0.1},
                        {IndenterShape::RoundedPunch, 3, 0.7, 0.9}};
constexpr double a = 1.5;

/// Where the pressure is not smooth.
std::vector<double> corners(const Indenter& indenter) {
  if (indenter.shape == IndenterShape::RoundedPunch)
    return {-a, -indenter.flat, 0, indenter.flat, a};
  return {-a, 0, a};
}

}  // namespace

TEST_CASE("indentation: the pressure sums to the load and bends the surface to the shape",
          "[indentation]") {
  for (const Indenter& indenter : all) {
    CAPTURE(int(indenter.shape));
    const auto p = [&](double x) { return indentation_pressure(indenter, a, x); };
    CHECK(quadrature::integral(p, corners(indenter)) ==
          Approx(indentation_load(indenter, a)).epsilon(1e-12).margin(0));
    for (const double x : {-1.3, -0.7, 0.2, 0.8, 1.1, 1.4}) {
      CAPTURE(x);
      const double h = 1e-5;
      const double slope =
          (indenter_gap(indenter, x + h) - indenter_gap(indenter, x - h)) / (2 * h);
      CHECK(2 / (pi * 3) * quadrature::principal_value(p, x, corners(indenter)) ==
            Approx(slope).margin(1e-7));
      CHECK(p(x) == p(-x));
      CHECK(p(x) > 0);
    }
    CHECK(p(a) == 0);
    CHECK(p(a * (1 - 1e-10)) < 1e-3);
    CHECK(p(2) == 0);
  }
}

TEST_CASE("indentation: the half-width is the inverse of the load", "[indentation]") {
  for (const Indenter& indenter : all)
    for (const double P : {1e-6, 0.3, 40.}) {
      CAPTURE(int(indenter.shape), P);
      const double width = indentation_half_width(indenter, P);
      // a rounded punch that hardly touches beyond its flat part: width - flat has few digits
      CHECK(indentation_load(indenter, width) ==
            Approx(P).epsilon(P < 1e-3 ? 1e-9 : 1e-12).margin(0));
    }
}

TEST_CASE("indentation: limits and reference numbers of the rounded punch", "[indentation]") {
  // flat 0.6 of the contact
  const Indenter punch{IndenterShape::RoundedPunch, 1, 1, 0.6};
  const double P = indentation_load(punch, 1);
  CHECK(P == Approx(0.2236476).epsilon(1e-6).margin(0));
  CHECK(indentation_pressure(punch, 1, 0) / P == Approx(0.3816171).epsilon(1e-6).margin(0));
  // at the end of the flat part two infinities cancel
  const double there = indentation_pressure(punch, 1, 0.6);
  CHECK(indentation_pressure(punch, 1, 0.6 - 1e-9) == Approx(there).epsilon(1e-6));
  CHECK(indentation_pressure(punch, 1, 0.6 + 1e-9) == Approx(there).epsilon(1e-6));
  // without a flat part it is the parabola, with a narrow rim the flat punch
  const Indenter round{IndenterShape::RoundedPunch, 3, 0.7, 1e-9};
  CHECK(indentation_load(round, a) == Approx(indentation_load(all[0], a)).epsilon(1e-8));
  CHECK(indentation_pressure(round, a, 0.4) ==
        Approx(indentation_pressure(all[0], a, 0.4)).epsilon(1e-7));
  const Indenter flat{IndenterShape::RoundedPunch, 1, 1e-3, 1 - 1e-6};
  CHECK(indentation_pressure(flat, 1, 0.5) ==
        Approx(indentation_load(flat, 1) / (pi * std::sqrt(0.75))).epsilon(1e-5));
}

TEST_CASE("indentation: refuses what has no contact", "[indentation]") {
  CHECK_THROWS_WITH(indentation_load(all[3], 0.9), ContainsSubstring("larger than 0.9"));
  CHECK_THROWS_WITH(indentation_half_width(all[0], 0), ContainsSubstring("load must be positive"));
  CHECK_THROWS_WITH(indenter_gap({IndenterShape::RoundedPunch, 1, 1}, 0),
                    ContainsSubstring("flat must be positive"));
  CHECK_THROWS_AS(indentation_pressure({IndenterShape::Wedge, 1, 0}, 1, 0), std::invalid_argument);
}
