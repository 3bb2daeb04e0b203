#include <algorithm>
#include <cmath>

#include "addons/motion/curvature.hpp"
#include "catch_compat.hpp"
#include "signorini/contact/node_to_obstacle.hpp"
#include "support/waves.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

/// Central differences of a function of the places.
template <typename Forces>
MatrixXd differences(const NodeArray& places, const Forces& forces) {
  const double h = 1e-6;
  MatrixXd all(places.size(), places.size());
  for (Index k = 0; k < all.cols(); ++k) {
    NodeArray one = places;
    NodeArray other = places;
    one(k / 2, k % 2) += h;
    other(k / 2, k % 2) -= h;
    all.col(k) = (forces(one) - forces(other)) / (2 * h);
  }
  return all;
}

/// |B - D| / |B| against differences with shares as they are where nothing moves.
double error_with_shares_held(const Waves& waves, const VectorXd& force) {
  const NodeArray first = waves.places();
  const MatrixXd B = contact_curvature(waves.points(first), force, first);
  const MatrixXd D = differences(first, [&](const NodeArray& places) -> VectorXd {
    return held_rows(waves, places, first).transpose() * force;
  });
  return (B - D).norm() / B.norm();
}

/// The greatest |Bv - dF|/|Bv| of some smooth displacements, another one of each body, with the library's own forces F.
double error_of_smooth_displacements(const Waves& waves, const VectorXd& force) {
  const NodeArray first = waves.places();
  const MatrixXd B = contact_curvature(waves.points(first), force, first);
  double worst = 0;
  for (int wave = 0; wave < 6; ++wave) {
    NodeArray v(first.rows(), 2);
    for (Index node = 0; node < v.rows(); ++node)
      for (const int axis : {0, 1}) {
        const double other = node < waves.source.n_nodes() ? 0 : 1;
        const double phase = axis + wave + 0.7 * other * (1 + wave);
        v(node, axis) = std::sin((1.1 + 0.2 * wave) * first(node, 0) + phase) + 0.3 * other;
      }
    const double h = 1e-6;
    const VectorXd change = (waves.at(first + h * v).opening.transpose() * force -
                             waves.at(first - h * v).opening.transpose() * force) /
                            (2 * h);
    const VectorXd Bv = B * Eigen::Map<const VectorXd>(v.data(), v.size());
    worst = std::max(worst, (Bv - change).norm() / Bv.norm());
  }
  return worst;
}

}  // namespace

// B is exact but for the rule of the integrals, whose own error changes as cuts move. Two points in the half of a wedge with the
// angle a see 24 (a/2)^4 / 4320 of what they integrate wrongly, 4e-6 of a = 0.33; on parabolas there are three points, but more
// than a wedge to integrate. Differences add 1e-10.
TEST_CASE("B is what differences of the nodes' forces are, of straight sides and of parabolas",
          "[motion]") {
  for (const MeshOrder order : orders)
    for (const double gap : {-0.01, 0.0, 0.001, 0.05}) {
      CAPTURE(static_cast<int>(order), gap);
      WavesSpec spec;
      spec.gap = gap;
      spec.target_order = order;
      const Waves waves(spec);
      const VectorXd force = some_force(waves.at(waves.places()));
      CHECK(error_with_shares_held(waves, force) <= (order == MeshOrder::Linear ? 1e-5 : 1e-4));
    }
}

// Shares follow the lengths of the source: what that does is not symmetric, and smaller by the square of an edge.
TEST_CASE("of smooth displacements B tells the change of the library's own forces to 1 %",
          "[motion]") {
  for (const MeshOrder source : orders)
    for (const MeshOrder target : orders)
      for (const double gap : {-0.01, 0.0, 0.05}) {
        CAPTURE(static_cast<int>(source), static_cast<int>(target), gap);
        const Waves waves({17, 6, source, target, gap});
        const VectorXd force = some_force(waves.at(waves.places()));
        CHECK(error_of_smooth_displacements(waves, force) <= 0.01);
      }
}

