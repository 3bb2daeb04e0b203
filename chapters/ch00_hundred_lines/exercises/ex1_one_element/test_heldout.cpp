#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"
#include "support/equal_within.hpp"

using Corners = Eigen::Matrix<double, 3, 2>;

TEST_CASE("ex0.1 held out: the library's triangle, of any shape and material", "[ex0.1]") {
  signorini::Random random(3);
  for (int sample = 0; sample < 50; ++sample) {
    Corners corners;
    corners << random.uniform(0, 1), random.uniform(0, 1), random.uniform(2, 3),
        random.uniform(0, 1), random.uniform(0, 3), random.uniform(2, 3);
    const signorini::Material material{random.uniform(1, 9), random.uniform(0, 0.45),
                                       signorini::PlaneState::Strain, random.uniform(0.1, 5)};
    const Eigen::Matrix3d D = signorini::elasticity_matrix(material);
    const Eigen::MatrixXd theirs = signorini::cell_stiffness(
        signorini::t3(),
        signorini::cell_body(signorini::CellNodes(corners), D, depth_of(material)));
    CAPTURE(sample);
    CHECK(equal_within(ex0_1::triangle_stiffness(corners, D, material.thickness), theirs,
                       1e-13 * theirs.norm()));
  }
}

TEST_CASE("ex0.1 held out: the same far from the origin", "[ex0.1]") {
  const Corners near = (Corners() << 0, 0, 1, 0, 0, 1).finished();
  const Corners far = near.array() + 1048576;
  const Eigen::Matrix3d D = Eigen::Vector3d(1, 1, 0.5).asDiagonal();
  CHECK(ex0_1::triangle_stiffness(far, D, 1) == ex0_1::triangle_stiffness(near, D, 1));
}

TEST_CASE("ex0.1 held out: what is no triangle is refused", "[ex0.1]") {
  const Eigen::Matrix3d D = Eigen::Matrix3d::Identity();
  const Corners clockwise = (Corners() << 0, 0, 0, 1, 1, 0).finished();
  const Corners flat = (Corners() << 0, 0, 1, 1, 2, 2).finished();
  Corners right = (Corners() << 0, 0, 1, 0, 0, 1).finished();
  CHECK_THROWS_AS(ex0_1::triangle_stiffness(clockwise, D, 1), std::invalid_argument);
  CHECK_THROWS_AS(ex0_1::triangle_stiffness(flat, D, 1), std::invalid_argument);
  CHECK_THROWS_AS(ex0_1::triangle_stiffness(right, D, 0), std::invalid_argument);
  right(1, 0) = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(ex0_1::triangle_stiffness(right, D, 1), std::invalid_argument);
}
