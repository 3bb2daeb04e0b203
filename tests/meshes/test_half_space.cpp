#include <cmath>

#include "catch_compat.hpp"
#include "meshes/half_space.hpp"
#include "support/mesh_measures.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::RowVector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

HalfSpaceSpec point(MeshOrder order) {
  HalfSpaceSpec spec;
  spec.width = 95;
  spec.depth = 60;
  spec.core = {1.5, 1};
  spec.core_columns = 6;
  spec.core_rows = 4;
  spec.layers = 8;
  spec.order = order;
  return spec;
}

EdgeBlockSpec edge(MeshOrder order) {
  EdgeBlockSpec spec;
  spec.edge = 1.5;
  spec.width = 15;
  spec.depth = 12;
  spec.cells_under = 6;
  spec.cells_beside = 7;
  spec.cells_deep = 5;
  spec.order = order;
  return spec;
}

MeshOrder any_order() { return GENERATE(MeshOrder::Linear, MeshOrder::Quadratic); }

/// Whether the boundaries lie exactly on the sides of the rectangle.
void check_sides(const Mesh& mesh, double width, double depth) {
  for (const Index node : boundary_nodes(mesh, "axis")) CHECK(mesh.nodes(node, 0) == 0);
  for (const Index node : boundary_nodes(mesh, "side")) CHECK(mesh.nodes(node, 0) == width);
  for (const Index node : boundary_nodes(mesh, "surface")) CHECK(mesh.nodes(node, 1) == 0);
  for (const Index node : boundary_nodes(mesh, "base")) CHECK(mesh.nodes(node, 1) == -depth);
  CHECK(is_rim(mesh, {"axis", "base", "side", "surface"}));
}

}  // namespace

TEST_CASE("a half-space fine at a point fills its rectangle", "[half]") {
  const Mesh mesh = make_half_space(point(any_order()));
  CHECK(area_of(mesh) == Approx(95 * 60).epsilon(1e-14).margin(0));
  CHECK(mesh.n_nodes() == nodes_if_joined(mesh, {"axis", "base", "side", "surface"}));
  check_sides(mesh, 95, 60);
  CHECK(mesh.boundaries.size() == 4);
  const MeshQuality quality = check_mesh(mesh);
  CHECK(quality.smallest_jacobian_ratio > 0.4);
  CHECK(quality.largest_aspect_ratio < 12);
}

TEST_CASE("a half-space has an even core, then layers that grow by one factor", "[half]") {
  const Mesh mesh = make_half_space(point(MeshOrder::Linear));
  const std::vector<Index> surface = boundary_nodes(mesh, "surface");
  const auto x = [&](std::size_t k) { return mesh.nodes(surface[surface.size() - 1 - k], 0); };
  for (std::size_t k = 0; k <= 6; ++k)
    CHECK(x(k) == Approx(0.25 * static_cast<double>(k)).epsilon(1e-14).margin(1e-300));
  const double factor = std::pow(95 / 1.5, 1.0 / 8);
  for (std::size_t k = 6; k < 14; ++k)
    CHECK(x(k + 1) / x(k) == Approx(factor).epsilon(1e-13).margin(0));
}

TEST_CASE("with a grading the layers grow faster outwards", "[half]") {
  HalfSpaceSpec spec = point(MeshOrder::Linear);
  spec.layer_grading = 3;
  const Mesh mesh = make_half_space(spec);
  const std::vector<Index> surface = boundary_nodes(mesh, "surface");
  const auto growth = [&](std::size_t k) {
    return std::log(mesh.nodes(surface[k], 0) / mesh.nodes(surface[k + 1], 0));
  };
  CHECK(growth(0) / growth(7) == Approx(3).epsilon(1e-12).margin(0));
}

TEST_CASE("a block fine at an edge fills its rectangle with the nodes it promises", "[half]") {
  const EdgeBlockSpec spec = edge(any_order());
  const Mesh mesh = make_edge_block(spec);
  CHECK(area_of(mesh) == Approx(15 * 12).epsilon(1e-14).margin(0));
  CHECK(mesh.n_nodes() == spec.n_nodes());
  check_sides(mesh, 15, 12);
  CHECK(length_of(mesh, "loaded") == Approx(1.5).epsilon(1e-14).margin(0));
  CHECK(is_rim(mesh, {"axis", "base", "side", "surface"}));
  CHECK(boundary(mesh, "loaded").size() == 6);
}

TEST_CASE("cells at the edge are equal to the left, to the right and in depth", "[half]") {
  EdgeBlockSpec spec = edge(MeshOrder::Linear);
  const Mesh mesh = make_edge_block(spec);
  const std::vector<Index> surface = boundary_nodes(mesh, "surface");
  const auto x = [&](std::size_t k) { return mesh.nodes(surface[13 - k], 0); };
  CHECK(x(6) == 1.5);
  CHECK((x(1) - x(0)) / (x(6) - x(5)) == Approx(4).epsilon(1e-12).margin(0));
  CHECK(x(7) - x(6) == Approx(x(6) - x(5)).epsilon(1e-12).margin(0));
  CHECK(-mesh.nodes(boundary_nodes(mesh, "axis")[1], 1) ==
        Approx(x(6) - x(5)).epsilon(1e-12).margin(0));
  for (std::size_t k = 0; k <= 6; ++k) CHECK(spec.under()(static_cast<Index>(k)) == x(k));
  spec.grading_under = 1;
  spec.grading_beside = 20;
  spec.grading_deep = 5;
  const Mesh given = make_edge_block(spec);
  const std::vector<Index> top = boundary_nodes(given, "surface");
  const auto step = [&](std::size_t k) {
    return given.nodes(top[k], 0) - given.nodes(top[k + 1], 0);
  };
  CHECK(step(0) / step(6) == Approx(20).epsilon(1e-12).margin(0));
  CHECK(step(12) == Approx(0.25).epsilon(1e-14).margin(0));
}

TEST_CASE("half-spaces that cannot be made are refused by name", "[half]") {
  const auto message = [](auto&& change) {
    HalfSpaceSpec spec;
    change(spec);
    return argument_message([&] { static_cast<void>(make_half_space(spec)); });
  };
  using Spec = HalfSpaceSpec;
  CHECK_THAT(message([](Spec& s) { s.core.x() = 0; }), ContainsSubstring("got 0 and 1"));
  CHECK_THAT(
      message([](Spec& s) { s.width = 1; }),
      ContainsSubstring("make_half_space 'half-space': width must be above that of the core"));
  CHECK_THAT(message([](Spec& s) { s.depth = 0.5; }), ContainsSubstring("depth must be above"));
  CHECK_THAT(message([](Spec& s) { s.layers = 0; }), ContainsSubstring("got 8, 8 and 0"));
  CHECK_THAT(message([](Spec& s) { s.layer_grading = 0; }), ContainsSubstring("layer_grading"));
  const auto edge_message = [](auto&& change) {
    EdgeBlockSpec spec;
    change(spec);
    return argument_message([&] { static_cast<void>(make_edge_block(spec)); });
  };
  using Edge = EdgeBlockSpec;
  CHECK_THAT(edge_message([](Edge& s) { s.edge = 10; }), ContainsSubstring("0 < edge < width"));
  CHECK_THAT(edge_message([](Edge& s) { s.depth = -1; }), ContainsSubstring("got -1"));
  CHECK_THAT(edge_message([](Edge& s) { s.cells_deep = 1; }), ContainsSubstring("8, 8 and 1"));
  CHECK_THAT(edge_message([](Edge& s) { s.grading_beside = 0; }), ContainsSubstring("gradings"));
}
