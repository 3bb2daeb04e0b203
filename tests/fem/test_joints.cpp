#include <algorithm>
#include <numeric>
#include <set>

#include "addons/checks/loose_nodes.hpp"
#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "meshes/half_space.hpp"
#include "meshes/ring.hpp"
#include "meshes/split.hpp"
#include "signorini/fem/joints.hpp"
#include "support/loose_meshes.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

std::set<std::pair<Index, int>> as_set(const std::vector<CellSide>& sides) {
  std::set<std::pair<Index, int>> set;
  for (const CellSide& side : sides) set.insert({side.cell, side.side});
  return set;
}

std::set<std::pair<Index, int>> sides_of_boundaries(const Mesh& mesh) {
  std::set<std::pair<Index, int>> set;
  for (const auto& [name, sides] : mesh.boundaries)
    for (const CellSide& side : sides) set.insert({side.cell, side.side});
  return set;
}

/// The same mesh with other numbers for nodes and cells.
Mesh shuffled(const Mesh& mesh, std::uint64_t seed) {
  Random random(seed);
  const auto permutation = [&random](Index n) {
    std::vector<Index> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), Index{0});
    for (std::size_t k = order.size(); k > 1; --k)
      std::swap(order[k - 1], order[static_cast<std::size_t>(random.whole(0, int(k) - 1))]);
    return order;
  };
  const std::vector<Index> nodes = permutation(mesh.n_nodes());
  const std::vector<Index> cells = permutation(mesh.n_cells());
  Mesh other = mesh;
  other.boundaries.clear();
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    other.nodes.row(nodes[static_cast<std::size_t>(node)]) = mesh.nodes.row(node);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (Index k = 0; k < mesh.cells.cols(); ++k)
      other.cells(cells[static_cast<std::size_t>(cell)], k) =
          nodes[static_cast<std::size_t>(mesh.cells(cell, k))];
  return other;
}

/// Places of the loose nodes, and how many of them coincide with others.
std::pair<std::set<std::pair<double, double>>, Index> places(const Mesh& mesh) {
  std::set<std::pair<double, double>> at;
  Index coincide = 0;
  for (const LooseNode& loose : loose_nodes(mesh)) {
    at.insert({mesh.nodes(loose.node, 0), mesh.nodes(loose.node, 1)});
    coincide += loose.other >= 0 ? 1 : 0;
  }
  return {at, coincide};
}

std::vector<Mesh> sound_meshes() {
  std::vector<Mesh> meshes;
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    meshes.push_back(named_block("block", {0, 0}, {3, 2}, 5, 4, order));
    meshes.push_back(named_block("strip", {0, 0}, {1e4, 1}, 7, 1, order));  // 1400 times as wide
    meshes.push_back(named_block("strip", {0, 0}, {1e4, 1}, 3, 2, order));
    meshes.push_back(named_block("cell", {0, 0}, {1, 1}, 1, 1, order));
    BlockSpec graded;
    graded.size = {1, 1};
    graded.cells_x = graded.cells_y = 12;
    graded.grading_x = graded.grading_y = 1e6;
    graded.order = order;
    meshes.push_back(make_block(graded));
    DiscSpec disc;
    disc.order = order;
    meshes.push_back(make_disc(disc));
    AnnulusSpec ring;
    ring.cells_angle = 12;
    ring.order = order;
    meshes.push_back(make_annulus(ring));
    HalfSpaceSpec space;
    space.order = order;
    meshes.push_back(make_half_space(space));
    meshes.push_back(joined(named_block("a", {0, 0}, {1, 1}, 2, 2, order), "right",
                            named_block("b", {1, 0}, {1, 1}, 3, 2, order), "left"));
  }
  return meshes;
}

}  // namespace

TEST_CASE("a sound mesh is one piece, its outer sides are its boundaries, and no node is loose",
          "[joints]") {
  std::vector<Mesh> meshes = sound_meshes();
  for (const Mesh& mesh : sound_meshes()) meshes.push_back(split(mesh));
  for (const Mesh& mesh : meshes) {
    CAPTURE(mesh.name, mesh.cells.cols());
    const std::vector<MeshPiece> parts = pieces(mesh);
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].cells == mesh.n_cells());
    CHECK(static_cast<Index>(parts[0].nodes.size()) == mesh.n_nodes());
    CHECK(as_set(outer_sides(mesh)) == sides_of_boundaries(mesh));
    CHECK(loose_nodes(mesh).empty());
    for (const double length : {1e-6, 1e6}) {
      const Mesh scaled = mapped(mesh, [=](const Vector2d& x) { return Vector2d(length * x); });
      CHECK(loose_nodes(scaled).empty());
    }
  }
}

