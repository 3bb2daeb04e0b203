#include <algorithm>
#include <cmath>

#include "../chapters/ch04_quasi_active_set/cases.hpp"
#include "../chapters/ch04_quasi_active_set/last_step.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex4_5::Answers;
using ex4_5::answers;

static const exact::Programme& q = ch04::four_walls;

TEST_CASE("ex4.5 held out: what (33) violates, and by how much", "[ex4.5]") {
  const Answers mine = answers();
  const exact::Vector u = ch04::last_step(q, exact::along({1, 1, 1}, {1, 50}, {6, 3, -1})).next.u;
  std::vector<int> rows;
  double largest = 0;
  for (const std::size_t i : rows_with(q, u, -1)) {
    rows.push_back(static_cast<int>(i) + 1);
    largest = std::max(largest, -gap(q, i, u).value());
  }
  CHECK(mine.overlapping == rows);
  CHECK(std::abs(mine.largest_overlap - largest) < 1e-3);
  CHECK(std::abs(mine.at_least - energy(q, u).value()) < 1e-3);
}

TEST_CASE("ex4.5 held out: the end and the optimum", "[ex4.5]") {
  const Answers mine = answers();
  const exact::Vector end = {1, 1, 1};
  const exact::Rest held = solve_active_set(q, rows_with(q, end, 0), q.p);
  const exact::Rest best = closest(q, {0, 1, 2, 3}, q.p);
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    CAPTURE(i + 1, mine.pulling, mine.missing, held.force[i].value());
    CHECK((mine.pulling == static_cast<int>(i) + 1) == (held.force[i] < 0));
    const bool missing = 0 < best.force[i] && held.force[i] == 0;
    CHECK((mine.missing == static_cast<int>(i) + 1) == missing);
  }
  CHECK(std::abs(mine.at_most - energy(q, end).value()) < 1e-3);
  CHECK(std::abs(mine.lost - (energy(q, end) - energy(q, best.u)).value()) < 1e-3);
}

TEST_CASE("ex4.5 held out: twenty steps of the zigzag", "[ex4.5]") {
  exact::Vector u = ch04::corner.p;
  exact::Fraction eta;
  for (int k = 0; k <= 20; ++k) {
    const exact::Rest next = closest(ch04::corner, rows_with(ch04::corner, u, -1), u);
    eta = next.force[0] + next.force[1];
    u = next.u;
  }
  CHECK(std::abs(answers().eta_20 - eta.value()) < 1e-9);
}
