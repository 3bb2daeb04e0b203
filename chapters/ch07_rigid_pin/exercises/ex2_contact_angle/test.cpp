#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/pin.hpp"
#include "exercise.hpp"

using ex7_2::half_contact_angle;

static const double degree = std::acos(-1.0) / 180;

TEST_CASE("ex7.2 without clearance the angle is the same for every load", "[ex7.2]") {
  CHECK(half_contact_angle(0, 1).angle / degree == Approx(72.348).epsilon(1e-5).margin(0));
  CHECK(half_contact_angle(0, 0.5).angle / degree == Approx(84.828).epsilon(1e-5).margin(0));
}

// Persson's relation, evaluated at the angle to be found.
TEST_CASE("ex7.2 the angle solves the load relation", "[ex7.2]") {
  for (const double angle : {10.0, 30.0, 55.59, 70.0, 80.0}) {
    CAPTURE(angle);
    const double wanted = signorini::pin_clearance_over_load(angle * degree, 1);
    const ex7_2::ContactAngle found = half_contact_angle(wanted, 1);
    CHECK(found.angle / degree == Approx(angle).epsilon(1e-12).margin(0));
    CHECK(found.evaluations > 0);
    CHECK(found.evaluations <= 200);
  }
}

// -2 r / pi is where the relation ends.
TEST_CASE("ex7.2 a thick pin touches all round", "[ex7.2]") {
  CHECK(half_contact_angle(-0.7, 1).angle == Approx(std::acos(-1.0)).epsilon(1e-15));
  CHECK(half_contact_angle(-0.3, 0.5).angle < std::acos(-1.0));
}
