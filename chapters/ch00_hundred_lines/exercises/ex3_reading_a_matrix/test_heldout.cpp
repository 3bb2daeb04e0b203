#include "../chapters/ch00_hundred_lines/finite_elements.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using Nodes = std::vector<Eigen::Index>;

TEST_CASE("ex0.3 held out: two bodies in one matrix, and a node that belongs to neither",
          "[ex0.3]") {
  ch00::Mesh mesh = ch00::rectangle(3, 1, 3, 1);
  Eigen::Matrix<Eigen::Index, Eigen::Dynamic, 4> outer(2, 4);
  outer << mesh.cells.row(0), mesh.cells.row(2);
  mesh.cells = outer;
  mesh.nodes.conservativeResize(9, 2);
  mesh.nodes.row(8) << 9, 9;
  const ch00::SparseMatrix K = ch00::assemble(mesh, ch00::plane_stress(7, 0.3));
  CHECK(ex0_3::read_matrix(K, 0).pieces == 3);
  CHECK(ex0_3::read_matrix(K, 0).partners == Nodes{1, 4, 5});
  CHECK(ex0_3::read_matrix(K, 8).partners == decltype(ex0_3::read_matrix(K, 8).partners){});
}

TEST_CASE("ex0.3 held out: entries that are stored and zero join nothing", "[ex0.3]") {
  ch00::SparseMatrix K = ch00::assemble(ch00::rectangle(2, 1, 2, 1), ch00::plane_stress(1, 0));
  K.coeffRef(0, 4) = 0;
  K.coeffRef(4, 0) = 0;
  CHECK(ex0_3::read_matrix(K, 0).partners == Nodes{1, 3, 4});
  K.coeffRef(0, 5) = 1e-9;
  K.coeffRef(5, 0) = 1e-9;
  CHECK(ex0_3::read_matrix(K, 0).partners == Nodes{1, 2, 3, 4});
}

TEST_CASE("ex0.3 held out: the same in any unit, on a mesh with rounding", "[ex0.3]") {
  for (const double unit : {1e-9, 1.0, 1e12}) {
    ch00::SparseMatrix K =
        ch00::assemble(ch00::rectangle(0.7, 1.3, 7, 9), ch00::plane_stress(0.3 * unit, 0.31));
    CAPTURE(unit);
    CHECK(!ex0_3::read_matrix(K, 5).holds_x);
    CHECK(!ex0_3::read_matrix(K, 5).holds_y);
    K.coeffRef(10, 10) *= 1 + 1e-6;
    CHECK(ex0_3::read_matrix(K, 5).holds_x);
    CHECK(ex0_3::read_matrix(K, 30).partners.size() == 8);
  }
}
