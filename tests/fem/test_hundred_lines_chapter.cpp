// What chapter 0 says of its own finite elements.
#include "../chapters/ch00_hundred_lines/patch_test.hpp"
#include "catch_compat.hpp"
#include "signorini/fem/assembly.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/elements.hpp"

using namespace ch00;

// By hand: the integrals of products of 1 - x, x, 1 - y, y and their slopes.
TEST_CASE("the matrix of the unit square is the one of paper and pencil", "[elements][exact]") {
  const ch00::Mesh square = rectangle(1, 1, 1, 1);
  const ElementMatrix K =
      24 * element_stiffness(square.nodes(square.cells.row(0), Eigen::all), plane_stress(1, 0));
  Eigen::Matrix<double, 1, 8> first;
  first << 12, 3, -6, -3, -6, -3, 0, 3;
  CHECK((K.row(0) - first).norm() < 1e-13);
  CHECK((K - K.transpose()).norm() < 1e-13);
}

TEST_CASE("K of the hundred lines is the library's, on crooked cells", "[elements][exact]") {
  const ch00::Mesh mesh = crooked_patch();
  signorini::Mesh same = signorini::block("patch", {0, 0}, {3, 3}, 3, 3);
  REQUIRE(same.cells == mesh.cells);
  same.nodes = mesh.nodes;
  const double nu = GENERATE(0.0, 0.3, 0.49);
  const signorini::Material material{7, nu, signorini::PlaneState::Stress};
  const SparseMatrix theirs =
      signorini::assemble(same, signorini::q4(), material,
                          signorini::number_unknowns(same, {}), {})
          .stiffness;
  const SparseMatrix ours = ch00::assemble(mesh, plane_stress(7, nu));
  CHECK((ours - theirs).norm() < 1e-14 * ours.norm());
}

TEST_CASE("a uniform strain goes through crooked cells", "[elements][patch-test]") {
  const ch00::Mesh mesh = crooked_patch();
  Matrix2d F;
  F << 0.1, 0.06, 0.02, -0.05;
  CHECK(patch_error(mesh, patch_test(mesh, plane_stress(10, 0.3), F), F) < 1e-14);
}

TEST_CASE("motions without strain need no force, and any other does", "[elements][exact]") {
  const SparseMatrix K = ch00::assemble(crooked_patch(), plane_stress(10, 0.3));
  const auto values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
  CHECK(values.head(3).cwiseAbs().maxCoeff() < 1e-12 * values.maxCoeff());
  CHECK(values(3) > 1e-3 * values.maxCoeff());
}

TEST_CASE("a bar that is pulled: p L / E and -nu p H / E", "[elements][closed-form]") {
  const ch00::Mesh mesh = rectangle(40, 20, 5, 3);
  Held held{{1, 0}};  // the lower left corner does not move up
  std::vector<Index> right;
  for (Index node = 0; node < mesh.nodes.rows(); ++node) {
    if (mesh.nodes(node, 0) == 0) held[2 * node] = 0;
    if (mesh.nodes(node, 0) == 40) right.push_back(node);
  }
  const double E = 10, nu = 0.3, p = 2;
  const VectorXd u =
      solve(ch00::assemble(mesh, plane_stress(E, nu)), side_load(mesh, right, p, 0), held);
  const Index corner = mesh.nodes.rows() - 1;
  CHECK(u(2 * corner) == Approx(p * 40 / E).epsilon(1e-12));
  CHECK(u(2 * corner + 1) == Approx(-nu * p * 20 / E).epsilon(1e-12));
}

TEST_CASE("a displacement that is given is kept, and its force balances the load",
          "[elements][exact]") {
  const ch00::Mesh mesh = rectangle(3, 2, 3, 2);
  const SparseMatrix K = ch00::assemble(mesh, plane_stress(5, 0.25));
  Held held;
  for (Index node = 0; node < 4; ++node) held[2 * node] = held[2 * node + 1] = 0.01 * double(node);
  const VectorXd load = side_load(mesh, {8, 9, 10, 11}, 0.3, -0.7);
  const VectorXd u = solve(K, load, held);
  for (const auto& [unknown, displacement] : held) CHECK(u(unknown) == displacement);
  Eigen::Vector2d reaction(0, 0);
  const VectorXd rest = K * u - load;
  for (Index node = 0; node < mesh.nodes.rows(); ++node) {
    if (node >= 4) CHECK(rest.segment<2>(2 * node).norm() < 1e-13);
    reaction += rest.segment<2>(2 * node);
  }
  CHECK((reaction + 3 * Eigen::Vector2d(0.3, -0.7)).norm() < 1e-13);
}
