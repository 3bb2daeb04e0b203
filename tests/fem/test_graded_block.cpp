#include <cmath>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "support/mesh_measures.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

TEST_CASE("stretches follow each other, each graded for itself, ends exact", "[graded]") {
  const VectorXd x = stretched(-1, {{0.1, 3, 1}, {1.5, 4, 8}, {15, 1, 5}});
  REQUIRE(x.size() == 9);
  CHECK(x(0) == -1);
  CHECK(x(3) == 0.1);
  CHECK(x(7) == 1.5);
  CHECK(x(8) == 15);
  const VectorXd step = x.tail(8) - x.head(8);
  CHECK(step(2) == Approx(step(0)).epsilon(1e-14).margin(0));
  CHECK(step(6) / step(3) == Approx(8).epsilon(1e-12).margin(0));
  CHECK(step(5) / step(4) == Approx(2).epsilon(1e-12).margin(0));
}

TEST_CASE("a grading is found from the first cell, growing, even or shrinking", "[graded]") {
  for (const double first : {1e-3, 0.1, 0.25, 0.4, 0.9}) {
    CAPTURE(first);
    const VectorXd x = graded_steps(4, grading_from(1, 4, first));
    CHECK(x(1) == Approx(first).epsilon(1e-13).margin(0));
  }
  CHECK(grading_from(8, 4, 2) == Approx(1).epsilon(1e-13).margin(0));
  CHECK(grading_from(7, 3, 1) == Approx(4).epsilon(1e-13).margin(0));  // 1 + 2 + 4
}

TEST_CASE("a graded block has its lines where they were given", "[graded]") {
  const MeshOrder order = GENERATE(MeshOrder::Linear, MeshOrder::Quadratic);
  const VectorXd x = stretched(1, {{2, 2, 1}, {9, 3, 4}});
  const VectorXd y = stretched(-3, {{0, 4, 0.2}});
  const Mesh mesh = make_graded_block("soil", x, y, order);
  CHECK(mesh.name == "soil");
  CHECK(area_of(mesh) == Approx(24).epsilon(1e-14).margin(0));
  CHECK(is_rim(mesh, {"bottom", "right", "top", "left"}));
  CHECK(mesh.n_nodes() == (order == MeshOrder::Linear ? 6 * 5 : 11 * 5 + 6 * 4));
  const std::vector<Index> bottom = boundary_nodes(mesh, "bottom");
  const std::size_t every = order == MeshOrder::Linear ? 1 : 2;
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(mesh.nodes(bottom[every * k], 0) == x(static_cast<Index>(k)));
}

TEST_CASE("a block of lines is the block of gradings", "[graded]") {
  BlockSpec spec;
  spec.corner = {1, -2};
  spec.size = {6, 3};
  spec.cells_x = 4;
  spec.cells_y = 3;
  spec.grading_x = 5;
  spec.grading_y = 0.5;
  const Mesh one = make_block(spec);
  const Mesh other = make_graded_block("block", stretched(1, {{7, 4, 5}}),
                                       stretched(-2, {{1, 3, 0.5}}), MeshOrder::Linear);
  CHECK(one.cells == other.cells);
  CHECK((one.nodes - other.nodes).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE("lines and stretches that do not increase are refused by number", "[graded]") {
  const auto message = [](double start, const std::vector<Stretch>& stretches) {
    return argument_message([&] { static_cast<void>(stretched(start, stretches)); });
  };
  CHECK_THAT(message(0, {}), ContainsSubstring("at least one stretch"));
  CHECK_THAT(message(0, {{2, 1, 1}, {2, 1, 1}}),
             ContainsSubstring("stretch 1 begins at 2 and must end beyond, got 2"));
  CHECK_THAT(message(0, {{2, 0, 1}}), ContainsSubstring("got 0 and 1"));
  CHECK_THAT(message(0, {{2, 1, -1}}), ContainsSubstring("got 1 and -1"));
  CHECK_THROWS_AS(grading_from(1, 1, 0.5), std::invalid_argument);
  CHECK_THROWS_AS(grading_from(1, 3, 1), std::invalid_argument);
  CHECK_THROWS_AS(grading_from(1, 3, 0), std::invalid_argument);
  const auto block_message = [](const VectorXd& x, const VectorXd& y) {
    return argument_message([&] { static_cast<void>(make_graded_block("soil", x, y)); });
  };
  const VectorXd good = VectorXd::LinSpaced(3, 0, 1);
  CHECK_THAT(block_message(good.head(1), good), ContainsSubstring("2 lines of x, got 1"));
  CHECK_THAT(block_message(good, Eigen::Vector3d(0, 2, 1)),
             ContainsSubstring("'soil': positions of y must increase, but number 2 is 1 after 2"));
}
