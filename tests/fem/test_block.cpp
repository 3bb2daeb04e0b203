#include <limits>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "support/message.hpp"

using Eigen::Index;
using signorini::BlockSpec;
using signorini::make_block;
using signorini::Mesh;
using signorini::MeshOrder;
using signorini_test::argument_message;

namespace {

BlockSpec spec_of(MeshOrder order) {
  BlockSpec spec;
  spec.corner = {1, -2};
  spec.size = {6, 3};
  spec.cells_x = 4;
  spec.cells_y = 3;
  spec.order = order;
  return spec;
}

/// Area from the corners of all cells.
double area_of(const Mesh& mesh) {
  double area = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int k = 0; k < 4; ++k) {
      const Eigen::RowVector2d a = mesh.nodes.row(mesh.cells(cell, k));
      const Eigen::RowVector2d b = mesh.nodes.row(mesh.cells(cell, (k + 1) % 4));
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  return area;
}

}  // namespace

TEST_CASE("a block has the nodes and cells that its division asks for", "[block]") {
  const Mesh linear = make_block(spec_of(MeshOrder::Linear));
  CHECK(linear.n_nodes() == 5 * 4);
  CHECK(linear.n_cells() == 12);
  CHECK(linear.cells.cols() == 4);
  const Mesh quadratic = make_block(spec_of(MeshOrder::Quadratic));
  CHECK(quadratic.n_nodes() == 9 * 4 + 5 * 3);  // full rows, and rows of midside nodes between them
  CHECK(quadratic.n_cells() == 12);
  CHECK(quadratic.cells.cols() == 8);
}

TEST_CASE("a block of equal cells takes one line", "[block]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    BlockSpec spec = spec_of(order);
    spec.name = "plinth";
    const Mesh mesh = signorini::block("plinth", {1, -2}, {6, 3}, 4, 3, order);
    CHECK(mesh.name == "plinth");
    CHECK(mesh.nodes == make_block(spec).nodes);
    CHECK(mesh.cells == make_block(spec).cells);
  }
}

TEST_CASE("the cells of a block run counter-clockwise and fill the rectangle", "[block]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    BlockSpec spec = spec_of(order);
    spec.grading_x = 5;
    spec.grading_y = 0.2;
    const Mesh mesh = make_block(spec);
    CHECK(area_of(mesh) == Approx(18).epsilon(1e-14).margin(0));  // clockwise cells count negative
    CHECK(mesh.nodes.colwise().minCoeff() == Eigen::RowVector2d(1, -2));
    CHECK((mesh.nodes.colwise().maxCoeff() - Eigen::RowVector2d(7, 1)).norm() < 1e-14);
    CHECK_NOTHROW(signorini::check_mesh(mesh));
  }
}

TEST_CASE("every node of a block belongs to a cell and no two lie in one place", "[block]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    const Mesh mesh = make_block(spec_of(order));
    for (Index node = 0; node < mesh.n_nodes(); ++node) {
      CAPTURE(node);
      CHECK((mesh.cells.array() == node).any());
      for (Index other = 0; other < node; ++other)
        CHECK((mesh.nodes.row(node) - mesh.nodes.row(other)).norm() > 0.1);
    }
  }
}

TEST_CASE("the boundary of a block runs counter-clockwise with the body on its left", "[block]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    const Mesh mesh = make_block(spec_of(order));
    const Eigen::RowVector2d middle(4, -0.5);
    Index before = mesh.side_nodes(mesh.boundaries.at("left").back()).back();
    for (const char* name : {"bottom", "right", "top", "left"})
      for (const signorini::CellSide& side : mesh.boundaries.at(name)) {
        CAPTURE(name, side.cell);
        const std::vector<Index> nodes = mesh.side_nodes(side);
        CHECK(nodes.front() == before);  // one closed walk
        before = nodes.back();
        const Eigen::RowVector2d a = mesh.nodes.row(nodes.front());
        const Eigen::RowVector2d along = mesh.nodes.row(nodes.back()) - a;
        const Eigen::RowVector2d to_middle = middle - a;
        CHECK(along.x() * to_middle.y() - along.y() * to_middle.x() > 0);
      }
  }
}

