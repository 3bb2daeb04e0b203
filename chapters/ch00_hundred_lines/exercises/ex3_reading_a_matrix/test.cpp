#include "../chapters/ch00_hundred_lines/finite_elements.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using Nodes = std::vector<Eigen::Index>;

static ch00::SparseMatrix two_squares() {
  return ch00::assemble(ch00::rectangle(2, 1, 2, 1), ch00::plane_stress(1, 0));
}

TEST_CASE("ex0.3 figure 0.2", "[ex0.3]") {
  const ex0_3::Reading one = ex0_3::read_matrix(two_squares(), 0);
  CHECK(one.pieces == 1);
  CHECK(one.partners == Nodes{1, 3, 4});
  CHECK(!one.holds_x);
  CHECK(!one.holds_y);
  CHECK(ex0_3::read_matrix(two_squares(), 1).partners == Nodes{0, 2, 3, 4, 5});
}

TEST_CASE("ex0.3 a spring to the ground at one node, along y", "[ex0.3]") {
  ch00::SparseMatrix K = two_squares();
  K.coeffRef(7, 7) += 0.01;
  const ex0_3::Reading held = ex0_3::read_matrix(K, 2);
  CHECK(!held.holds_x);
  CHECK(held.holds_y);
  CHECK(held.partners == Nodes{1, 4, 5});
}
