#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "closed_form/brazilian.hpp"
#include "exercise.hpp"

using ex12_2::middle_tension;
using ex12_2::widest_arc;

static const double pi = std::acos(-1.0);

TEST_CASE("ex12.2 held out: the field of Hondros, whatever disc and load", "[ex12.2]") {
  const signorini::SqueezedDisc disc{3, 17};
  for (const double alpha : {0.01, 0.2, 0.7, 1.2, 1.57})
    CHECK(middle_tension(alpha) == Approx(signorini::arc_loaded_disc_stress(disc, alpha, 0, 0)[0] /
                                          signorini::brazilian_strength(disc))
                                       .epsilon(1e-12));
}

// loss = 7/6 alpha^2 (1 - 23/420 alpha^2 + ...)
TEST_CASE("ex12.2 held out: small losses keep their digits", "[ex12.2]") {
  CHECK(widest_arc(0) == 0);
  for (const double loss : {1e-6, 1e-10, 1e-16, 1e-30, 1e-200}) {
    CAPTURE(loss);
    const double first = std::sqrt(6 * loss / 7);
    CHECK(widest_arc(loss) ==
          Approx(first * (1 + 23. / 840 * first * first)).epsilon(1e-9).margin(0));
  }
}

TEST_CASE("ex12.2 held out: wider always loses more, up to the whole rim", "[ex12.2]") {
  double before = 0;
  for (int k = 1; k <= 100; ++k) {
    const double alpha = widest_arc((1 + pi / 2) * k / 100);
    CHECK(alpha > before);
    before = alpha;
  }
  CHECK(before == Approx(pi / 2).epsilon(1e-9));
}

TEST_CASE("ex12.2 held out: what is no arc and no loss is refused", "[ex12.2]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-0.1, 1.6, nan})
    CHECK_THROWS_AS(middle_tension(bad), std::invalid_argument);
  for (const double bad : {-1e-9, 2.6, nan})
    CHECK_THROWS_AS(widest_arc(bad), std::invalid_argument);
}
