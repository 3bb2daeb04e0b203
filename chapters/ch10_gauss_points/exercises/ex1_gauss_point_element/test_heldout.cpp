#include <Eigen/Geometry>
#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector2d;

namespace {

// Edges near the line through the origin at any angle, the source about `lift` above the target.
ex10_1::Edges random_edges(signorini::Random& random, double lift) {
  const Eigen::Rotation2Dd turn(random.uniform(-3, 3));
  const double tilt = random.uniform(-0.1, 0.1);
  ex10_1::Edges edges;
  edges.source.row(0) = (turn * Vector2d(random.uniform(-0.9, -0.2), lift - tilt)).transpose();
  edges.source.row(1) = (turn * Vector2d(random.uniform(0.2, 0.9), lift + tilt)).transpose();
  edges.target.row(0) = (turn * Vector2d(random.uniform(1, 2), 0)).transpose();
  edges.target.row(1) = (turn * Vector2d(random.uniform(-2, -1), 0)).transpose();
  return edges;
}

double cross(const Eigen::RowVector2d& x, const Eigen::RowVector2d& f) {
  return x(0) * f(1) - x(1) * f(0);
}

}  // namespace

TEST_CASE("ex10.1 held out: forces and moments of pressure balance across any gap",
          "[ex10.1][LinEtAl-36]") {
  signorini::Random random(1);
  for (int sample = 0; sample < 100; ++sample) {
    const ex10_1::Edges edges = random_edges(random, random.uniform(-0.3, 0.3));
    const auto element = ex10_1::gauss_point(edges, random.uniform(-1, 1), 0.7, 2, 0);
    CAPTURE(sample);
    double moment = 0;
    for (Eigen::Index k = 0; k < 2; ++k)
      moment += cross(edges.source.row(k), element.force.row(k)) +
                cross(edges.target.row(k), element.force.row(2 + k));
    CHECK(element.force.colwise().sum().norm() < 1e-14);
    CHECK(std::abs(moment) < 1e-14);
  }
}

TEST_CASE("ex10.1 held out: a force does the work of its share times the change of the gap",
          "[ex10.1][LinEtAl-33]") {
  signorini::Random random(2);
  for (int sample = 0; sample < 100; ++sample) {
    const ex10_1::Edges edges = random_edges(random, 0);
    const double xi = random.uniform(-1, 1), weight = random.uniform(0.1, 1);
    const double length = (edges.source.row(1) - edges.source.row(0)).norm();
    const auto element = ex10_1::gauss_point(edges, xi, weight, 1, 0);
    // Nodes of the source only: if those of the target move, the normal turns as well.
    for (Eigen::Index node = 0; node < 2; ++node)
      for (Eigen::Index axis = 0; axis < 2; ++axis) {
        ex10_1::Edges forth = edges, back = edges;
        forth.source(node, axis) += 1e-5;
        back.source(node, axis) -= 1e-5;
        const double change = ex10_1::gauss_point(forth, xi, weight, 0, 0).gap -
                              ex10_1::gauss_point(back, xi, weight, 0, 0).gap;
        // The gap is linear in these nodes; differences of gaps round to 1e-16 / 1e-5.
        CHECK(std::abs(element.force(node, axis) - 0.5 * length * weight * change / 2e-5) < 1e-10);
      }
  }
}

TEST_CASE("ex10.1 held out: pressure and shear of one size are at right angles",
          "[ex10.1][LinEtAl-40]") {
  signorini::Random random(3);
  for (int sample = 0; sample < 50; ++sample) {
    const ex10_1::Edges edges = random_edges(random, 0);
    const auto pressed = ex10_1::gauss_point(edges, 0.3, 1, 1, 0);
    const auto dragged = ex10_1::gauss_point(edges, 0.3, 1, 0, 1);
    for (Eigen::Index k = 0; k < 4; ++k) {
      const Vector2d n = pressed.force.row(k), t = dragged.force.row(k);
      CHECK(equal_within(t, Vector2d(n.y(), -n.x()), 1e-14));
    }
  }
}
