#include "catch_compat.hpp"
#include "exercise.hpp"

// The beam of Xuan & Li, sec. 4, example 2: l = 50 cm, h = 5 cm, g = 1 cm, E = 21000 kN/cm^2.
// The load is in kN/cm; 8EIg / l^4 = 0.28 and 72EIg / l^4 = 2.52.
static ex6_1::FoundationContact paper_beam(double load) {
  return ex6_1::touch_foundation({50, 218750, 1, load});
}

TEST_CASE("ex6.1 up to a load of 0.28 the beam is free", "[ex6.1]") {
  const double load = GENERATE(0.0, 0.1, 0.2799);
  CAPTURE(load);
  CHECK(paper_beam(load).touchdown == 50);
  CHECK(paper_beam(load).point_force == 0);
  CHECK(paper_beam(load).total_force == 0);
}

TEST_CASE("ex6.1 up to a load of 2.52 only the tip touches", "[ex6.1]") {
  CHECK(paper_beam(1).touchdown == 50);
  CHECK(paper_beam(1).point_force == Approx(13.5).epsilon(1e-12));
  CHECK(paper_beam(1).total_force == Approx(13.5).epsilon(1e-12));
}

TEST_CASE("ex6.1 at the load of the paper the beam lies on the foundation", "[ex6.1]") {
  const ex6_1::FoundationContact contact = paper_beam(3.6);
  CHECK(contact.touchdown == Approx(45.7346).epsilon(2e-6));
  CHECK(contact.point_force == Approx(54.8815).epsilon(2e-6));
  CHECK(contact.total_force == Approx(70.2371).epsilon(2e-6));
}

// The forces do not jump at 0.28 and 2.52, and at 2.52 the touchdown starts from the tip.
TEST_CASE("ex6.1 the three regimes join", "[ex6.1]") {
  CHECK(paper_beam(0.28 + 1e-9).total_force == Approx(0).margin(1e-7));
  CHECK(paper_beam(2.52 - 1e-9).total_force == Approx(42).margin(1e-7));
  CHECK(paper_beam(2.52 + 1e-9).total_force == Approx(42).margin(1e-7));
  CHECK(paper_beam(2.52 + 1e-9).point_force == Approx(42).margin(1e-7));
  CHECK(paper_beam(2.52 + 1e-9).touchdown == Approx(50).margin(1e-7));
}
