// Meshes made finer, everywhere and in parts.
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "addons/checks/loose_nodes.hpp"
#include "addons/estimate/mesh_refinement.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "meshes/regions.hpp"
#include "meshes/reshape.hpp"
#include "meshes/ring.hpp"
#include "meshes/split.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/rounding.hpp"
#include "support/half_disc.hpp"
#include "support/mesh_measures.hpp"

using Eigen::Index;
using Eigen::RowVector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

std::vector<std::pair<double, double>> places(const NodeArray& nodes) {
  std::vector<std::pair<double, double>> list;
  for (Index k = 0; k < nodes.rows(); ++k) list.emplace_back(nodes(k, 0), nodes(k, 1));
  std::sort(list.begin(), list.end());
  return list;
}

/// Halves the longest or the first sides of the cells that have a corner at a place.
Mesh refined_at(const Mesh& mesh, const RowVector2d& place) {
  const MeshEdges all = edges(mesh);
  std::vector<char> halved(all.size(), 0);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int k = 0; k < mesh.corners(cell); ++k)
      if (RowVector2d(mesh.nodes.row(mesh.cells(cell, k))) == place) {
        const int side = mesh.corners(cell) == 3 ? longest_side(mesh, cell) : 0;
        halved[static_cast<std::size_t>(all.at({cell, side}))] = 1;
        if (mesh.corners(cell) == 4) halved[static_cast<std::size_t>(all.at({cell, 1}))] = 1;
      }
  return refined_mesh(mesh, all, halved);
}

double smallest_angle(const Mesh& mesh) {
  double smallest = 4;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int k = 0; k < 3; ++k) {
      const RowVector2d here = mesh.nodes.row(mesh.cells(cell, k));
      const RowVector2d a = mesh.nodes.row(mesh.cells(cell, (k + 1) % 3)) - here;
      const RowVector2d b = mesh.nodes.row(mesh.cells(cell, (k + 2) % 3)) - here;
      smallest = std::min(smallest, std::acos(a.dot(b) / (a.norm() * b.norm())));
    }
  return smallest;
}

double area_of_region(const Mesh& mesh, const std::string& name) {
  const std::vector<Index> cells = region(mesh, name);
  Mesh part = mesh;
  part.cells = mesh.cells(cells, Eigen::all);
  return area_of(part);
}

/// The same mesh with nodes and cells in another order, and cells that begin at another corner.
Mesh shuffled(const Mesh& mesh, std::uint32_t seed) {
  Random random(seed);
  std::vector<Index> number(static_cast<std::size_t>(mesh.n_nodes()));
  for (std::size_t k = 0; k < number.size(); ++k) number[k] = static_cast<Index>(k);
  for (std::size_t k = number.size(); k > 1; --k)
    std::swap(number[k - 1],
              number[std::min(
                  k - 1, static_cast<std::size_t>(random.uniform(0, 1) * static_cast<double>(k)))]);
  Mesh other = mesh;
  for (Index k = 0; k < mesh.n_nodes(); ++k)
    other.nodes.row(number[static_cast<std::size_t>(k)]) = mesh.nodes.row(k);
  const Index last = mesh.n_cells() - 1;
  for (Index cell = 0; cell <= last; ++cell) {
    const int n = mesh.corners(cell);
    for (int k = 0; k < n; ++k)
      for (Index half = 0; half < mesh.cell_size(cell) / n; ++half)
        other.cells(last - cell, n * half + k) =
            number[static_cast<std::size_t>(mesh.cells(cell, n * half + (k + 1) % n))];
    for (Index k = mesh.cell_size(cell); k < mesh.cells.cols(); ++k)
      other.cells(last - cell, k) = -1;
  }
  for (auto& [name, sides] : other.boundaries)
    for (CellSide& side : sides) {
      const int n = mesh.corners(side.cell);
      side = {last - side.cell, (side.side + n - 1) % n};
    }
  return other;
}

}  // namespace

TEST_CASE("a disc made finer everywhere is a disc, and nothing of it comes apart", "[refinement]") {
  const MeshOrder order = any_order();
  const int triangles_every = GENERATE(0, 1, 3);
  CAPTURE(triangles_every);
  Mesh mesh = half_disc(order, triangles_every);
  double before = std::abs(area_of(mesh) - pi / 2);
  for (int round = 0; round < 3; ++round) {
    const Mesh coarse = mesh;
    mesh = refined_mesh(coarse);
    CHECK(mesh.n_cells() == 4 * coarse.n_cells());
    CHECK_NOTHROW(check_mesh(mesh));
    CHECK(mesh.nodes.topRows(coarse.n_nodes()) == coarse.nodes);
    CHECK(is_rim(mesh, half_disc_rim));
    CHECK(mesh.n_nodes() == nodes_if_joined(mesh, half_disc_rim));
    CHECK(outer_sides(mesh).size() == 2 * outer_sides(coarse).size());
    for (const Index node : boundary_nodes(mesh, "axis")) CHECK(mesh.nodes(node, 0) == 0);
    for (const Index node : boundary_nodes(mesh, "rim"))
      CHECK(mesh.nodes.row(node).norm() == Approx(1).epsilon(1e-15).margin(0));
    // Chords miss a circle by (side)^2, parabolas by (side)^4.
    const double after = std::abs(area_of(mesh) - pi / 2);
    CHECK(before / after > (order == MeshOrder::Linear ? 3.9 : 14.5));
    before = after;
  }
}