TEST_CASE("pieces are told apart, in the order of their first nodes", "[joints]") {
  const Mesh both =
      together(named_block("a", {0, 0}, {2, 1}, 4, 2), named_block("", {5, 0}, {1, 1}, 3, 1));
  const std::vector<MeshPiece> parts = pieces(both);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].nodes.size() == 15);
  CHECK(parts[1].nodes.size() == 8);
  CHECK(parts[1].nodes.front() == 15);
  CHECK(in_words(both, parts[0]) == "8 cells around (1, 0.5)");
  CHECK(in_words(both, parts[1]) == "3 cells around (5.5, 0.5)");
  CHECK(loose_nodes(both).empty());
  CHECK(pieces(shuffled(both, 3)).size() == 2);
}

TEST_CASE("pieces that touch at one node are one piece, and their sides there are outer ones",
          "[joints]") {
  const Mesh corner = merged(
      together(named_block("a", {0, 0}, {1, 1}, 1, 1), named_block("", {1, 1}, {1, 1}, 1, 1)));
  CHECK(corner.n_nodes() == 7);
  CHECK(pieces(corner).size() == 1);
  CHECK(outer_sides(corner).size() == 8);
  CHECK(loose_nodes(corner).empty());
}

TEST_CASE("nodes in one place that are not joined are found", "[joints]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic})
    for (const double shift : {0.0, 1e-12, 1e-5}) {
      CAPTURE(order == MeshOrder::Linear, shift);
      const Mesh both = together(named_block("a", {0, 0}, {1, 1}, 2, 3, order),
                                 named_block("", {1 + shift, 0}, {1, 1}, 2, 3, order));
      const std::vector<LooseNode> loose = loose_nodes(both);
      REQUIRE(loose.size() == (order == MeshOrder::Linear ? 4 : 7));
      for (const LooseNode& one : loose) {
        CHECK(one.other >= 0);
        CHECK(one.other < one.node);
        CHECK((both.nodes.row(one.node) - both.nodes.row(one.other)).norm() <= shift + 1e-15);
      }
    }
  CHECK(loose_nodes(together(named_block("a", {0, 0}, {1, 1}, 2, 3),
                             named_block("", {1.01, 0}, {1, 1}, 2, 3)))
            .empty());  // a gap of a thirtieth of a cell is one
}

TEST_CASE("a crack has its nodes twice but for the tip", "[joints]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    const Mesh crack = split_block(1, 2, order);
    CHECK(pieces(crack).size() == 1);
    const std::vector<LooseNode> loose = loose_nodes(crack);
    CHECK(loose.size() == (order == MeshOrder::Linear ? 2 : 4));
    for (const LooseNode& one : loose) CHECK(crack.nodes(one.node, 1) > 1);
    CHECK(outer_sides(crack).size() == 2 * (8 + 4 + 2));  // around, and both faces
  }
}

TEST_CASE("hanging nodes are found, whatever the numbers of nodes and cells", "[joints]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic})
    for (const Index finer : {1, 2, 3, 5}) {
      CAPTURE(order == MeshOrder::Linear, finer);
      const Mesh mesh = hanging_block(finer, order);
      CHECK(pieces(mesh).size() == 1);
      const auto [at, coincide] = places(mesh);
      // The node in the middle of a quadratic side belongs to both.
      const Index hanging = order == MeshOrder::Linear ? finer - 1 : 2 * finer - 2;
      CHECK(static_cast<Index>(at.size()) == 2 * hanging);
      CHECK(coincide == 0);
      for (const auto& [x, y] : at) CHECK(x == 1);
      CHECK(places(shuffled(mesh, 7)) == std::pair(at, coincide));
      CHECK(places(split(mesh)) == std::pair(at, coincide));  // in triangles
    }
}

TEST_CASE("a hanging node on a curved side is found on the curve", "[joints]") {
  const auto bent = [](const Mesh& mesh) {
    return mapped(
        mesh, [](const Vector2d& x) { return Vector2d(x.x() + 0.3 * x.y() * (1 - x.y()), x.y()); });
  };
  const Mesh mesh = bent(hanging_block(2, MeshOrder::Quadratic));
  CHECK(check_mesh(mesh).smallest_jacobian_ratio > 0);
  CHECK(places(mesh).first.size() == 4);
  // Straight sides miss the nodes of a bent line of finer ones: what is left between them is a gap.
  CHECK(places(bent(hanging_block(2))).first.empty());
}
