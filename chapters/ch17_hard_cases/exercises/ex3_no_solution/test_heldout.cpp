#include <limits>

#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::Vector3d;
using Eigen::VectorXd;
using ex17_3::find_proof;
using ex17_3::proves;
using signorini::ContactProblem;

// Rows b_i of a plane body, G = B B^T: any units of rows.
static ContactProblem rows(const Eigen::MatrixXd& B, const VectorXd& d, const VectorXd& unit) {
  const Eigen::MatrixXd C = unit.asDiagonal() * B;
  return {C * C.transpose(), unit.cwiseProduct(d)};
}

TEST_CASE("ex17.3 held out: rows in units of their own", "[ex17.3]") {
  Eigen::MatrixXd B(4, 2);
  B << 1, 0, 0, 3, -1, 0, 2, 1;
  for (const double unit : {1e-9, 0.3, 1e9}) {
    CAPTURE(unit);
    const VectorXd units = Eigen::Vector4d(1, unit, unit, 7);
    const ContactProblem narrow = rows(B, Eigen::Vector4d(1, -5, -1.001, -5), units);
    const VectorXd y = find_proof(narrow);
    REQUIRE(y.size() == 4);
    CHECK(proves(narrow, y));
    CHECK(y(1) == 0);
    CHECK(y(3) == 0);
    CHECK(find_proof(rows(B, Eigen::Vector4d(1, -5, -0.999, -5), units)).size() == 0);
  }
}

// Three half planes: no two of them contradict each other.
TEST_CASE("ex17.3 held out: a triangle needs all three", "[ex17.3]") {
  Eigen::MatrixXd B(3, 2);
  B << 1, 0, 0, 1, -1, -1;
  const ContactProblem triangle = rows(B, Vector3d(-1, -1, 1), Vector3d(1, 1, 1));
  CHECK(proves(triangle, Vector3d(2, 2, 2)));
  CHECK_FALSE(proves(triangle, Vector3d(1, 1, 1.0001)));
  CHECK(find_proof(triangle).size() == 0);
  CHECK_FALSE(proves(rows(B, Vector3d(-1, -1, 2), Vector3d(1, 1, 1)), Vector3d(1, 1, 1)));
}

TEST_CASE("ex17.3 held out: no numbers and no weights prove nothing", "[ex17.3]") {
  const ContactProblem slot{(Eigen::Matrix2d() << 1, -1, -1, 1).finished(), Eigen::Vector2d(-1, 0)};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(proves(slot, Eigen::Vector2d(1e-200, 1e-200)));
  CHECK_FALSE(proves(slot, Eigen::Vector2d(nan, nan)));
  CHECK_FALSE(proves(slot, Eigen::Vector2d(0, 0)));
  CHECK_FALSE(proves(slot, Eigen::Vector2d(1, nan)));
}