TEST_CASE("a block made finer is the block of twice as many cells", "[refinement]") {
  BlockSpec spec;
  spec.order = any_order();
  spec.corner = {-3, 8};
  spec.cells_x = 3;
  spec.cells_y = 2;
  spec.size = {6, 2};
  const Mesh mesh = make_block(spec);
  const MeshEdges all = edges(mesh);
  spec.cells_y = 4;
  std::vector<char> halved(all.size(), 0);
  for (Index row = 0; row < 2; ++row)
    halved[static_cast<std::size_t>(all.at({3 * row, 3}))] = 1;  // up the left boundary
  CHECK(places(refined_mesh(mesh, all, halved).nodes) == places(make_block(spec).nodes));
  spec.cells_x = 6;
  CHECK(places(refined_mesh(mesh).nodes) == places(make_block(spec).nodes));
  const std::vector<char> none(all.size(), 0);
  const HalvedMesh nothing = halved_once(mesh, {all, none});
  CHECK(nothing.marks.halved == std::vector<char>(all.size(), 0));
  CHECK(refined_mesh(mesh, all, none).cells == mesh.cells);
  CHECK(refined_mesh(mesh, all, none).nodes == mesh.nodes);
  CHECK_THROWS_AS(refined_mesh(mesh, all, {1}), std::invalid_argument);
}

TEST_CASE("an edge marked three times becomes eight, and all that is opposite as many",
          "[refinement]") {
  BlockSpec spec;
  spec.order = any_order();
  spec.cells_x = 3;
  spec.cells_y = 2;
  const Mesh block = make_block(spec);
  HalvedMesh finer{block, {edges(block), {}}};
  finer.marks.halved.assign(finer.marks.edges.size(), 0);
  const auto mark = [&](Index cell, int side, char times) {
    finer.marks.halved[static_cast<std::size_t>(finer.marks.edges.at({cell, side}))] = times;
  };
  mark(0, 0, 1);
  for (const Index cell : {1, 2}) mark(cell, 0, 3);  // the cells of the lower row, along
  mark(3, 3, 2);                                     // and the upper row, across
  int rounds = 0;
  while (*std::max_element(finer.marks.halved.begin(), finer.marks.halved.end()) > 0) {
    finer = halved_once(finer.mesh, finer.marks);
    check_mesh(finer.mesh);
    ++rounds;
  }
  CHECK(rounds == 3);
  CHECK(finer.mesh.n_cells() == (2 + 8 + 8) * (1 + 4));
  CHECK(boundary(finer.mesh, "bottom").size() == 2 + 8 + 8);
  CHECK(boundary(finer.mesh, "left").size() == 1 + 4);
}

TEST_CASE("triangles marked twice have no hanging nodes", "[refinement]") {
  const Mesh whole = half_disc(any_order(), GENERATE(1, 3));
  const MeshEdges all = edges(whole);
  const CellSide side = boundary(whole, "rim")[2];
  std::vector<char> times(all.size(), 0);
  times[static_cast<std::size_t>(all.at(side))] = 2;
  const HalvedMesh once = halved_once(whole, {all, times});
  const HalvedMesh twice = halved_once(once.mesh, once.marks);
  CHECK(*std::max_element(twice.marks.halved.begin(), twice.marks.halved.end()) == 0);
  CHECK(twice.mesh.n_nodes() == nodes_if_joined(twice.mesh, half_disc_rim));
  CHECK(boundary(twice.mesh, "rim").size() >= boundary(whole, "rim").size() + 3);
}

