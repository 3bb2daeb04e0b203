// What chapter 19 says of its five methods.
#include "../chapters/ch19_field/error.hpp"
#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"

using namespace ch19;

namespace {

// Of the flat block, which is a bar in plane strain that may widen [N/mm^3], [N/mm^2].
const double stiff = 10 / (1 - 0.3 * 0.3) / height;
const double pressure = 0.75 * stiff;

double share(const Answer& answer) { return answer.force.sum() / (pressure * width); }

double largest_eigenvalue(const MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix).eigenvalues().maxCoeff();
}

}  // namespace

TEST_CASE("active set and Nitsche give the uniform pressure of the flat block",
          "[penalty][patch-test]") {
  const Pressed block = on_flat(3);
  const Answer exact = active_set(block, compliance(block));
  CHECK(exact.ended);
  CHECK((exact.force - pressure * block.weight).norm() < 1e-12 * exact.force.norm());
  const double bound = inverse_inequality(block);
  for (const double times : {1.01, 3.0, 100.0, 1e4}) {
    const Answer now = nitsche(block, times * bound);
    CAPTURE(times);
    CHECK(now.ended);
    CHECK(share(now) == Approx(1).epsilon(1e-9));
    CHECK(difference(block, now.u, exact.u) < 1e-9);
  }
}

TEST_CASE("a penalty lets the base in by pressure over stiffness", "[penalty][closed-form]") {
  const Pressed block = on_flat(3);
  for (const double epsilon : {1e-3 * stiff, stiff, 1e3 * stiff, 1e6 * stiff}) {
    const Answer now = penalty(block, epsilon);
    const double p = 0.75 / (1 / stiff + 1 / epsilon);  // two springs in a row
    CAPTURE(epsilon);
    CHECK(now.force.sum() == Approx(p * width).epsilon(1e-9));
    const VectorXd gap = block.free_gap + opening(block, now.u);
    CHECK(gap.maxCoeff() == Approx(-p / epsilon).epsilon(1e-7));
    CHECK(gap.minCoeff() == Approx(-p / epsilon).epsilon(1e-7));
  }
}

TEST_CASE(
    "each pass of Uzawa multiplies the error by 1 - rho G, of the augmented Lagrangian by 1/(1 + "
    "epsilon G)",
    "[penalty][closed-form]") {
  const Pressed block = on_flat(2);
  const MatrixXd G = compliance(block);
  for (const double times : {0.5, 1.0, 1.6})
    for (const Index passes : {1, 2, 5}) {
      CAPTURE(times, passes);
      const double left = std::pow(1 - times, double(passes));
      CHECK(share(uzawa(block, G, times * stiff, passes)) == Approx(1 - left).epsilon(1e-10));
      const double held = std::pow(1 / (1 + times), double(passes));
      CHECK(share(augmented_lagrangian(block, times * stiff, passes)) ==
            Approx(1 - held).epsilon(1e-10));
    }
}

TEST_CASE("Uzawa ends below 2 over the largest compliance of the closed pairs, and not above",
          "[penalty][exact]") {
  const Pressed block = on_round(4);
  const MatrixXd G = compliance(block);
  const Answer exact = active_set(block, G);
  std::vector<Index> closed;
  for (Index i = 0; i < exact.force.size(); ++i)
    if (exact.force(i) > 0) closed.push_back(i);
  REQUIRE(closed.size() > 1);
  const VectorXd root = block.weight.cwiseSqrt();
  const MatrixXd scaled = root.asDiagonal() * G * root.asDiagonal();
  const double limit = 2 / largest_eigenvalue(scaled(closed, closed));
  const Answer below = uzawa(block, G, 0.9 * limit);
  CHECK(below.ended);
  CHECK((below.force - exact.force).norm() < 1e-8 * exact.force.norm());
  CHECK(!uzawa(block, G, 1.05 * limit).ended);
}

TEST_CASE(
    "the augmented Lagrangian ends at the active set for every stiffness; a penalty is off by a "
    "tenth per decade",
    "[penalty][exact]") {
  const Pressed block = on_round(4);
  const Answer exact = active_set(block, compliance(block));
  double last = 0;
  for (const double parameter : {10.0, 100.0, 1000.0}) {
    CAPTURE(parameter);
    const Answer answer = augmented_lagrangian(block, parameter * block.unit);
    CHECK(answer.ended);
    CHECK(difference(block, answer.u, exact.u) < 1e-9);
    const double off = difference(block, penalty(block, parameter * block.unit).u, exact.u);
    if (last > 0) CHECK(off == Approx(last / 10).epsilon(0.1));
    last = off;
  }
}

TEST_CASE("Nitsche's matrix is positive definite above the bound, and not far below it",
          "[penalty][exact]") {
  const Pressed block = on_round(4);
  const std::vector<SidePoint> points = side_points(block);
  const double bound = inverse_inequality(block);
  const Sets none = Sets::Constant(Index(points.size()), false);
  const auto least = [&](double gamma) {
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(
               MatrixXd(nitsche_matrix(block, points, gamma, none)))
        .eigenvalues()(0);
  };
  CHECK(least(bound) > 0);
  CHECK(least(0.5 * bound) < 0);
}

TEST_CASE(
    "Nitsche's error does not depend on its parameter, and falls with the mesh as the active set's",
    "[penalty][convergence]") {
  const Reference fine = reference(32);
  const Pressed block = on_round(4), finer = on_round(8);
  const Answer ten = nitsche(finer, 10 * finer.unit);
  const double at_ten = fine.error(finer, ten.u);
  for (const double parameter : {30.0, 1000.0, 1e4}) {
    CAPTURE(parameter);
    const Answer now = nitsche(finer, parameter * finer.unit);
    CHECK(difference(finer, now.u, ten.u) < at_ten / 5);
    // Squares add up: a fifth more would be 1/2 (1/5)^2.
    CHECK(fine.error(finer, now.u) == Approx(at_ten).epsilon(0.02));
  }
  const double ratio = fine.error(block, nitsche(block, 10 * block.unit).u) / at_ten;
  const double of_set = fine.error(block, active_set(block, compliance(block)).u) /
                        fine.error(finer, active_set(finer, compliance(finer)).u);
  // Energy of linear elements: order 1. In the end the glued corners allow about 0.71 only.
  for (const double fall : {ratio, of_set}) CHECK(std::abs(std::log2(fall) - 1) < 0.25);
}

// The strain of a Gauss point's row is the one of a uniform strain.
TEST_CASE("the pressure of the base is minus sigma_yy of a uniform strain", "[penalty][exact]") {
  const Pressed block = on_round(3);
  NodeArray nodal(block.mesh.n_nodes(), 2);
  for (Index node = 0; node < nodal.rows(); ++node)
    nodal.row(node) << 0.01 * block.mesh.nodes(node, 0), -0.02 * block.mesh.nodes(node, 1);
  const VectorXd u = restricted(block.unknowns, nodal);
  const Eigen::Vector3d sigma = elasticity_matrix(rubber) * Eigen::Vector3d(0.01, -0.02, 0);
  for (const SidePoint& at : side_points(block))
    CHECK(at.pressure.dot(of_cell(at, u)) == Approx(-sigma(1)).epsilon(1e-12));
}