TEST_CASE("the boundaries of a block lie where their names say", "[block]") {
  const Mesh mesh = make_block(spec_of(MeshOrder::Quadratic));
  const auto all_at = [&](const char* name, int axis, double place) {
    for (const Index node : signorini::boundary_nodes(mesh, name))
      if (mesh.nodes(node, axis) != place) return false;
    return true;
  };
  CHECK(all_at("left", 0, 1));
  CHECK(all_at("right", 0, 7));
  CHECK(all_at("bottom", 1, -2));
  CHECK(all_at("top", 1, 1));
  CHECK(signorini::boundary_nodes(mesh, "bottom").size() == 9);
  CHECK(signorini::boundary_nodes(mesh, "left").size() == 7);
}

TEST_CASE("grading is the last cell over the first and steps form a geometric row", "[block]") {
  for (const double grading : {1.0, 8.0, 0.125}) {
    CAPTURE(grading);
    const Eigen::VectorXd x = signorini::graded_steps(7, grading);
    REQUIRE(x.size() == 8);
    CHECK(x(0) == 0);
    CHECK(x(7) == 1);
    const Eigen::VectorXd step = x.tail(7) - x.head(7);
    CHECK(step(6) / step(0) == Approx(grading).epsilon(1e-12).margin(0));
    for (int k = 1; k < 6; ++k)
      CHECK(step(k) * step(k) == Approx(step(k - 1) * step(k + 1)).epsilon(1e-12).margin(0));
  }
  CHECK(signorini::graded_steps(1, 100)(1) == 1);  // one cell: nothing to grade
}

TEST_CASE("midside nodes lie in the middle of their sides, also in graded blocks", "[block]") {
  BlockSpec spec = spec_of(MeshOrder::Quadratic);
  spec.grading_x = 3;
  spec.grading_y = 0.5;
  const Mesh mesh = make_block(spec);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int side = 0; side < 4; ++side) {
      CAPTURE(cell, side);
      const Eigen::RowVector2d middle = 0.5 * (mesh.nodes.row(mesh.cells(cell, side)) +
                                               mesh.nodes.row(mesh.cells(cell, (side + 1) % 4)));
      CHECK((mesh.nodes.row(mesh.cells(cell, 4 + side)) - middle).norm() < 1e-14);
    }
}

TEST_CASE("a block that cannot be made is refused by name", "[block]") {
  const auto message = [](auto&& change) {
    BlockSpec spec;
    spec.name = "plate";
    change(spec);
    return argument_message([&] { static_cast<void>(make_block(spec)); });
  };
  CHECK_THAT(
      message([](BlockSpec& s) { s.size.x() = 0; }),
      ContainsSubstring("'plate'") && ContainsSubstring("width and height must be positive"));
  CHECK_THAT(message([](BlockSpec& s) { s.size.y() = -1; }), ContainsSubstring("must be positive"));
  CHECK_THAT(message([](BlockSpec& s) { s.cells_x = 0; }), ContainsSubstring("at least one cell"));
  CHECK_THAT(message([](BlockSpec& s) { s.grading_y = 0; }), ContainsSubstring("grading"));
  CHECK_THAT(message([](BlockSpec& s) { s.corner.x() = std::numeric_limits<double>::quiet_NaN(); }),
             ContainsSubstring("'plate'"));
}

TEST_CASE("mapping moves every node and nothing else", "[block]") {
  const Mesh before = make_block(spec_of(MeshOrder::Linear));
  const Mesh after = signorini::mapped(
      before, [](const Eigen::Vector2d& x) { return Eigen::Vector2d(2 * x.x(), x.y() + x.x()); });
  CHECK(after.cells == before.cells);
  CHECK(after.nodes.col(0) == 2 * before.nodes.col(0));
  CHECK(after.nodes.col(1) == before.nodes.col(0) + before.nodes.col(1));
}
