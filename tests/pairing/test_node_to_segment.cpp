#include <cmath>

#include "catch_compat.hpp"
#include "meshes/ring.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/pairing/node_to_segment.hpp"
#include "support/interfaces.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::RowVector2d;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// One cell over one cell: a quarter of the source's side hangs over each end of the target's.
TwoBodies two_cells(MeshOrder order = MeshOrder::Linear) {
  return two_blocks({0.5, 3.5, 1}, {0, 4, 1}, 0.25, Form::Flat, order);
}

/// What a row holds for one node of the source, or of the target.
RowVector2d entry(const NodalRows& rows, Index row, Index node) {
  return {rows.coeff(row, 2 * node), rows.coeff(row, 2 * node + 1)};
}

Index node_at(const Mesh& mesh, const Vector2d& x) {
  Index found = -1;
  for (Index k = 0; k < mesh.n_nodes(); ++k)
    if ((mesh.nodes.row(k).transpose() - x).norm() < 1e-12) found = k;
  return found;
}

const GapOperator& member() { return find_gap_operator("node_to_segment"); }

Mesh quarter(const char* name, double inner, double outer, MeshOrder order) {
  AnnulusSpec spec;
  spec.name = name;
  spec.inner_radius = inner;
  spec.outer_radius = outer;
  spec.cells_angle = 6;
  spec.sector = Sector::Quarter;
  spec.order = order;
  return make_annulus(spec);
}

}  // namespace

TEST_CASE("the gap over a side: its place and its motion are those of the nodes, by their shares",
          "[gap_operators][LinEtAl-20][LinEtAl-21][LinEtAl-22]") {
  const TwoBodies bodies = two_cells();
  const Pairs pairs = pairs_of(member(), bodies);
  REQUIRE(pairs.node == std::vector<Index>{0, 1});
  CHECK(pairs.position.row(0) == RowVector2d(0.5, 0.25));
  CHECK(pairs.position.row(1) == RowVector2d(3.5, 0.25));
  CHECK(pairs.initial_gap == Eigen::Vector2d(0.25, 0.25));
  NodeArray u = NodeArray::Zero(all_nodes(bodies).rows(), 2);
  const Index first = bodies.source.n_nodes();
  const Index left = first + node_at(bodies.target, {0, 0});
  const Index right = first + node_at(bodies.target, {4, 0});
  u.row(0) << 0.3, 0.1;
  u.row(left) << 0.7, 0.04;
  u.row(right) << -0.7, 0.08;
  // Under node 0 at 1/8 of the side the target rises by 0.045.
  const VectorXd gap = pairs.initial_gap + pairs.opening * flat(u);
  CHECK(gap(0) == Approx(0.25 + 0.1 - 0.045).epsilon(1e-15));
  CHECK(gap(1) == Approx(0.25 - 0.075).epsilon(1e-15));
}

TEST_CASE("a force on a node is the opposite one on the nodes of the side, by their shares",
          "[gap_operators][LinEtAl-23][LinEtAl-25][LinEtAl-27]") {
  const TwoBodies bodies = two_cells();
  const Pairs pairs = pairs_of(member(), bodies);
  const Index first = bodies.source.n_nodes();
  CHECK(entry(pairs.opening, 0, 0) == RowVector2d(0, 1));
  CHECK(entry(pairs.opening, 0, first + node_at(bodies.target, {0, 0})) == RowVector2d(0, -0.875));
  CHECK(entry(pairs.opening, 0, first + node_at(bodies.target, {4, 0})) == RowVector2d(0, -0.125));
  CHECK(pairs.opening.row(0).nonZeros() == 3);
}

TEST_CASE("friction on a node runs along the tangent, and back on the side",
          "[gap_operators][LinEtAl-24][LinEtAl-26][LinEtAl-27]") {
  const TwoBodies bodies = two_cells();
  const Pairs pairs = pairs_of(member(), bodies);
  const Index first = bodies.source.n_nodes();
  CHECK(entry(pairs.sliding, 0, 0) == RowVector2d(1, 0));
  CHECK(entry(pairs.sliding, 0, first + node_at(bodies.target, {0, 0})) == RowVector2d(-0.875, 0));
  CHECK(entry(pairs.sliding, 0, first + node_at(bodies.target, {4, 0})) == RowVector2d(-0.125, 0));
}

TEST_CASE("a side of three nodes carries a node by its parabolas", "[gap_operators][LinEtAl-27]") {
  const TwoBodies bodies = two_cells(MeshOrder::Quadratic);
  const Pairs pairs = pairs_of(member(), bodies);
  REQUIRE(pairs.opening.rows() == 3);
  const Index first = bodies.source.n_nodes();
  // At 1/8 of the side, xi = -3/4.
  CHECK(entry(pairs.opening, 0, first + node_at(bodies.target, {0, 0})).y() == -0.65625);
  CHECK(entry(pairs.opening, 0, first + node_at(bodies.target, {2, 0})).y() == -0.4375);
  CHECK(entry(pairs.opening, 0, first + node_at(bodies.target, {4, 0})).y() == 0.09375);
}

