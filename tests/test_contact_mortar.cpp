#include <cmath>

#include "catch_compat.hpp"
#include "signorini/contact/mortar.hpp"
#include "signorini/elasticity/assembly.hpp"
#include "signorini/mesh/block.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using signorini_test::problem_message;

namespace {

Mesh block(Vector2d corner, Vector2d size, Index edges, MeshOrder order = MeshOrder::Linear,
           double grading = 1) {
  BlockSpec spec;
  spec.corner = corner;
  spec.size = size;
  spec.cells_x = edges;
  spec.order = order;
  spec.grading_x = grading;
  return make_block(spec);
}

Mesh turned(const Mesh& mesh, double angle) {
  return mapped(mesh, [angle](const Vector2d& x) -> Vector2d {
    return {std::cos(angle) * x.x() - std::sin(angle) * x.y(),
            std::sin(angle) * x.x() + std::cos(angle) * x.y()};
  });
}

/// The bottom of one body over the top of another one, whose nodes come after.
Pairs over(const Mesh& source, const Mesh& target, GapOptions options = {}) {
  options.n_nodes = source.n_nodes() + target.n_nodes();
  return mortar({source, "bottom", 0}, {target, "top", source.n_nodes()}, options);
}

/// Force on every node, `n x 2`, of pair forces on rows of N or S.
NodeArray on_nodes(const NodalRows& rows, const VectorXd& force) {
  const VectorXd flat = rows.transpose() * force;
  return Eigen::Map<const NodeArray>(flat.data(), flat.size() / 2, 2);
}

constexpr MeshOrder orders[] = {MeshOrder::Linear, MeshOrder::Quadratic};

}  // namespace

TEST_CASE("a uniform pressure reaches a covered target as if it were a load", "[mortar]") {
  for (const MeshOrder source_order : orders)
    for (const MeshOrder target_order : orders)
      for (const double angle : {0.0, 0.7}) {
        const Mesh source = turned(block({-0.35, 1.5}, {3, 1}, 5, source_order, 1.7), angle);
        const Mesh target = turned(block({0, 0}, {2, 1}, 7, target_order, 0.6), angle);
        const Pairs pairs = over(source, target);
        const NodeArray force = on_nodes(pairs.opening, pairs.weight);
        const Vector2d down(std::sin(angle), -std::cos(angle));
        NodeArray load = NodeArray::Zero(target.n_nodes(), 2);
        const VectorXd share = boundary_weights(target, "top", 1);
        const std::vector<Index> nodes = boundary_nodes(target, "top");
        for (std::size_t k = 0; k < nodes.size(); ++k)
          load.row(nodes[k]) = share(static_cast<Index>(k)) * down.transpose();
        CHECK((force.bottomRows(target.n_nodes()) - load).cwiseAbs().maxCoeff() <= 1e-14);
        CHECK(pairs.weight.sum() == Approx(2).epsilon(1e-14));
        CHECK(pairs.weight.minCoeff() > 0);
      }
}

TEST_CASE("forces balance and normal forces turn nothing", "[mortar]") {
  const auto quadrature = GENERATE(Quadrature::Segments, Quadrature::SourceEdges);
  const Mesh source =
      mapped(block({0, 1}, {3, 1}, 6, MeshOrder::Quadratic), [](const Vector2d& x) -> Vector2d {
        return {x.x(), x.y() + 0.1 * std::sin(2 * x.x())};
      });
  for (const MeshOrder order : orders) {
    const Mesh target =
        mapped(block({0.4, -0.5}, {3, 1}, 7, order), [](const Vector2d& x) -> Vector2d {
          return {x.x(), x.y() - 0.2 * std::cos(3 * x.x())};
        });
    GapOptions options;
    options.sliding = true;
    options.quadrature = quadrature;
    const Pairs pairs = over(source, target, options);
    const VectorXd some = VectorXd::LinSpaced(pairs.weight.size(), 1, 2);
    MatrixXd nodes(source.n_nodes() + target.n_nodes(), 2);
    nodes << source.nodes, target.nodes;
    for (const NodalRows& rows : {pairs.opening, pairs.sliding}) {
      const NodeArray force = on_nodes(rows, some);
      CHECK(force.colwise().sum().cwiseAbs().maxCoeff() <= 1e-13);
    }
    const NodeArray force = on_nodes(pairs.opening, some);
    const double moment = nodes.col(0).dot(force.col(1)) - nodes.col(1).dot(force.col(0));
    CHECK(std::abs(moment) <= 1e-13);
  }
}

