#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "meshes/split.hpp"
#include "meshes/block.hpp"
#include "support/message.hpp"

using Eigen::Index;
using signorini::check_mesh;
using signorini::Mesh;
using signorini::MeshOrder;
using signorini_test::problem_message;

namespace {

Mesh plate(MeshOrder order = MeshOrder::Linear) {
  return signorini::block("plate", {0, 0}, {3, 2}, 3, 2, order);
}

std::string complaint(const Mesh& mesh) {
  return problem_message([&] { check_mesh(mesh); });
}

}  // namespace

TEST_CASE("a sound mesh is accepted and measured", "[mesh]") {
  const signorini::MeshQuality square = check_mesh(plate());
  CHECK(square.smallest_jacobian_ratio == Approx(1).epsilon(1e-14).margin(0));
  CHECK(square.largest_aspect_ratio == Approx(1).epsilon(1e-14).margin(0));
}

TEST_CASE("the quality figures of one trapezium are those of its corners and sides", "[mesh]") {
  Mesh mesh;
  mesh.nodes.resize(4, 2);
  mesh.nodes << 0, 0, 4, 0, 4, 1, 0, 3;  // corner triangles of area 6, 2, 2, 6; sides 4, 1, 4.47, 3
  mesh.cells.resize(1, 4);
  mesh.cells << 0, 1, 2, 3;
  const signorini::MeshQuality quality = check_mesh(mesh);
  CHECK(quality.smallest_jacobian_ratio == Approx(1.0 / 3.0).epsilon(1e-14).margin(0));
  CHECK(quality.largest_aspect_ratio == Approx(std::sqrt(20.0)).epsilon(1e-14).margin(0));
}

TEST_CASE("an inverted cell is named by its number", "[mesh]") {
  Mesh mesh = plate();
  mesh.cells.row(4) = mesh.cells.row(4).reverse().eval();
  CHECK_THAT(complaint(mesh), ContainsSubstring("'plate'") &&
                                  ContainsSubstring("cell 4 is inverted") &&
                                  ContainsSubstring("clockwise"));
}

TEST_CASE("a degenerate cell is named by its number", "[mesh]") {
  Mesh mesh = plate();
  SECTION("two corners in one place") {
    mesh.nodes.row(mesh.cells(5, 2)) = mesh.nodes.row(mesh.cells(5, 3));
    mesh.boundaries.clear();
  }
  SECTION("a corner of 180 degrees") {
    mesh.nodes.row(mesh.cells(5, 2)) =
        0.5 * (mesh.nodes.row(mesh.cells(5, 1)) + mesh.nodes.row(mesh.cells(5, 3)));
  }
  SECTION("an arrowhead") { mesh.nodes.row(mesh.cells(5, 2)) << 2.3, 1.3; }
  CHECK_THAT(complaint(mesh), ContainsSubstring("cell 5 is degenerate"));
}

TEST_CASE("a cell far from the origin is not taken for a degenerate one", "[mesh]") {
  Mesh mesh = plate();
  mesh.nodes.array() += 1e6;
  CHECK_NOTHROW(check_mesh(mesh));
}

// The cells are 1 high, so that coordinates may be rounded to 1e-6: 1e-6 / epsilon = 4.5e9.
TEST_CASE("a mesh whose coordinates are rounded to more than a millionth of a cell is refused",
          "[mesh]") {
  for (const Eigen::RowVector2d& way : {Eigen::RowVector2d(1, 0), Eigen::RowVector2d(0, -1)})
    for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
      Mesh mesh = plate(order);
      mesh.nodes.rowwise() += 4e9 * way;
      CHECK_NOTHROW(check_mesh(mesh));
      mesh.nodes.rowwise() += 1e9 * way;
      CHECK_THAT(complaint(mesh), ContainsSubstring("'plate' has lost its digits") &&
                                      ContainsSubstring("the height of cell 0, which is 1") &&
                                      ContainsSubstring("Move the bodies near the origin"));
      mesh.nodes.rowwise() += 1e20 * way;  // all in one place
      CHECK_THAT(complaint(mesh), ContainsSubstring("has lost its digits"));
    }
}

TEST_CASE("cells may be thin where a move would give them no more digits", "[mesh]") {
  Mesh mesh = plate();
  mesh.nodes.col(1) *= 1e-9;
  CHECK_NOTHROW(check_mesh(mesh));
  mesh.nodes.col(0).array() -= 1.5;
  CHECK_NOTHROW(check_mesh(mesh));
  mesh.nodes.col(1).array() += 1e3;
  CHECK_THAT(complaint(mesh), ContainsSubstring("has lost its digits"));
}

TEST_CASE("a node that does not exist is named with its cell", "[mesh]") {
  Mesh mesh = plate();
  mesh.cells(2, 1) = 12;
  CHECK_THAT(complaint(mesh),
             ContainsSubstring("cell 2 refers to node 12") && ContainsSubstring("0 to 11"));
  mesh.cells(2, 1) = -1;
  CHECK_THAT(complaint(mesh), ContainsSubstring("cell 2 refers to node -1"));
}

TEST_CASE("a boundary side of zero length is named with its boundary", "[mesh]") {
  Mesh mesh = plate();
  const std::vector<Index> side = mesh.side_nodes(mesh.boundaries.at("right")[1]);
  mesh.nodes.row(side.back()) = mesh.nodes.row(side.front());
  CHECK_THAT(complaint(mesh), ContainsSubstring("side 1 of the boundary 'right'") &&
                                  ContainsSubstring("zero length"));
}

