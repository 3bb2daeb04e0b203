#include <cmath>

#include "catch_compat.hpp"
#include "meshes/ring.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "support/mesh_measures.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::RowVector2d;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

Mesh block(MeshOrder order, Index cells_y = 3) {
  BlockSpec spec;
  spec.corner = {1, -2};
  spec.size = {6, 3};
  spec.cells_x = 4;
  spec.cells_y = cells_y;
  spec.grading_x = 3;
  spec.grading_y = 2;
  spec.order = order;
  return make_block(spec);
}

MeshOrder any_order() { return GENERATE(MeshOrder::Linear, MeshOrder::Quadratic); }

const std::vector<std::string> forwards = {"bottom", "right", "top", "left"};

}  // namespace

TEST_CASE("moving adds one vector to every node", "[reshape]") {
  const Mesh before = block(MeshOrder::Linear);
  const Mesh after = moved(before, {0.5, -4});
  CHECK(after.cells == before.cells);
  CHECK(after.nodes == NodeArray(before.nodes.rowwise() + RowVector2d(0.5, -4)));
}

TEST_CASE("a mirror image is a good mesh of the same area with the body on the left", "[reshape]") {
  const Mesh before = block(any_order());
  for (const MirrorLine line : {MirrorLine::Upright, MirrorLine::Level}) {
    const Mesh image = mirrored(before, line, 1);
    CHECK_NOTHROW(check_mesh(image));
    CHECK(area_of(image) == Approx(18).epsilon(1e-14).margin(0));
    CHECK(is_rim(image, {"left", "top", "right", "bottom"}));
    const double sign = line == MirrorLine::Upright ? -1 : 1;
    for (Index node = 0; node < image.n_nodes(); ++node) {
      CHECK(image.nodes(node, 0) == (sign < 0 ? 2 - before.nodes(node, 0) : before.nodes(node, 0)));
      CHECK(image.nodes(node, 1) == (sign > 0 ? 2 - before.nodes(node, 1) : before.nodes(node, 1)));
    }
    for (const std::string& name : forwards) {  // the same sides, backwards
      std::vector<Index> nodes = boundary_nodes(image, name);
      std::reverse(nodes.begin(), nodes.end());
      CHECK(nodes == boundary_nodes(before, name));
    }
    const Mesh again = mirrored(image, line, 1);
    CHECK(again.cells == before.cells);
  }
}

TEST_CASE("a boundary gets another name, or becomes part of a longer one", "[reshape]") {
  Mesh mesh = renamed(block(any_order()), "top", "roof");
  CHECK(is_rim(mesh, {"bottom", "right", "roof", "left"}));
  CHECK(mesh.boundaries.size() == 4);
  mesh = renamed(mesh, "bottom", "skin");
  mesh = renamed(mesh, "right", "skin");  // continues it
  mesh = renamed(mesh, "left", "skin");   // ends where it begins
  CHECK(is_rim(mesh, {"skin", "roof"}));
  CHECK_THAT(problem_message([&] { static_cast<void>(renamed(mesh, "hull", "skin")); }),
             ContainsSubstring("no boundary 'hull'"));
  const Mesh plain = block(MeshOrder::Linear);
  CHECK_THAT(problem_message([&] { static_cast<void>(renamed(plain, "top", "bottom")); }),
             ContainsSubstring("boundary 'bottom' already, and 'top' neither begins"));
}

TEST_CASE("a block joined to its image is one body with one rim", "[reshape]") {
  const MeshOrder order = any_order();
  const Mesh half = block(order);
  const Mesh whole = joined(half, "left", mirrored(half, MirrorLine::Upright, 1), "left");
  CHECK_NOTHROW(check_mesh(whole));
  CHECK(area_of(whole) == Approx(36).epsilon(1e-14).margin(0));
  CHECK(whole.n_nodes() == 2 * half.n_nodes() - (order == MeshOrder::Linear ? 4 : 7));
  CHECK(whole.boundaries.size() == 3);
  // Right sides of both are apart; bottom and top are one walk each.
  CHECK(boundary(whole, "bottom").size() == 8);
  for (const char* name : {"bottom", "top"})
    for (std::size_t s = 1; s < 8; ++s)
      CHECK(whole.side_nodes(boundary(whole, name)[s]).front() ==
            whole.side_nodes(boundary(whole, name)[s - 1]).back());
  CHECK(is_symmetric(whole, [](const RowVector2d& x) { return RowVector2d(2 - x.x(), x.y()); }));
}

TEST_CASE("half a ring joined to its image is a ring", "[reshape]") {
  AnnulusSpec spec;
  spec.sector = Sector::Half;
  spec.cells_angle = 8;
  spec.cells_radius = 3;
  const Mesh half = make_annulus(spec);
  const Mesh image = mirrored(half, MirrorLine::Level);
  const Mesh ring = joined(half, "symmetry", image, "symmetry");
  CHECK_NOTHROW(check_mesh(ring));
  CHECK(ring.n_nodes() == 16 * 4);
  CHECK(boundary(ring, "outer").size() == 16);
}

TEST_CASE("meshes that do not meet node by node are not joined", "[reshape]") {
  const Mesh one = block(MeshOrder::Linear);
  const auto message = [&](const Mesh& other) {
    return problem_message([&] { static_cast<void>(joined(one, "left", other, "left")); });
  };
  const Mesh image = mirrored(one, MirrorLine::Upright, 1);
  CHECK(message(image).empty());
  CHECK(message(moved(image, {1e-14, 0})).empty());
  CHECK_THAT(message(moved(image, {1e-9, 0})), ContainsSubstring("must be in one place"));
  CHECK_THAT(message(mirrored(block(MeshOrder::Linear, 4), MirrorLine::Upright, 1)),
             ContainsSubstring("has 4 nodes on 'left', but 'block' has 5 on 'left'"));
  CHECK_THAT(message(mirrored(block(MeshOrder::Quadratic), MirrorLine::Upright, 1)),
             ContainsSubstring("sides of 'block' have 2 nodes, those of 'block' have 3"));
}

TEST_CASE("a block bends into a wedge whose faces rise with one slope", "[reshape]") {
  const double slope = 0.05;
  const double height = 4;
  const Mesh half = mapped(make_graded_block("wedge", stretched(0, {{3, 6, 8}}),
                                             stretched(0, {{height, 5, 4}}), any_order()),
                           [=](const Vector2d& x) {
                             return Vector2d(x.x(), x.y() + slope * x.x() * (1 - x.y() / height));
                           });
  const Mesh wedge = joined(half, "left", mirrored(half, MirrorLine::Upright), "left");
  CHECK_NOTHROW(check_mesh(wedge));
  CHECK(area_of(wedge) == Approx(6 * height - slope * 9).epsilon(1e-14).margin(0));
  for (const Index node : boundary_nodes(wedge, "bottom"))
    CHECK(wedge.nodes(node, 1) == slope * std::abs(wedge.nodes(node, 0)));
}
