// What the factor says about bodies that can move: which node, and along which axis.
#include "catch_compat.hpp"
#include "support/factors.hpp"
#include "support/message.hpp"

using Eigen::Index;
using namespace signorini;

namespace {

constexpr Index nodes_of_square = 36;

/// Two squares in one mesh; the second one stands where it is told, and may hang at the last node of the first.
Mesh squares(Eigen::Vector2d second, bool hinged) {
  Mesh mesh = signorini_test::block_for(q4(), {1, 1}, 5, 5);
  const Mesh other = mesh;
  const Index n = nodes_of_square;
  const Index shared = hinged ? 1 : 0;
  mesh.nodes.conservativeResize(2 * n - shared, 2);
  mesh.nodes.bottomRows(n - shared) =
      other.nodes.bottomRows(n - shared).rowwise() + second.transpose();
  const Index m = mesh.cells.rows();
  mesh.cells.conservativeResize(2 * m, 4);
  mesh.cells.bottomRows(m) = other.cells.array() + n - shared;
  return mesh;
}

std::string message(const Mesh& mesh, const std::vector<Support>& supports) {
  const Unknowns unknowns = number_unknowns(mesh, supports);
  const Eigen::SparseMatrix<double> K = assemble(mesh, q4(), {}, unknowns, {}).stiffness;
  Ledger ledger;
  return signorini_test::problem_message([&] {
    FrontalFactor(K, separator_tree(K, unknown_positions(mesh, unknowns)), ledger,
                  [&](Index unknown) { return unknowns.describe(mesh, unknown); });
  });
}

/// The node that a message names, -1 if it names none.
Index named_node(const std::string& message) {
  const std::size_t begin = message.find("(node ");
  return begin == std::string::npos ? -1 : std::stol(message.substr(begin + 6));
}

}  // namespace

TEST_CASE("a body that lacks a support: the message says along which axis it can move",
          "[mechanism]") {
  const Mesh mesh = signorini_test::block_for(q4(), {3, 2}, 6, 4);
  CHECK_THAT(message(mesh, {symmetric("bottom")}),
             ContainsSubstring("stiffness matrix is singular at unknown ") &&
                 ContainsSubstring("direction x") && ContainsSubstring("pivot") &&
                 ContainsSubstring("add a support"));
  CHECK_THAT(message(mesh, {symmetric("left")}), ContainsSubstring("direction y"));
  CHECK(message(mesh, {symmetric("left"), symmetric("bottom")}).empty());
}

TEST_CASE("a body that hangs at a hinge can turn round it, and is named", "[mechanism]") {
  const Mesh hinged = squares({1, 1}, true);
  const std::string said = message(hinged, {fixed("left")});
  CAPTURE(said);
  CHECK(named_node(said) >= nodes_of_square);
  Mesh held = hinged;  // at its upper side as well
  held.boundaries["top of the second"] = {{held.n_cells() - 1, 2}};
  CHECK(message(held, {fixed("left"), fixed("top of the second")}).empty());
}

TEST_CASE("of two bodies in one mesh the free one is named", "[mechanism]") {
  for (const Eigen::Vector2d& second : {Eigen::Vector2d(2, 0), {0, 1.5}, {0.5, 0.25}, {0, 0}}) {
    Mesh mesh = squares(second, false);
    mesh.boundaries["right of the second"] = {{mesh.n_cells() - 1, 1}};
    const std::string said = message(mesh, {fixed("left")});
    CAPTURE(said, second);
    CHECK(named_node(said) >= nodes_of_square);
    const std::string other = message(mesh, {fixed("right of the second")});
    CHECK((named_node(other) >= 0 && named_node(other) < nodes_of_square));
    CHECK(message(mesh, {fixed("left"), fixed("right of the second")}).empty());
  }
}
