#include <cmath>
#include <vector>

#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/readings.hpp"
#include "support/facing_blocks.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

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
        const VectorXd share = boundary_weights(target, "top", {1});
        const std::vector<Index> nodes = boundary_nodes(target, "top");
        for (std::size_t k = 0; k < nodes.size(); ++k)
          load.row(nodes[k]) = share(static_cast<Index>(k)) * down.transpose();
        CHECK((force.bottomRows(target.n_nodes()) - load).cwiseAbs().maxCoeff() <= 1e-14);
        CHECK(pairs.weight.sum() == Approx(2).epsilon(1e-14));
        CHECK(pairs.weight.minCoeff() > 0);
      }
}

TEST_CASE("an overhang or an offset of five digits is seen", "[mortar]") {
  const Mesh source = block({-1e-5, 1}, {2 + 3e-5, 1}, 4);
  const Mesh target = block({0, 0}, {2, 1}, 4);
  const Pairs pairs = over(source, target);
  CHECK(pairs.weight.sum() == Approx(2).epsilon(1e-13));
  const NodeArray force = on_nodes(pairs.opening, pairs.weight).bottomRows(target.n_nodes());
  const VectorXd share = boundary_weights(target, "top", {1});
  const std::vector<Index> nodes = boundary_nodes(target, "top");
  for (std::size_t k = 0; k < nodes.size(); ++k)
    CHECK(force(nodes[k], 1) == Approx(-share(static_cast<Index>(k))).epsilon(1e-13));
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
  thick.depth.factor = 2.5;
  const Pairs one = over(source, target);
  const Pairs more = over(source, target, thick);
  CHECK((more.weight - 2.5 * one.weight).norm() <= 1e-15);
  CHECK((more.opening - one.opening).norm() == 0);
  CHECK(more.initial_gap == one.initial_gap);
  CHECK(one.sliding.nonZeros() == 0);
}

// Where the plate is tilted the sides of the block face it, too, from beside what hangs over.
TEST_CASE("a plate that lies on a block is pressed as hard whether the sides of the block count or not",
          "[mortar]") {
  const double tilt = GENERATE(-1.0, -0.2, 0.2, 1.0);
  const int cells = GENERATE(6, 10, 14, 48);
  const int flank = GENERATE(4, 64);  // cells of a side of the block
  const auto force = [&](const std::string& target) {
    const SolvedScene run = solved(
        parse_scene(text("material = { youngs_modulus = 1000, poisson_ratio = 0.3 }\n[[body]]\nname = \"low\"\n",
                         "mesh = { kind = \"block\", corner = [-0.5, -1], size = [1, 1], cells = [4, ", flank, "] }\n",
                         "fixed = \"bottom\"\n[[body]]\nname = \"up\"\nmesh = { kind = \"block\", corner = [-2, 0], ",
                         "size = [4, 2], cells = [", cells, ", 3], turn = ", tilt,
                         " }\nprescribed = { top = { x = 0, y = -0.01 } }\n[[contact]]\nsource = \"up.bottom\"\ntarget = ",
                         target, "\n"),
                    "plate", ".")
            .scene,
        "plate");
    return resultants(run.model, run.solution, {}).force.y();
  };
  CAPTURE(tilt, cells, flank);
  CHECK(force("[\"low.right\", \"low.top\", \"low.left\"]") == Approx(force("\"low.top\"")).epsilon(0.005));
}

// A right angle that points at a soft block is no end: both of its flanks are touched, however it is turned.
TEST_CASE("a soft block on a wedge bears on both of its flanks", "[mortar]") {
  const double turn = GENERATE(25.0, 38.0, 39.8, 40.2, 45.0, 52.0);
  const auto force = [&](const std::string& with) {
    const SolvedScene run = solved(
        parse_scene(text("[[body]]\nname = \"low\"\nmesh = { kind = \"block\", corner = [-2, -2], size = [2, 2], ",
                         "cells = [16, 16], turn = ", turn, " }\nmaterial = { youngs_modulus = 1e5, poisson_ratio = 0.3 }\n",
                         "fixed = [\"left\", \"bottom\"]\n[[body]]\nname = \"up\"\nmesh = { kind = \"block\", ",
                         "corner = [-1, 0], size = [2, 1], cells = [32, 16] }\nmaterial = { youngs_modulus = 100, ",
                         "poisson_ratio = 0.3 }\nprescribed = { top = { x = 0, y = -0.2 } }\n[[contact]]\n",
                         "source = \"up.bottom\"\ntarget = [\"low.right\", \"low.top\"]\n", with),
                    "wedge", ".")
            .scene,
        "wedge");
    return resultants(run.model, run.solution, {}).force;
  };
  CAPTURE(turn);
  const Vector2d others = force("operator = \"node_to_segment\"\n");
  CHECK((force("") - others).norm() < 1e-4 * others.norm());
}
