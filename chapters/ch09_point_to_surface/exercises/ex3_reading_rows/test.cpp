#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "../chapters/ch09_point_to_surface/contact_element.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex9_3;

// The row of node 3 of an element of the chapter; the nodes 1, 2 and 3 get these numbers.
static Row row_of(const ch09::Nodes& X, int one, int two, int three) {
  const ch09::Nodes unit = ch09::nodal_forces(ch09::projected(X), 1, 0);
  return {{two, false, unit(1, 0), unit(1, 1)},
          {three, true, unit(2, 0), unit(2, 1)},
          {one, false, unit(0, 0), unit(0, 1)}};
}

TEST_CASE("ex9.3 the row of figure 9.1", "[ex9.3][LinEtAl-21][LinEtAl-22]") {
  const ch09::Nodes X = (ch09::Nodes() << 4, 0, 0, 3, 3, 1.5).finished();
  const Row row = row_of(X, 1, 2, 3);
  const Reading reading = reading_of(row);
  CHECK(reading.source == 3);
  REQUIRE(reading.shares.size() == 2);
  CHECK(reading.shares[0].node == 1);
  CHECK(reading.shares[1].node == 2);
  CHECK(reading.shares[0].N == Approx(0.66).epsilon(1e-12));
  CHECK(reading.shares[0].N + reading.shares[1].N == Approx(1).epsilon(1e-12));
  CHECK(std::hypot(reading.nx, reading.ny) == Approx(1).epsilon(1e-12));
  CHECK(reading.nx * 4 - reading.ny * 3 == Approx(0).margin(1e-12));  // across the edge
  CHECK(reading.nx > 0);                                              // out of the target
}

// 7 edges over 15: eight rows, sixteen nodes of the target with the numbers 100 to 115.
TEST_CASE("ex9.3 eight nodes cannot reach sixteen", "[ex9.3][LinEtAl-27]") {
  std::vector<Row> rows;
  std::vector<double> force;
  for (int k = 0; k <= 7; ++k) {
    const double x = k / 7.0;
    const int edge = std::min(static_cast<int>(x * 15), 14);  // the body of the target is below
    const ch09::Nodes X = (ch09::Nodes() << (edge + 1) / 15.0, 0, edge / 15.0, 0, x, 0).finished();
    rows.push_back(row_of(X, 101 + edge, 100 + edge, k));
    force.push_back(k == 0 || k == 7 ? 0.5 : 1);
  }
  std::vector<int> nodes(16);
  std::iota(nodes.begin(), nodes.end(), 100);
  const std::vector<double> got = reached(rows, force, nodes);
  REQUIRE(got.size() == 16);
  double sum = 0, moment = 0;
  for (int i = 0; i < 16; ++i) {
    sum += got[static_cast<std::size_t>(i)];
    moment += got[static_cast<std::size_t>(i)] * i / 15;
  }
  CHECK(sum == Approx(7).epsilon(1e-12));  // nothing is lost
  CHECK(moment == Approx(3.5).epsilon(1e-12));
  // Who is untouched gets nothing, whatever presses; all others get something from some row.
  const std::vector<int> none = untouched(rows, nodes);
  CHECK(none.size() * nodes.size() == 32);
  for (const int node : nodes) {
    const bool named = std::find(none.begin(), none.end(), node) != none.end();
    CHECK(named == (got[static_cast<std::size_t>(node - 100)] < 1e-12));
  }
}

TEST_CASE("ex9.3 a row without a node of the source is refused", "[ex9.3]") {
  CHECK_THROWS_AS(reading_of({{1, false, 0, 1}, {2, false, 0, -1}}), std::invalid_argument);
}
