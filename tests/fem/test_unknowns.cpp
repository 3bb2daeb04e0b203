#include <limits>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/unknowns.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::problem_message;

namespace {

Mesh plate() { return block("plate", {0, 0}, {3, 2}, 3, 2); }

std::string complaint(const Mesh& mesh, const std::vector<Support>& supports) {
  return problem_message([&] { static_cast<void>(number_unknowns(mesh, supports)); });
}

Index held_at(const Unknowns& unknowns, int axis) {
  return (unknowns.number.col(axis) < 0).count();
}

}  // namespace

TEST_CASE("free displacements are numbered without a hole, node by node", "[unknowns]") {
  const Mesh mesh = plate();
  const Unknowns unknowns = number_unknowns(mesh, {fixed("left")});
  CHECK(unknowns.count == 2 * mesh.n_nodes() - 2 * 3);
  Index next = 0;
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    for (int axis = 0; axis < 2; ++axis) {
      if (unknowns.number(node, axis) < 0) continue;
      CHECK(unknowns.number(node, axis) == next);
      CHECK(unknowns.node_of[static_cast<std::size_t>(next)] == node);
      ++next;
    }
  CHECK(next == unknowns.count);
  for (const Index node : boundary_nodes(mesh, "left"))
    CHECK((unknowns.number.row(node) < 0).all());
}

TEST_CASE("an unknown is described by node, place and direction", "[unknowns]") {
  const Mesh mesh = plate();
  const Unknowns unknowns = number_unknowns(mesh, {});
  CHECK(unknowns.describe(mesh, 2 * 6 + 1) == "node 6 at (2, 1), direction y");
  CHECK(unknowns.describe(mesh, 2 * 6) == "node 6 at (2, 1), direction x");
  CHECK(unknown_positions(mesh, unknowns).row(13) == Eigen::RowVector2d(2, 1));
}

TEST_CASE("symmetry holds what lies across the boundary and leaves what runs along it",
          "[unknowns][XuanLi2002-5]") {
  const Unknowns left = number_unknowns(plate(), {symmetric("left")});
  CHECK(held_at(left, 0) == 3);
  CHECK(held_at(left, 1) == 0);
  const Unknowns bottom = number_unknowns(plate(), {symmetric("bottom")});
  CHECK(held_at(bottom, 0) == 0);
  CHECK(held_at(bottom, 1) == 4);
}

TEST_CASE("symmetry on a boundary that is not parallel to an axis is refused by name",
          "[unknowns]") {
  const Mesh skew =
      mapped(plate(), [](const Vector2d& x) { return Vector2d(x.x() + 0.1 * x.y(), x.y()); });
  CHECK_THAT(complaint(skew, {symmetric("left")}),
             ContainsSubstring("'left'") && ContainsSubstring("parallel to an axis"));
  CHECK(complaint(skew, {symmetric("bottom")}).empty());
}

TEST_CASE("a displacement may vary along its boundary", "[unknowns]") {
  const Mesh mesh = plate();
  const Unknowns unknowns = number_unknowns(
      mesh, {prescribed("top", Axis::Y, [](const Vector2d& x) { return 0.1 * x.x() - 1; }),
             prescribed("left", Axis::X, 0.25)});
  for (const Index node : boundary_nodes(mesh, "top"))
    CHECK(unknowns.held(node, 1) == 0.1 * mesh.nodes(node, 0) - 1);
  for (const Index node : boundary_nodes(mesh, "left")) CHECK(unknowns.held(node, 0) == 0.25);
  CHECK(held_at(unknowns, 0) == 3);
  CHECK(held_at(unknowns, 1) == 4);
  CHECK((unknowns.held.array() != 0).count() == 4 + 3);
}

TEST_CASE("supports that agree at their common corner are accepted, others are not", "[unknowns]") {
  CHECK(complaint(plate(), {fixed("left"), fixed("bottom")}).empty());
  CHECK_THAT(complaint(plate(), {fixed("left"), prescribed("bottom", Axis::Y, -0.5)}),
             ContainsSubstring("support on 'bottom'") && ContainsSubstring("the node at (0, 0)") &&
                 ContainsSubstring("-0.5 in direction y") && ContainsSubstring("gives it 0"));
}

TEST_CASE("a support on an unknown boundary lists the known ones", "[unknowns]") {
  CHECK_THAT(complaint(plate(), {fixed("clamp")}),
             ContainsSubstring("no boundary 'clamp'") && ContainsSubstring("left, right"));
}

TEST_CASE("a displacement that is not finite is named with its boundary and node", "[unknowns]") {
  const ScalarField pole = [](const Vector2d& x) { return 1 / x.x(); };
  CHECK_THAT(complaint(plate(), {prescribed("bottom", Axis::X, pole)}),
             ContainsSubstring("'bottom'") && ContainsSubstring("node 0") &&
                 ContainsSubstring("not finite"));
}

TEST_CASE("a single node can be held, and must exist", "[unknowns]") {
  const signorini::Mesh mesh = signorini::block("block", {0, 0}, {2, 1}, 2, 1);
  const auto held_at = [&](double x) {
    return signorini::number_unknowns(
        mesh, {signorini::prescribed_at("bottom", {x, 0}, signorini::Axis::X, 0.3)});
  };
  const signorini::Unknowns unknowns = held_at(1);
  CHECK(unknowns.count == 2 * 6 - 1);
  CHECK(unknowns.number(1, 0) == -1);
  CHECK(unknowns.number(1, 1) >= 0);
  CHECK(unknowns.held(1, 0) == 0.3);
  CHECK(unknowns.held(0, 0) == 0);
  CHECK_THAT(problem_message([&] { static_cast<void>(held_at(1.2)); }),
             ContainsSubstring("'bottom'") && ContainsSubstring("no node lies at (1.2, 0)") &&
                 ContainsSubstring("node 1, lies at (1, 0)"));
}
