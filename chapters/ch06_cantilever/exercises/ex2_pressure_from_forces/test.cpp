#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::VectorXd;
using ex6_2::ContactLine;
using signorini::MeshOrder;

static VectorXd list(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

// A pressure of 3 on edges of length 2, 1 thick: the ends collect half as much as the others.
TEST_CASE("ex6.2 a uniform pressure is uniform up to the ends of linear edges", "[ex6.2]") {
  const ContactLine line =
      ex6_2::contact_line(list({0, 2, 4, 6}), list({3, 6, 6, 3}), MeshOrder::Linear, 1);
  REQUIRE(line.pressure.size() == 4);
  CHECK(equal_within(line.pressure, VectorXd::Constant(4, 3), 1e-14));
  CHECK(line.touchdown == 0);
}

// Two edges of length 6: 1/6, 4/6, 1/6 of an edge, and twice 1/6 where they meet.
TEST_CASE("ex6.2 a uniform pressure is uniform on quadratic edges", "[ex6.2]") {
  const ContactLine line =
      ex6_2::contact_line(list({0, 3, 6, 9, 12}), list({3, 12, 6, 12, 3}), MeshOrder::Quadratic, 1);
  REQUIRE(line.pressure.size() == 5);
  CHECK(equal_within(line.pressure, VectorXd::Constant(5, 3), 1e-14));
}

TEST_CASE("ex6.2 edges of different length share their middle node fairly", "[ex6.2]") {
  const ContactLine line =
      ex6_2::contact_line(list({0, 1, 4}), list({5, 20, 15}), MeshOrder::Linear, 2);
  REQUIRE(line.pressure.size() == 3);
  CHECK(equal_within(line.pressure, VectorXd::Constant(3, 5), 1e-14));
}

// Pressures 4 sqrt(x - 1.3) at nodes 1 apart; the first closed node is at 2.
TEST_CASE("ex6.2 the touchdown of a square-root pressure is found between nodes", "[ex6.2]") {
  VectorXd force = VectorXd::Zero(6);
  for (int k = 2; k < 6; ++k) force(k) = 4 * std::sqrt(k - 1.3) * (k == 5 ? 0.5 : 1.0);
  const ContactLine line =
      ex6_2::contact_line(list({0, 1, 2, 3, 4, 5}), force, MeshOrder::Linear, 1);
  CHECK(line.touchdown == Approx(1.3).epsilon(1e-13));
}

TEST_CASE("ex6.2 nothing closed: the touchdown is the last node", "[ex6.2]") {
  const ContactLine line =
      ex6_2::contact_line(list({0, 1, 2}), VectorXd::Zero(3), MeshOrder::Linear, 1);
  CHECK(line.touchdown == 2);
}

TEST_CASE("ex6.2 no touchdown between nodes: all closed, or a pressure that does not grow",
          "[ex6.2]") {
  const VectorXd three = list({1, 2, 3}), four = list({1, 2, 3, 4});
  CHECK(ex6_2::contact_line(three, list({1, 4, 4}), MeshOrder::Linear, 1).touchdown == 1);
  CHECK(ex6_2::contact_line(four, list({0, 3, 2, 1}), MeshOrder::Linear, 1).touchdown == 2);
}

TEST_CASE("ex6.2 positions that do not increase are refused", "[ex6.2]") {
  CHECK_THROWS_AS(ex6_2::contact_line(list({3, 2, 1}), list({1, 1, 1}), MeshOrder::Linear, 1),
                  std::invalid_argument);
}