TEST_CASE("circles inside a ring stay circles, however thin its layers", "[refinement]") {
  AnnulusSpec spec;
  spec.order = any_order();
  spec.centre = {40, -7};
  spec.cells_angle = 12;
  spec.cells_radius = 2;
  Mesh mesh = make_annulus(spec);
  const auto halve_if = [&mesh](auto&& wanted) {
    const MeshEdges all = edges(mesh);
    std::vector<char> halved(all.size(), 0);
    for (std::size_t e = 0; e < all.size(); ++e) {
      const std::vector<Index> nodes = mesh.side_nodes(all.sides[e][0]);
      halved[e] = wanted(RowVector2d(mesh.nodes.row(nodes.front()) - RowVector2d(40, -7)),
                         RowVector2d(mesh.nodes.row(nodes.back()) - RowVector2d(40, -7)))
                      ? 1
                      : 0;
    }
    return refined_mesh(mesh, all, halved);
  };
  const auto radial = [](const RowVector2d& a, const RowVector2d& b) {
    return std::abs(a.norm() - b.norm()) > 1e-12;
  };
  std::set<Index> radii;                   // in 2^-10, as there are no others
  for (int round = 0; round < 6; ++round)  // the layer at the hole becomes 1/128 thick
    mesh = halve_if([&](const RowVector2d& a, const RowVector2d& b) {
      return radial(a, b) && std::min(a.norm(), b.norm()) < 1 + 1e-12;
    });
  for (int round = 0; round < 2; ++round)
    mesh = halve_if([&](const RowVector2d& a, const RowVector2d& b) { return !radial(a, b); });
  CHECK_NOTHROW(check_mesh(mesh));
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const double radius = (mesh.nodes.row(node) - RowVector2d(40, -7)).norm();
    const double nearest = std::round(radius * 1024) / 1024;
    // A parabola between 12 rays cuts the circle, so that middles of layers lie off by (side)^4.
    const double rounding = spec.order == MeshOrder::Linear ? 1e-13 : 2e-4;
    CHECK(std::abs(radius - nearest) < rounding);
  }
}

TEST_CASE("triangles are bisected around one node without flat ones or loose nodes",
          "[refinement]") {
  const MeshOrder order = any_order();
  BlockSpec spec;
  spec.order = order;
  spec.cells_x = 3;
  spec.cells_y = 2;
  const int every = GENERATE(1, 2);
  const Mesh block = make_block(spec);
  Mesh mesh = every == 1 ? split(block) : split(block, {0, 2, 4});
  const double angle = every == 1 ? smallest_angle(mesh) : 0;
  for (int round = 0; round < 12; ++round) mesh = refined_at(mesh, RowVector2d(0, 0));
  CHECK_NOTHROW(check_mesh(mesh));
  CHECK(loose_nodes(mesh).empty());
  CHECK(area_of(mesh) == Approx(1).epsilon(1e-14));
  CHECK(mesh.n_nodes() == nodes_if_joined(mesh, {"bottom", "right", "top", "left"}));
  if (every > 1) return;
  CHECK(smallest_angle(mesh) >= angle / 2);
  CHECK(mesh.n_cells() < 12 * 20);  // it stays near the node
}

TEST_CASE("regions and boundaries stay where they are", "[refinement]") {
  const MeshOrder order = any_order();
  Mesh mesh = with_region(half_disc(order, 3), "core", {0, -0.5}, {0.5, 0.5});
  const double all = area_of(mesh);
  const double core = area_of_region(mesh, "core");
  const double axis = length_of(mesh, "axis");
  mesh = refined_at(mesh, mesh.nodes.row(boundary_nodes(mesh, "axis")[2]));
  CHECK(area_of_region(mesh, "core") / area_of(mesh) == Approx(core / all).epsilon(0.05));
  CHECK(length_of(mesh, "axis") == Approx(axis).epsilon(1e-14));
}

TEST_CASE("all pieces of a cell are in its region, and no others", "[refinement]") {
  BlockSpec spec;
  spec.order = any_order();
  spec.size = {3, 2};
  spec.cells_x = 3;
  spec.cells_y = 2;
  const Mesh block = make_block(spec);
  for (Mesh mesh : {block, split(block), split(block, {0, 2, 4})}) {
    mesh = with_region(mesh, "left", {0, 0}, {1, 2});
    CHECK(region(refined_mesh(mesh), "left").size() == 4 * region(mesh, "left").size());
    for (int round = 0; round < 4; ++round) {
      mesh = round % 2 == 0 ? refined_at(mesh, RowVector2d(1, 0)) : refined_mesh(mesh);
      CHECK(area_of_region(mesh, "left") == Approx(2).epsilon(1e-14).margin(0));
    }
  }
}

TEST_CASE("the same mesh in another order is made finer in the same places", "[refinement]") {
  const Mesh mesh = half_disc(any_order(), GENERATE(0, 1, 3));
  const RowVector2d pole = mesh.nodes.row(boundary_nodes(mesh, "rim").front());
  const Mesh once = refined_at(refined_mesh(mesh), pole);
  const Mesh again = refined_at(refined_mesh(mesh), pole);
  CHECK(once.nodes == again.nodes);
  CHECK(once.cells == again.cells);
  for (const std::uint32_t seed : {1U, 2U}) {
    const Mesh other = refined_at(refined_mesh(shuffled(mesh, seed)), pole);
    REQUIRE(other.n_nodes() == once.n_nodes());
    double worst = 0;
    for (Index k = 0; k < once.n_nodes(); ++k)
      worst =
          std::max(worst, (other.nodes.rowwise() - once.nodes.row(k)).rowwise().norm().minCoeff());
    CHECK(worst < 1e-14);
  }
}
