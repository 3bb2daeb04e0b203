#include <cmath>
#include <stdexcept>

#include "../chapters/ch14_lining/rings.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::VectorXd;
using ex14_4::Outline;
using ex14_4::pressures;

namespace {

/// Corners around the origin at random radii and angles, counter-clockwise.
MatrixX2d star(signorini::Random& random, Index n) {
  MatrixX2d corners(n, 2);
  for (Index k = 0; k < n; ++k) {
    const double angle = 4 * ch14::quarter_turn *
                         (static_cast<double>(k) + random.uniform(0, 0.8)) / static_cast<double>(n);
    corners.row(k) << std::cos(angle), std::sin(angle);
    corners.row(k) *= random.uniform(0.7, 1.4);
  }
  return corners;
}

/// Of the chapter's rings, by one operator.
signorini::SolvedScene lining(const char* gap_operator) {
  ch14::Rings rings;
  rings.gap_operator = gap_operator;
  return ch14::run_of(rings);
}

}  // namespace

// All sides under one pressure: the forces balance, and every corner says the pressure, re-entrant ones too.
TEST_CASE("ex14.4 held out: any polygon, moved, in any unit", "[ex14.4]") {
  signorini::Random random(14);
  for (int sample = 0; sample < 100; ++sample) {
    const double unit = std::pow(10, random.uniform(-6, 6));
    const Index n = random.whole(3, 12);
    const MatrixX2d corners = unit * star(random, n);
    MatrixX2d force = MatrixX2d::Zero(n, 2);
    for (Index k = 0; k < n; ++k) {
      const Eigen::RowVector2d side = corners.row((k + 1) % n) - corners.row(k);
      const Eigen::RowVector2d inwards(-side.y(), side.x());
      force.row(k) += 3.5 * inwards;
      force.row((k + 1) % n) += 3.5 * inwards;
    }
    CAPTURE(sample, unit, n);
    CHECK(force.colwise().sum().norm() < 1e-12 * unit);
    MatrixX2d place = corners;
    place.rowwise() += Eigen::RowVector2d(2 * unit, -unit);
    const VectorXd found = pressures(place, force, Outline::Closed);
    REQUIRE(found.size() == n);
    CHECK((found.array() - 7).abs().maxCoeff() < 1e-8);
  }
}

TEST_CASE("ex14.4 held out: what acts along the outline is no pressure", "[ex14.4]") {
  const MatrixX2d line = (MatrixX2d(3, 2) << 0, 0, 1, 0, 2, 0).finished();
  MatrixX2d force = (MatrixX2d(3, 2) << 9, 1, -9, -2, 9, 1).finished();
  CHECK(equal_within(pressures(line, force, Outline::Open), Eigen::Vector3d(2, -2, 2), 1e-13));
}

// One force, three pressures: from the forces of node_to_segment comes the pressure of mortar.
TEST_CASE("ex14.4 held out: the lining by two operators", "[ex14.4]") {
  const signorini::SolvedScene nodes = lining("node_to_segment"), mortar = lining("mortar");
  const signorini::BoundaryForces rim = boundary_forces(nodes, signorini::Side{"outer", "lining"});
  const MatrixX2d force = contact_forces(nodes.model, nodes.solution);
  MatrixX2d on_rim(rim.position.rows(), 2);
  const auto order = boundary_nodes(nodes.model.bodies[0].mesh, "outer");
  for (Index k = 0; k < on_rim.rows(); ++k)
    on_rim.row(k) = force.row(order[static_cast<std::size_t>(k)]);
  const VectorXd found = pressures(rim.position, on_rim, Outline::Open);
  REQUIRE(found.size() == 10);
  for (Index k = 1; k < 9; ++k)
    CHECK(found(k) == Approx(mortar.solution.pressure.mean()).epsilon(1e-9));
}

// There and back: no pressure on the two sides makes a force at the tip.
TEST_CASE("ex14.4 held out: sides that cancel are refused", "[ex14.4]") {
  const MatrixX2d spike = (MatrixX2d(3, 2) << 0, 0, 2, 0, 0, 0).finished();
  CHECK_THROWS_AS(pressures(spike, MatrixX2d::Ones(3, 2), Outline::Open), std::invalid_argument);
  CHECK_THROWS_AS(pressures(spike.topRows(2), MatrixX2d::Ones(2, 2), Outline::Closed),
                  std::invalid_argument);
  CHECK_NOTHROW(pressures(spike.topRows(2), MatrixX2d::Ones(2, 2), Outline::Open));
}
