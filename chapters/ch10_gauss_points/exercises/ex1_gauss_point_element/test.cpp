#include <Eigen/Geometry>
#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

namespace {

// A cell from 0.75 to 1.75 above one from 0 to 2, whose top is walked from right to left.
ex10_1::Edges cells(double lift) {
  ex10_1::Edges edges;
  edges.source << 0.75, 1 + lift, 1.75, 1 + lift;
  edges.target << 2, 1, 0, 1;
  return edges;
}

}  // namespace

TEST_CASE("ex10.1 the point of the chapter puts these forces on its nodes",
          "[ex10.1][LinEtAl-33][LinEtAl-34][LinEtAl-35][LinEtAl-36]") {
  const double xi = -1 / std::sqrt(3.0);
  const ex10_1::Element element = ex10_1::gauss_point(cells(0), xi, 1, 3, 0);
  const double near = 0.5 * (1 - xi), right = (1.25 + 0.5 * xi) / 2;  // N_1 and N_3
  CHECK(equal_within(element.force.col(1), 1.5 * Eigen::Vector4d(near, 1 - near, -right, right - 1),
                     1e-15));
  CHECK(element.force.col(0).norm() < 1e-15);
}

TEST_CASE("ex10.1 friction drags the source along the tangent and the target back",
          "[ex10.1][LinEtAl-38][LinEtAl-39][LinEtAl-40][LinEtAl-41]") {
  const ex10_1::Element element = ex10_1::gauss_point(cells(0), 0, 2, 0, 1);
  CHECK(equal_within(element.force.col(0), Eigen::Vector4d(0.5, 0.5, -0.625, -0.375), 1e-15));
  CHECK(element.force.col(1).norm() < 1e-15);
}

TEST_CASE("ex10.1 a lifted source has a gap, a lowered one overlaps", "[ex10.1][LinEtAl-32]") {
  for (const double lift : {0.25, 0.0, -0.25}) {
    const ex10_1::Element element = ex10_1::gauss_point(cells(lift), 0.5, 1, 1, 0);
    CHECK(equal_within(element.point, Eigen::Vector2d(1.5, 1 + lift), 1e-15));
    CHECK(std::abs(element.gap - lift) < 1e-15);
  }
}

TEST_CASE("ex10.1 if both edges turn, the point and the forces turn with them",
          "[ex10.1][LinEtAl-36][LinEtAl-41]") {
  const ex10_1::Edges level = cells(0.25);
  const ex10_1::Element before = ex10_1::gauss_point(level, 0.5, 1, 3, 1);
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(2.2).toRotationMatrix();
  const ex10_1::Edges turned{level.source * turn.transpose(), level.target * turn.transpose()};
  const ex10_1::Element after = ex10_1::gauss_point(turned, 0.5, 1, 3, 1);
  CHECK(std::abs(after.gap - 0.25) < 1e-14);
  CHECK(equal_within(after.point, turn * before.point, 1e-14));
  CHECK(equal_within(after.force, before.force * turn.transpose(), 1e-14));
}
