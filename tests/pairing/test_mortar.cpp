#include <cmath>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/fem/assembly.hpp"
#include "support/facing_blocks.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

TEST_CASE("the operator's own points suffice for sides with their midpoint off the middle",
          "[mortar]") {
  Mesh source = block({0, 1}, {3, 1}, 3, MeshOrder::Quadratic);
  const std::vector<Index> nodes = boundary_nodes(source, "bottom");
  for (std::size_t k = 1; k < nodes.size(); k += 2) source.nodes(nodes[k], 0) += 0.2;
  const Mesh target = block({-1, 0}, {5, 1}, 4);
  GapOptions many;
  many.points = 16;
  const Pairs pairs = over(source, target);
  const Pairs exact = over(source, target, many);
  CHECK((MatrixXd(pairs.opening) - MatrixXd(exact.opening)).cwiseAbs().maxCoeff() <= 1e-13);
  const NodeArray force = on_nodes(pairs.opening, pairs.weight);
  const VectorXd share = boundary_weights(source, "bottom", {1});
  for (std::size_t k = 0; k < nodes.size(); ++k)
    CHECK(force(nodes[k], 1) == Approx(share(static_cast<Index>(k))).epsilon(1e-13));
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
