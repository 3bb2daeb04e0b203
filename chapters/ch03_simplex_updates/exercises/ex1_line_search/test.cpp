#include "catch_compat.hpp"
#include "exercise.hpp"

// G = (2 1; 1 2), b = (7, 5), from (1/2, 1/2) along (1/2, -1/2): b0 = 6, b1 = 1, c0 = 3/2, c1 = 0,
// c2 = 1/2. The forces are (3, 1), the weights (3/4, 1/4).
TEST_CASE("ex3.1 two pairs: one step reaches the forces", "[ex3.1]") {
  CHECK(ex3_1::best_step({6, 1, 1.5, 0, 0.5}, 1) == Approx(0.5).epsilon(1e-14));
}

TEST_CASE("ex3.1 the same line with other lengths of xi and delta", "[ex3.1]") {
  CHECK(ex3_1::best_step({12, 2, 6, 0, 2}, 1) == Approx(0.5).epsilon(1e-14));    // both doubled
  CHECK(ex3_1::best_step({6, 2, 1.5, 0, 2}, 1) == Approx(0.25).epsilon(1e-14));  // delta doubled
}

TEST_CASE("ex3.1 the border of the simplex ends a step", "[ex3.1]") {
  CHECK(ex3_1::best_step({6, 1, 1.5, 0, 0.5}, 0.2) == 0.2);
  CHECK(ex3_1::best_step({6, 1, 1.5, 0, 0.5}, 0) == 0);
}

TEST_CASE("ex3.1 no rise, no step", "[ex3.1]") {
  CHECK(ex3_1::best_step({6, -1, 1.5, 0, 0.5}, 1) == 0);  // backwards on the same line
  CHECK(ex3_1::best_step({6, 0, 1.5, 0, 0.5}, 1) == 0);   // level
}

// s = (1 + 2 t)^2 / 2: no compliance is added, so that nothing bends the line.
TEST_CASE("ex3.1 what rises all the way goes all the way", "[ex3.1]") {
  CHECK(ex3_1::best_step({1, 2, 1, 0, 0}, 0.7) == 0.7);
}

// The same two pairs from (1, 0) along (-1, 1), which feel each other: c1 = -1. Again to (3/4, 1/4).
TEST_CASE("ex3.1 weights and direction feel each other", "[ex3.1]") {
  CHECK(ex3_1::best_step({7, -2, 2, -1, 2}, 1) == Approx(0.25).epsilon(1e-14));
}
