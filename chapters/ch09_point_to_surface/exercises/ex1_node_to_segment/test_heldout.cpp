#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"

using Eigen::Matrix2d;
using Eigen::Vector2d;
using ex9_1::Nodes;

namespace {

Nodes random_nodes(signorini::Random& random) {
  Nodes nodes;
  for (Eigen::Index i = 0; i < 6; ++i) nodes(i % 3, i / 3) = random.uniform(-2, 2);
  return nodes;
}

double moment(const Nodes& x, const Nodes& f) {
  return x.col(0).dot(f.col(1)) - x.col(1).dot(f.col(0));
}

}  // namespace

TEST_CASE("ex9.1 held out: force and moment balance, but for friction across a gap", "[ex9.1]") {
  signorini::Random random(1);
  int found = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const Nodes x = random_nodes(random);
    const auto place = ex9_1::facing(x);
    if (!place) continue;
    ++found;
    CAPTURE(sample);
    const Nodes pressing = ex9_1::shared_out(*place, 1, 0);
    const Nodes dragging = ex9_1::shared_out(*place, 0, 1);
    CHECK((pressing + dragging).colwise().sum().norm() < 1e-14);
    CHECK(std::abs(moment(x, pressing)) < 1e-13);
    CHECK(std::abs(moment(x, dragging) + place->gap) < 1e-13);
  }
  CHECK(found > 50);  // 300 random triples have some that face each other
}

TEST_CASE("ex9.1 held out: forces do the work of the gap and of the slip", "[ex9.1]") {
  signorini::Random random(2);
  for (int sample = 0; sample < 100; ++sample) {
    const Nodes x = random_nodes(random), u = random_nodes(random);
    const auto place = ex9_1::facing(x);
    if (!place) continue;
    const Vector2d facing = place->N1 * u.row(0).transpose() + place->N2 * u.row(1).transpose();
    const Vector2d apart = u.row(2).transpose() - facing;
    CAPTURE(sample);
    CHECK(std::abs(ex9_1::shared_out(*place, 1, 0).cwiseProduct(u).sum() - apart.dot(place->n)) <
          1e-14);
    CHECK(std::abs(ex9_1::shared_out(*place, 0, 1).cwiseProduct(u).sum() - apart.dot(place->t)) <
          1e-14);
  }
}

TEST_CASE("ex9.1 held out: turning and moving everything changes no gap and turns the forces",
          "[ex9.1]") {
  signorini::Random random(3);
  for (int sample = 0; sample < 100; ++sample) {
    const Nodes x = random_nodes(random);
    const double angle = random.uniform(0, 6);
    Matrix2d turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Nodes moved = (x * turn.transpose()).rowwise() + Eigen::RowVector2d(3, -1);
    const auto one = ex9_1::facing(x), two = ex9_1::facing(moved);
    CAPTURE(sample);
    REQUIRE(one.has_value() == two.has_value());  // no sample is near enough to an end for rounding
    if (!one) continue;
    CHECK(std::abs(one->gap - two->gap) < 1e-13);
    // Short edges lose digits of the normal: 3 of them at most here.
    CHECK(
        (ex9_1::shared_out(*two, 2, 1) - ex9_1::shared_out(*one, 2, 1) * turn.transpose()).norm() <
        1e-12);
  }
}
