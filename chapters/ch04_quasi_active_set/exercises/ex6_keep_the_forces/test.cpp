#include "../chapters/ch04_quasi_active_set/cases.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector2d;
using Eigen::Vector3d;
using ex4_6::outer_loop;
using ex4_6::Round;
using signorini::DenseProgramme;

static DenseProgramme floating(const exact::Programme& q) {
  DenseProgramme made;
  const auto n = static_cast<Eigen::Index>(q.p.size());
  made.stiffness = Eigen::MatrixXd::Identity(n, n);
  made.load = ch04::floating(q.p);
  made.A.resize(static_cast<Eigen::Index>(q.A.size()), n);
  for (Eigen::Index i = 0; i < made.A.rows(); ++i)
    made.A.row(i) = ch04::floating(q.A[static_cast<std::size_t>(i)]);
  made.initial_gap = ch04::floating(q.g);
  return made;
}

TEST_CASE("ex4.6 where one round is enough, one round it is", "[ex4.6]") {
  const std::vector<Round> rounds = outer_loop(floating(ch04::fan), 50);
  REQUIRE(rounds.size() == 1);
  CHECK(rounds[0].displacement.norm() < 1e-14);
}

TEST_CASE("ex4.6 the zigzag ends in its corner", "[ex4.6]") {
  const std::vector<Round> rounds = outer_loop(floating(ch04::corner), 50);
  REQUIRE(rounds.size() == 2);
  CHECK(equal_within(rounds[0].displacement, Vector2d(1, 0), 1e-14));
  CHECK(rounds[1].displacement.norm() < 1e-13);
  CHECK(equal_within(rounds[1].force, Vector2d(3, 1), 1e-13));
}

TEST_CASE("ex4.6 four walls", "[ex4.6]") {
  const std::vector<Round> rounds = outer_loop(floating(ch04::four_walls), 50);
  REQUIRE(rounds.size() < 10);
  const exact::Rest best = closest(ch04::four_walls, {0, 1, 2, 3}, ch04::four_walls.p);
  CHECK(equal_within(rounds.back().displacement, ch04::floating(best.u), 1e-12));
  CHECK(equal_within(rounds.back().force, ch04::floating(best.force), 1e-12));
}

TEST_CASE("ex4.6 nothing violated, no round; and never more than are allowed", "[ex4.6]") {
  DenseProgramme away = floating(ch04::corner);
  away.initial_gap = Vector2d(5, 5);
  CHECK(outer_loop(away, 50).size() == 0);
  CHECK(outer_loop(floating(ch04::corner), 1).size() == 1);
}