TEST_CASE("a midside node far from the middle is named with its cell and side", "[mesh]") {
  Mesh mesh = plate(MeshOrder::Quadratic);
  CHECK_NOTHROW(check_mesh(mesh));
  const Index middle = mesh.cells(0, 4);  // from (0, 0) to (1, 0)
  mesh.nodes(middle, 0) = 0.7;
  CHECK_NOTHROW(check_mesh(mesh));
  mesh.nodes(middle, 0) = 0.8;
  CHECK_THAT(complaint(mesh), ContainsSubstring("cell 0") && ContainsSubstring("side 0 at 0.8"));
}

TEST_CASE("cells of five nodes and positions that are not finite are refused", "[mesh]") {
  Mesh mesh = plate();
  mesh.nodes(3, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(complaint(mesh), ContainsSubstring("not finite"));
  mesh = plate();
  mesh.cells.conservativeResizeLike(signorini::CellArray::Zero(mesh.n_cells(), 5));
  CHECK_THAT(complaint(mesh), ContainsSubstring("3 or 4 nodes, or 6 or 8, got 5"));
}

TEST_CASE("triangles stand alone, or beside quadrilaterals with -1 after their nodes", "[mesh]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    const Index per_corner = order == MeshOrder::Linear ? 1 : 2;
    const Mesh whole = plate(order);
    const Mesh mixed = signorini::split(whole, {0, 5});
    const Mesh triangles = signorini::split(whole);
    CHECK(whole.cell_size(1) == 4 * per_corner);
    CHECK(mixed.cells.cols() == 4 * per_corner);
    CHECK(triangles.cells.cols() == 3 * per_corner);
    CHECK(mixed.corners(0) == 3);
    CHECK(mixed.corners(2) == 4);
    CHECK(mixed.cell_size(0) == 3 * per_corner);
    for (const Mesh& mesh : {mixed, triangles}) {
      CHECK(mesh.order() == order);
      CHECK_NOTHROW(check_mesh(mesh));
      for (const auto& [name, sides] : mesh.boundaries)
        CHECK(signorini::boundary_nodes(mesh, name) == signorini::boundary_nodes(whole, name));
    }
    Mesh wrong = mixed;
    wrong.cells(1, 3 * per_corner) = -2;
    CHECK_THAT(complaint(wrong), ContainsSubstring("cell 1, a triangle in rows of") &&
                                     ContainsSubstring("must have -1 after its"));
    wrong = mixed;
    wrong.cells(2, 0) = -1;
    CHECK_THAT(complaint(wrong), ContainsSubstring("cell 2 refers to node -1"));
    wrong = mixed;
    wrong.boundaries["bottom"].front().side = 3;
    CHECK_THAT(complaint(wrong),
               ContainsSubstring("side 3 of cell 0") && ContainsSubstring("with sides 0 to 2"));
    wrong = mixed;
    wrong.cells.row(0).head(3).reverseInPlace();
    CHECK_THAT(complaint(wrong),
               ContainsSubstring("cell 0 is inverted") && ContainsSubstring("clockwise"));
  }
}

// Height 0.1 on the longest side of 2; and three equal sides.
TEST_CASE("a triangle is as slender as its height is small beside its longest side", "[mesh]") {
  Mesh mesh;
  mesh.nodes.resize(3, 2);
  mesh.nodes << 0, 0, 2, 0, 1, 0.1;
  mesh.cells.resize(1, 3);
  mesh.cells << 0, 1, 2;
  CHECK(check_mesh(mesh).smallest_jacobian_ratio == Approx(1).epsilon(1e-14));
  CHECK(check_mesh(mesh).largest_aspect_ratio ==
        Approx(20 * std::sqrt(0.75)).epsilon(1e-13).margin(0));
  mesh.nodes.row(2) << 1, std::sqrt(3.0);
  CHECK(check_mesh(mesh).largest_aspect_ratio == Approx(1).epsilon(1e-13).margin(0));
  mesh.nodes.row(2) << 1, 0;
  CHECK_THAT(complaint(mesh), ContainsSubstring("cell 0 is degenerate"));
}

TEST_CASE("an unknown boundary is answered with those that exist", "[mesh]") {
  const std::string message =
      problem_message([] { static_cast<void>(signorini::boundary(plate(), "lower")); });
  CHECK_THAT(message, ContainsSubstring("'plate' has no boundary 'lower'") &&
                          ContainsSubstring("bottom, left, right, top"));
  Mesh bare = plate();
  bare.boundaries.clear();
  CHECK_THAT(problem_message([&] { static_cast<void>(signorini::boundary_nodes(bare, "left")); }),
             ContainsSubstring("it has: none"));
}

TEST_CASE("the nodes of a side come in walking order, the midpoint between", "[mesh]") {
  const Mesh mesh = plate(MeshOrder::Quadratic);
  for (int side = 0; side < 4; ++side) {
    const std::vector<Index> nodes = mesh.side_nodes({3, side});
    REQUIRE(nodes.size() == 3);
    CHECK(nodes[0] == mesh.cells(3, side));
    CHECK(nodes[1] == mesh.cells(3, 4 + side));
    CHECK(nodes[2] == mesh.cells(3, (side + 1) % 4));
  }
  CHECK(plate().side_nodes({3, 3}) == std::vector<Index>{plate().cells(3, 3), plate().cells(3, 0)});
}

TEST_CASE("a boundary is walked along and meets every node once", "[mesh]") {
  const Mesh mesh = plate(MeshOrder::Quadratic);
  const std::vector<Index> nodes = signorini::boundary_nodes(mesh, "top");
  REQUIRE(nodes.size() == 7);
  for (std::size_t k = 0; k < 7; ++k)
    CHECK(mesh.nodes(nodes[k], 0) == Approx(3 - 0.5 * static_cast<double>(k)).margin(1e-14));
}