TEST_CASE("over a straight target the gap of a corner is its own", "[mortar]") {
  // Straight lines between the corners are what dual functions read off exactly.
  const double angle = 0.3;
  const Mesh target = turned(block({-1, -1}, {6, 1}, 4), angle);
  const Mesh source = block({0, 2}, {3, 1}, 5, MeshOrder::Linear, 2);
  const Pairs pairs = over(source, target);
  REQUIRE(pairs.node == boundary_nodes(source, "bottom"));
  const Vector2d normal(-std::sin(angle), std::cos(angle));
  for (Index pair = 0; pair < 6; ++pair) {
    const Vector2d position =
        source.nodes.row(pairs.node[static_cast<std::size_t>(pair)]).transpose();
    CHECK(pairs.initial_gap(pair) == Approx(normal.dot(position)).epsilon(1e-14));
    CHECK((pairs.normal.row(pair).transpose() - normal).norm() <= 1e-15);
    CHECK(pairs.position.row(pair).transpose() == position);
    // Own node of the source: the normal; no other one.
    const NodeArray row = on_nodes(pairs.opening, VectorXd::Unit(6, pair));
    NodeArray own = NodeArray::Zero(source.n_nodes(), 2);
    own.row(pairs.node[static_cast<std::size_t>(pair)]) = normal.transpose();
    CHECK((row.topRows(source.n_nodes()) - own).cwiseAbs().maxCoeff() <= 1e-14);
  }
}

TEST_CASE("gaps between a disc and a flat are second order", "[mortar][hertz]") {
  // Curved parabolas below, or polygons; either body may be the source. R = 5, half width 1.
  const auto disc_above = [](const Vector2d& x) -> Vector2d {
    return {x.x(), x.y() + (5 - std::sqrt(25 - x.x() * x.x())) * (2 - x.y())};
  };
  const auto disc_below = [](const Vector2d& x) -> Vector2d {
    return {x.x(), x.y() - (5 - std::sqrt(25 - x.x() * x.x())) * (x.y() + 1)};
  };
  for (const MeshOrder order : orders)
    for (const bool source_is_disc : {true, false}) {
      double error[2];
      for (const int fine : {0, 1}) {
        const Index n = fine == 0 ? 8 : 64;
        Mesh source = block({-1, 1}, {2, 1}, n, order);
        Mesh target = block({-1.2, -1}, {2.4, 1}, n / 8 * 11, order);
        if (source_is_disc)
          source = mapped(source, disc_above);
        else
          target = mapped(target, disc_below);
        const Pairs pairs = over(source, target);
        error[fine] = 0;
        for (Index pair = 0; pair < pairs.weight.size(); ++pair) {
          const double x = pairs.position(pair, 0);
          // From a point above a disc, the distance from its centre less the radius.
          const double exact = source_is_disc ? 6 - std::sqrt(25 - x * x) : std::hypot(x, 6) - 5;
          error[fine] += 0.5 * pairs.weight(pair) * std::abs(pairs.initial_gap(pair) - exact);
        }
      }
      CAPTURE(source_is_disc, static_cast<int>(order), error[0], error[1]);
      CHECK(error[0] < 0.25 * 0.25 / (12 * 5) *
                           1.1);  // an edge of h = 1/4 rises by h^2/8R, seen by 2/3 at most
      CHECK(error[1] < error[0] / 55 + 1e-15);  // 64; exact for corners of a polygon above a flat
    }
}

TEST_CASE("a source that hangs over carries nothing there", "[mortar]") {
  // Edges of length 1 over a target from 1.3 to 3.9, so edges 1, 2, 3 are covered by .7, 1, .9.
  for (const MeshOrder order : orders) {
    const Mesh source = block({0, 1}, {6, 1}, order == MeshOrder::Linear ? 6 : 3, order);
    const Mesh target = block({1.3, 0}, {2.6, 1}, 5);
    const Pairs pairs = over(source, target);
    CHECK(pairs.weight.sum() == Approx(2.6).epsilon(1e-14));
    // Of the share of node 1 on edge 1 only .49 is covered: node 2 takes the edge. That of node 4 on
    // edge 3 is covered by .81.
    REQUIRE(pairs.weight.size() == 3);
    for (const Index pair : {0, 1, 2})
      CHECK(pairs.position(pair, 0) == 2.0 + static_cast<double>(pair));
    CHECK(pairs.weight(0) == Approx(1.2).epsilon(1e-14));
    CHECK(pairs.weight(2) == Approx(0.405).epsilon(1e-13));
    std::vector<double> without;
    for (const Index node : pairs.unpaired) without.push_back(source.nodes(node, 0));
    CHECK(without == std::vector<double>{0, 1, 5, 6});
  }
}

