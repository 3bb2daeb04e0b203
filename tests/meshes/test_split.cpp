// Quadrilaterals cut into triangles.
#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "meshes/regions.hpp"
#include "meshes/reshape.hpp"
#include "meshes/split.hpp"
#include "support/half_disc.hpp"
#include "support/mesh_measures.hpp"

using Eigen::Index;
using Eigen::RowVector2d;
using namespace signorini;
using namespace signorini_test;

TEST_CASE("what is cut keeps its area, its rim and its nodes", "[split]") {
  const MeshOrder order = any_order();
  const Mesh whole = half_disc(order);
  std::vector<Index> every_third;
  for (Index cell = 0; cell < whole.n_cells(); cell += 3) every_third.push_back(cell);
  for (const Mesh& mesh : {split(whole), split(whole, every_third)}) {
    CHECK_NOTHROW(check_mesh(mesh));
    CHECK(mesh.order() == order);
    CHECK(area_of(mesh) == Approx(area_of(whole)).epsilon(1e-14));
    CHECK(is_rim(mesh, half_disc_rim));
    CHECK(mesh.n_nodes() == nodes_if_joined(mesh, half_disc_rim));
    CHECK(mesh.nodes.topRows(whole.n_nodes()) == whole.nodes);
    for (const std::string& name : half_disc_rim)
      CHECK(boundary_nodes(mesh, name) == boundary_nodes(whole, name));
  }
  CHECK(split(whole).n_cells() == 2 * whole.n_cells());
  CHECK(split(whole, {}).cells == whole.cells);
  CHECK(split(split(whole)).cells == split(whole).cells);  // triangles stay as they are
  CHECK_THROWS_AS(split(whole, {whole.n_cells()}), std::invalid_argument);
}

TEST_CASE("the shorter diagonal cuts, of equal ones that from the first corner", "[split]") {
  Mesh mesh;
  mesh.nodes.resize(4, 2);
  mesh.nodes << 0, 0, 1, 0, 1, 1, 0, 1;
  mesh.cells.resize(1, 4);
  mesh.cells << 0, 1, 2, 3;
  mesh.boundaries["round"] = {{0, 0}, {0, 1}, {0, 2}, {0, 3}};
  mesh.regions["all"] = {0};
  CellArray expected(2, 3);
  expected << 0, 1, 2, 2, 3, 0;
  CHECK(split(mesh).cells == expected);
  mesh.nodes.array() *= 1 + 1e-15;
  CHECK(split(mesh).cells == expected);
  CHECK(split(mesh).regions.at("all") == std::vector<Index>{0, 1});
  mesh.nodes.row(2) << 1.1, 1;
  expected << 1, 2, 3, 3, 0, 1;
  CHECK(split(mesh).cells == expected);
  CHECK(boundary_nodes(split(mesh), "round") == std::vector<Index>{0, 1, 2, 3});
}

TEST_CASE("diagonals are straight in cells of straight sides, and bend with curved ones",
          "[split]") {
  Mesh mesh = block("block", {0, 0}, {1, 1}, 1, 1, MeshOrder::Quadratic);
  mesh.nodes.row(mesh.cells(0, 2)) << 1.5, 1.25;
  for (int s = 0; s < 4; ++s)
    mesh.nodes.row(mesh.cells(0, 4 + s)) =
        0.5 * (mesh.nodes.row(mesh.cells(0, s)) + mesh.nodes.row(mesh.cells(0, (s + 1) % 4)));
  CHECK(RowVector2d(split(mesh).nodes.bottomRows(1)) == RowVector2d(0.5, 0.5));  // from 1 to 3
  for (const int s : {0, 2}) mesh.nodes(mesh.cells(0, 4 + s), 1) += 0.25;        // both arcs rise
  CHECK(RowVector2d(split(mesh).nodes.bottomRows(1)) == RowVector2d(0.5, 0.75));
}

TEST_CASE("both halves of a cell are in its region, and no others", "[split]") {
  const Mesh whole = with_region(half_disc(any_order()), "core", {0, -0.5}, {0.5, 0.5});
  const auto area_of_core = [](const Mesh& mesh) {
    Mesh part = mesh;
    part.cells = mesh.cells(region(mesh, "core"), Eigen::all);
    return area_of(part);
  };
  for (const Mesh& mesh : {split(whole), split(whole, {0, 1, 7})})
    CHECK(area_of_core(mesh) == Approx(area_of_core(whole)).epsilon(1e-14).margin(0));
}

TEST_CASE("mixed meshes are mirrored and joined", "[split][reshape]") {
  const Mesh whole = half_disc(any_order());
  Mesh half = split(whole, {0, 1, 7});
  half.regions["cut"] = {0, 1, 2, 3};
  const Mesh image = mirrored(half, MirrorLine::Upright);
  CHECK_NOTHROW(check_mesh(image));
  CHECK(is_rim(image, {"rim", "axis"}));
  const Mesh full = joined(half, "axis", image, "axis");
  CHECK_NOTHROW(check_mesh(full));
  CHECK(area_of(full) == Approx(2 * area_of(whole)).epsilon(1e-14));
  CHECK(is_rim(full, {"rim"}));
  CHECK(full.n_nodes() == nodes_if_joined(full, {"rim"}));
  const Index n = half.n_cells();
  CHECK(full.regions.at("cut") == std::vector<Index>{0, 1, 2, 3, n, n + 1, n + 2, n + 3});
  const Mesh triangles = split(whole);  // of 3 beside one of 4
  CHECK_NOTHROW(
      check_mesh(joined(triangles, "axis", mirrored(whole, MirrorLine::Upright), "axis")));
}
