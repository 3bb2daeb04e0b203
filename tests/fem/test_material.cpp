#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "signorini/fem/material.hpp"
#include "support/message.hpp"

using signorini::elasticity_matrix;
using signorini::Material;
using signorini::PlaneState;
using signorini::stress_across;
using signorini_test::problem_message;

namespace {

std::string complaint(double E, double nu, PlaneState state, double thickness = 1) {
  return problem_message([&] { signorini::check_material({E, nu, state, thickness}); });
}

}  // namespace

TEST_CASE("Hooke's law in space, with nothing across the plane, gives the plane law",
          "[material][XuanLi2002-3]") {
  const double E = 210;
  const double nu = 0.3;
  const Eigen::Vector3d strain(1e-3, -4e-4, 7e-4);
  SECTION("plane strain: the strain across is zero") {
    const Eigen::Vector3d stress = elasticity_matrix({E, nu, PlaneState::Strain, 1}) * strain;
    const double across = stress_across({E, nu, PlaneState::Strain, 1}, stress);
    CHECK((stress(0) - nu * (stress(1) + across)) / E == Approx(strain(0)).epsilon(1e-13));
    CHECK((stress(1) - nu * (stress(0) + across)) / E == Approx(strain(1)).epsilon(1e-13));
    CHECK((across - nu * (stress(0) + stress(1))) / E == Approx(0).margin(1e-18));
    CHECK(stress(2) * 2 * (1 + nu) / E == Approx(strain(2)).epsilon(1e-13));
  }
  SECTION("plane stress: the stress across is zero") {
    const Eigen::Vector3d stress = elasticity_matrix({E, nu, PlaneState::Stress, 1}) * strain;
    CHECK(stress_across({E, nu, PlaneState::Stress, 1}, stress) == 0);
    CHECK((stress(0) - nu * stress(1)) / E == Approx(strain(0)).epsilon(1e-13));
    CHECK((stress(1) - nu * stress(0)) / E == Approx(strain(1)).epsilon(1e-13));
    CHECK(stress(2) * 2 * (1 + nu) / E == Approx(strain(2)).epsilon(1e-13));
  }
}

TEST_CASE("plane strain is plane stress with E/(1-nu^2) and nu/(1-nu)", "[material]") {
  const double nu = 0.25;
  const Eigen::Matrix3d strain = elasticity_matrix({7, nu, PlaneState::Strain, 1});
  const Eigen::Matrix3d stress =
      elasticity_matrix({7 / (1 - nu * nu), nu / (1 - nu), PlaneState::Stress, 1});
  CHECK((strain - stress).norm() < 1e-13 * strain.norm());
}

TEST_CASE("a constant out of range is named with the value that was given", "[material]") {
  CHECK_THAT(complaint(-1, 0.3, PlaneState::Strain),
             ContainsSubstring("Young's modulus must be positive, got -1"));
  CHECK_THAT(complaint(0, 0.3, PlaneState::Strain), ContainsSubstring("Young's modulus"));
  CHECK_THAT(complaint(std::numeric_limits<double>::infinity(), 0.3, PlaneState::Strain),
             ContainsSubstring("Young's modulus"));
  CHECK_THAT(complaint(1, -1, PlaneState::Strain), ContainsSubstring("Poisson's ratio"));
  CHECK_THAT(complaint(1, 0.51, PlaneState::Stress), ContainsSubstring("got 0.51"));
  CHECK_THAT(complaint(1, std::numeric_limits<double>::quiet_NaN(), PlaneState::Stress),
             ContainsSubstring("Poisson's ratio"));
  CHECK_THAT(complaint(1, 0.3, PlaneState::Strain, 0),
             ContainsSubstring("thickness must be positive, got 0"));
}

TEST_CASE("an incompressible body in plane strain is sent to the element that can bear it",
          "[material]") {
  CHECK_THAT(complaint(1, 0.5, PlaneState::Strain),
             ContainsSubstring("0.5 in plane strain") && ContainsSubstring("q4_bbar"));
  CHECK(complaint(1, 0.5, PlaneState::Stress).empty());
  CHECK(complaint(1, 0.4999, PlaneState::Strain).empty());
  CHECK(elasticity_matrix({1, 0.4999, PlaneState::Strain, 1}).allFinite());
}

TEST_CASE("the elasticity matrix is never made from a bad material", "[material]") {
  CHECK_THROWS_AS(elasticity_matrix({1, 0.5, PlaneState::Strain, 1}), signorini::ProblemError);
}

TEST_CASE("in axial symmetry all three stretches count alike, and shear apart", "[material]") {
  const signorini::Material steel{210, 0.3, PlaneState::Axial, 1};
  const Eigen::Matrix4d D = elasticity_matrix(steel);
  CHECK(D == D.transpose());
  const Eigen::Matrix4d compliance = D.inverse();
  for (const int i : {0, 1, 3})
    for (const int k : {0, 1, 3})
      CHECK(compliance(i, k) == Approx((i == k ? 1 : -0.3) / 210).epsilon(1e-13));
  CHECK(compliance(2, 2) == Approx(2.6 / 210).epsilon(1e-13));
  const Eigen::Matrix3d plane = elasticity_matrix({210, 0.3, PlaneState::Strain, 1});
  CHECK(D.topLeftCorner<3, 3>() == plane);
  CHECK_THROWS_AS(stress_across(steel, {1, 2, 3}), std::invalid_argument);
  CHECK_THAT(complaint(210, 0.3, PlaneState::Axial, 0.5), ContainsSubstring("no thickness"));
  CHECK_THAT(complaint(210, 0.5, PlaneState::Axial), ContainsSubstring("incompressible"));
}

TEST_CASE("the depth is a thickness, or the circle around the axis", "[material]") {
  const signorini::Depth sheet = signorini::depth_of({1, 0, PlaneState::Stress, 0.25});
  CHECK(sheet.at(-7) == 0.25);
  CHECK(sheet.part(-7) == 1);
  const signorini::Depth round = signorini::depth_of({1, 0, PlaneState::Axial, 1});
  CHECK(round.at(0) == 0);
  CHECK(round.at(3) == Approx(18.849555921538759).epsilon(1e-15));
}