TEST_CASE("a node weighs what a pressure of one does along its normal", "[gap_operators]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    const TwoBodies bodies = two_blocks({0.5, 3.5, 4}, {0, 4, 3}, 0.1, Form::Curved, order);
    const Pairs pairs = pairs_of(member(), bodies);
    const NodeArray area = boundary_areas(bodies.source, "bottom", {0.5});
    const Eigen::VectorXd along = -area.cwiseProduct(pairs.normal).rowwise().sum();
    CHECK((pairs.weight - along).norm() <= 1e-15 * along.norm());
    CHECK(pairs.node == boundary_nodes(bodies.source, "bottom"));
  }
}

TEST_CASE("a corner of the source looks midway between its sides", "[gap_operators]") {
  TwoBodies bodies = two_blocks({1, 3, 2}, {0, 4, 3}, 0.1, Form::Flat, MeshOrder::Linear);
  std::vector<CellSide>& around = bodies.source.boundaries["around"];
  for (const char* name : {"right", "bottom"})
    for (const CellSide& side : boundary(bodies.source, name)) around.push_back(side);
  bodies.source_boundary = "around";
  const Pairs pairs = pairs_of(member(), bodies);
  CHECK(pairs.node == std::vector<Index>{2, 0, 1});
  CHECK(pairs.unpaired.size() == 2);  // further up on the right
}

TEST_CASE("g + N u is the gap of the moved bodies, up to the square of the motion",
          "[gap_operators][LinEtAl-22]") {
  Random random(2);
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    const TwoBodies bodies = two_blocks({0.5, 3.5, 5}, {0, 4, 7}, 0.1, Form::Curved, order);
    const Pairs pairs = pairs_of(member(), bodies);
    NodeArray u(all_nodes(bodies).rows(), 2);
    for (Index k = 0; k < u.size(); ++k) u.data()[k] = random.uniform(-1, 1);
    const auto error = [&](double size) {
      TwoBodies moved = bodies;
      const Index n = bodies.source.n_nodes();
      moved.source.nodes += size * u.topRows(n);
      moved.target.nodes += size * u.bottomRows(u.rows() - n);
      const VectorXd gap = pairs.initial_gap + size * (pairs.opening * flat(u));
      return (pairs_of(member(), moved).initial_gap - gap).norm();
    };
    CHECK(error(1e-4) < 1e-6);
    CHECK(error(1e-4) / error(1e-5) == Approx(100).epsilon(0.1));
  }
}

TEST_CASE("between matching quarter rings all normals are radial, also on the lines of symmetry",
          "[gap_operators]") {
  for (const double gap : {0.0, 0.15})
    for (const bool shaft_is_source : {false, true}) {
      CAPTURE(gap, shaft_is_source);
      TwoBodies bodies{quarter("shaft", 1, 2, MeshOrder::Linear),
                       quarter("tunnel", 2 + gap, 4, MeshOrder::Linear), "outer", "inner"};
      if (!shaft_is_source) bodies = {bodies.target, bodies.source, "inner", "outer"};
      const Pairs pairs = pairs_of(member(), bodies);
      REQUIRE(pairs.unpaired.empty());
      for (Index row = 0; row < pairs.normal.rows(); ++row) {
        const Vector2d out = pairs.position.row(row).transpose().normalized();
        const Vector2d n = pairs.normal.row(row).transpose();
        CHECK((n - (shaft_is_source ? -out : out)).norm() < 1e-14);
        CHECK(pairs.initial_gap(row) == Approx(gap).margin(1e-15));
      }
    }
}

TEST_CASE("columns for too few nodes and a thickness that is none are a caller's mistake",
          "[gap_operators]") {
  const TwoBodies bodies = two_cells();
  GapOptions options = options_for(bodies);
  options.n_nodes -= 1;
  CHECK_THAT(argument_message([&] { static_cast<void>(pairs_of(member(), bodies, options)); }),
             ContainsSubstring("options.n_nodes"));
  options = options_for(bodies);
  options.depth.factor = 0;
  CHECK_THAT(argument_message([&] { static_cast<void>(pairs_of(member(), bodies, options)); }),
             ContainsSubstring("thickness"));
}

// d = (u' - u) sin(theta) - (v' - v) cos(theta), with theta = 0.7 and u, v of the place that faces i'.
TEST_CASE("between two bodies a row of A is (sin, -cos) at i' and the opposite at the place of i",
          "[gap_operators][closed-form][XuanLi2002-13]") {
  const TwoBodies bodies =
      two_blocks({0.3, 3.6, 3}, {0, 4, 2}, 0.25, Form::Inclined, MeshOrder::Linear);
  const Pairs pairs = pairs_of(member(), bodies);
  const NodalRows A = -pairs.opening;
  const RowVector2d closing(std::sin(0.7), -std::cos(0.7));
  const Index first = bodies.source.n_nodes();
  const Index middle = first + node_at(bodies.target, turned({2, 0}, 0.7));
  REQUIRE(A.rows() == 4);
  for (Index pair = 0; pair < 4; ++pair) {
    CHECK((entry(A, pair, pairs.node[static_cast<std::size_t>(pair)]) - closing).norm() < 1e-15);
    RowVector2d target = RowVector2d::Zero();
    for (Index k = first; k < first + bodies.target.n_nodes(); ++k) target += entry(A, pair, k);
    CHECK((target + closing).norm() < 1e-15);
    const double share = 1 - std::abs(0.3 + 1.1 * static_cast<double>(pair) - 2) / 2;
    CHECK((entry(A, pair, middle) + share * closing).norm() < 1e-14);
  }
}