// The normal jumps at nodes of the source, on whose two sides dual functions differ. A node that moves off its target by h comes
// to lie in a wedge, half of it on each edge; B knows of no wedge, which is the square of the turn of 0.1 between two
// sides. Pairs at the ends would see the end of the source as well.
TEST_CASE("B holds where the nodes of source and target lie on each other", "[motion]") {
  WavesSpec spec;
  spec.source_edges = spec.target_edges = 13;
  spec.grading = 1;
  Waves waves(spec);
  waves.target.nodes.col(0) = 0.37 + (2.6 / 3.4) * waves.target.nodes.col(0).array();
  for (Index k = 0; k < waves.target.n_nodes(); ++k) {
    const double x = waves.target.nodes(k, 0);
    waves.target.nodes(k, 1) =
        (waves.target.nodes(k, 1) < -0.25 ? -0.5 : 0) + 0.2 * std::sin(1.7 * x + 0.3);
  }
  VectorXd force = some_force(waves.at(waves.places()));
  for (const Index end : {Index(0), force.size() - 2}) force.segment<2>(end).setZero();
  CHECK(error_with_shares_held(waves, force) <= 0.01);
}

TEST_CASE("B is symmetric, linear in the forces, and as objective as they are", "[motion]") {
  for (const MeshOrder source : orders)
    for (const MeshOrder target : orders)
      for (const double gap : {-0.01, 0.0, 0.05}) {
        CAPTURE(static_cast<int>(source), static_cast<int>(target), gap);
        const Waves waves({9, 7, source, target, gap});
        const NodeArray places = waves.places();
        KeptPoints kept;
        const Pairs pairs = waves.at(places, &kept);
        const VectorXd force = some_force(pairs);
        const MatrixXd B = contact_curvature(kept, force, places);
        CHECK((B - B.transpose()).cwiseAbs().maxCoeff() == 0);
        // A few dozen terms of either sign that are larger than their sums, each rounded.
        const double rounding = 1e-13 * B.cwiseAbs().rowwise().sum().maxCoeff();
        NodeArray v = NodeArray::Zero(places.rows(), 2);
        const auto moved = [&] { return B * Eigen::Map<const VectorXd>(v.data(), v.size()); };
        v.col(0).setOnes();
        CHECK(moved().cwiseAbs().maxCoeff() <= rounding);
        v.col(1).setConstant(-0.7);
        CHECK(moved().cwiseAbs().maxCoeff() <= rounding);
        // A turn about the origin by 1 rad for each unit: forces turn by as much.
        v << -places.col(1), places.col(0);
        const NodeArray push = on_nodes(pairs.opening, force);
        NodeArray turned(push.rows(), 2);
        turned << -push.col(1), push.col(0);
        CHECK((moved() - Eigen::Map<const VectorXd>(turned.data(), turned.size()))
                  .cwiseAbs()
                  .maxCoeff() <= rounding);
        CHECK(contact_curvature(kept, 0 * force, places).nonZeros() == 0);
        CHECK(contact_curvature({}, force, places).nonZeros() == 0);
        VectorXd other = force;
        std::reverse(other.begin(), other.end());
        const MatrixXd sum = contact_curvature(kept, 2 * force + other, places);
        CHECK((sum - 2 * B - MatrixXd(contact_curvature(kept, other, places)))
                  .cwiseAbs()
                  .maxCoeff() <= rounding);
      }
}

TEST_CASE("an obstacle turns normals by 1/(R + gap), and a flat one by nothing", "[motion]") {
  const Mesh mesh = block({0, 0}, {1, 1}, 4);
  const Vector2d centre(0.4, -2);
  GapOptions options;
  options.n_nodes = mesh.n_nodes();
  const auto at = [&](const Obstacle& obstacle, const NodeArray& places) {
    Mesh there = mesh;
    there.nodes = places;
    return node_to_obstacle({there, "bottom"}, obstacle, options);
  };
  const auto points = [&](const Obstacle& obstacle, const Pairs& pairs) {
    return kept_points(pairs, {mesh, "bottom"}, obstacle);
  };
  const Obstacle round = disc(centre, 1.5);
  const Pairs pairs = at(round, mesh.nodes);
  const VectorXd force = some_force(pairs);
  const MatrixXd B = contact_curvature(points(round, pairs), force, mesh.nodes);
  const MatrixXd D = differences(mesh.nodes, [&](const NodeArray& places) -> VectorXd {
    return at(round, places).opening.transpose() * force;
  });
  CHECK((B - D).norm() <= 1e-8 * D.norm());  // differences of both
  const Index pair = 2;
  const Vector2d arm = pairs.position.row(pair).transpose() - centre;
  const Index column = 2 * pairs.node[2];
  const double expected = force(pair) * arm.y() * arm.y() / std::pow(arm.norm(), 3);
  CHECK(std::abs(B(column, column) - expected) <= 1e-8 * expected);
  const Obstacle plane = half_plane({0, -1}, {0.3, 1});
  const Pairs flat = at(plane, mesh.nodes);
  CHECK(contact_curvature(points(plane, flat), force, mesh.nodes).nonZeros() == 0);
}