TEST_CASE("a target inside one edge of the source still meets it", "[mortar]") {
  const Mesh source = block({0, 1}, {4, 1}, 2);
  const Mesh target = block({0.4, 0}, {0.3, 1}, 3);  // nearer to the first node
  const Pairs pairs = over(source, target);
  REQUIRE(pairs.weight.size() == 1);
  CHECK(pairs.node[0] == 0);
  CHECK(pairs.weight(0) == Approx(0.3).epsilon(1e-13));
  CHECK(pairs.initial_gap(0) == Approx(0).margin(1e-15));
  CHECK(pairs.unpaired == std::vector<Index>{1, 2});
}

TEST_CASE("the gaps of a side of three nodes see its parabola", "[mortar]") {
  const Mesh source = block({0, 1}, {2, 1}, 1, MeshOrder::Quadratic);
  const Pairs pairs = over(source, block({-1, 0}, {4, 1}, 3));
  REQUIRE(pairs.node == boundary_nodes(source, "bottom"));
  // Moved by 1, the midpoint makes a parabola 1 - x^2 over [-1, 1]. The best straight line through it on
  // [0, 1] is 7/6 - x: the gap of the midpoint opens by 7/6, those of the corners by 1/6.
  const Index middle = pairs.node[1];
  CHECK(pairs.opening.coeff(0, 2 * middle + 1) == Approx(1.0 / 6).epsilon(1e-13));
  CHECK(pairs.opening.coeff(1, 2 * middle + 1) == Approx(7.0 / 6).epsilon(1e-13));
  CHECK(pairs.opening.coeff(2, 2 * middle + 1) == Approx(1.0 / 6).epsilon(1e-13));
}

TEST_CASE("segments make what is integrated smooth at a valley and at a ridge of the target",
          "[mortar]") {
  // In a valley the source changes sides on the bisector, and all is straight between: 2 points are exact.
  // Above a ridge it faces the vertex from one normal to the other, where the gap is a root: 7 points do.
  const Mesh source = block({-1, 1}, {2.2, 1}, 3);
  for (const double slope : {0.4, -0.4}) {
    const Mesh target = mapped(block({-3, -1}, {6, 1}, 2), [slope](const Vector2d& x) -> Vector2d {
      return {x.x(),
              x.y() + (slope > 0 ? slope * std::abs(x.x()) : -1.2 + slope * std::abs(x.x()))};
    });
    GapOptions many;
    many.points = 16;
    GapOptions few;
    few.points = slope > 0 ? 2 : 7;
    const Pairs exact = over(source, target, many);
    const Pairs pairs = over(source, target, few);
    CAPTURE(slope);
    CHECK((pairs.initial_gap - exact.initial_gap).cwiseAbs().maxCoeff() <= 1e-13);
    CHECK((MatrixXd(pairs.opening) - MatrixXd(exact.opening)).cwiseAbs().maxCoeff() <= 1e-13);
  }
}

TEST_CASE("a number of points without a rule is refused", "[mortar]") {
  const Mesh source = block({0, 1}, {2, 1}, 2);
  for (const int points : {-1, 17}) {
    GapOptions options;
    options.points = points;
    CHECK_THAT(problem_message([&] {
                 static_cast<void>(over(source, block({0, 0}, {2, 1}, 3), options));
               }),
               ContainsSubstring("1 to 16 points"));
  }
}

TEST_CASE("the thickness multiplies weights only", "[mortar]") {
  const Mesh source = block({0, 1.5}, {2, 1}, 3);
  const Mesh target = block({0, 0}, {2, 1}, 4);
  GapOptions thick;
  thick.thickness = 2.5;
  const Pairs one = over(source, target);
  const Pairs more = over(source, target, thick);
  CHECK((more.weight - 2.5 * one.weight).norm() <= 1e-15);
  CHECK((more.opening - one.opening).norm() == 0);
  CHECK(more.initial_gap == one.initial_gap);
  CHECK(one.sliding.nonZeros() == 0);
}
