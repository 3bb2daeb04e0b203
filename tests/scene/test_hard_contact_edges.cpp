// Blocks on blocks where interfaces end, have corners, or carry next to nothing.
#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "meshes/half_space.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/rounding.hpp"
#include "support/two_bodies.hpp"

using Eigen::Index;
using namespace signorini;
using namespace signorini_test;

namespace {

/// How deep nodes of the lower block, which the operator does not look at, are inside the upper one.
double deepest_target_node(const Scene& scene, const SolvedScene& run) {
  const Mesh& lower = scene.bodies[0].mesh;
  const Mesh& upper = scene.bodies[1].mesh;
  const auto bottom = [&](double x) {  // of the upper block, moved, edges straight
    for (const CellSide& side : boundary(upper, "bottom")) {
      const std::vector<Index> ends = upper.side_nodes(side);
      const double t =
          (x - upper.nodes(ends[0], 0)) / (upper.nodes(ends[1], 0) - upper.nodes(ends[0], 0));
      if (t < 0 || t > 1) continue;
      const NodeArray& u = run.solution.displacements[1];
      return (1 - t) * u(ends[0], 1) + t * u(ends[1], 1);
    }
    return 0.0;
  };
  double deepest = 0;
  for (const Index node : boundary_nodes(lower, "top"))
    deepest =
        std::max(deepest, run.solution.displacements[0](node, 1) - bottom(lower.nodes(node, 0)));
  return deepest;
}

}  // namespace

// The upper block is 8 wide on a column of 2.2: 12 of its 17 nodes face nothing. Clamping projections to the
// ends of the column would put load there.
TEST_CASE("source nodes beyond the target bear nothing at all", "[contact][hard][overhang]") {
  for (const char* gap_operator : {"mortar", "node_to_segment", "gauss_points"}) {
    CAPTURE(gap_operator);
    Scene scene = two_blocks(named_block("lower", {-1.1, -2}, {2.2, 2}, 7, 6),
                             named_block("upper", {-4, 0}, {8, 2}, 16, 4));
    scene.bodies[1].supports = {prescribed_at("top", {0, 2}, Axis::X)};
    scene.bodies[1].loads.edges = {{"top", 5, {}}};
    scene.contacts[0].gap_operator = gap_operator;
    const SolvedScene run = solved(scene, "the overhang");
    CHECK(run.model.pairs.unpaired.size() == 12);
    CHECK_THAT(plan(scene).notes.back(), ContainsSubstring("12 source nodes face no target"));
    const NodeArray force = contact_forces(run.model, run.solution, 1);
    for (const Index node : boundary_nodes(scene.bodies[1].mesh, "bottom"))
      if (std::abs(scene.bodies[1].mesh.nodes(node, 0)) > 1.6)  // the edges there face nothing
        CHECK(force.row(node).norm() == 0);
    CHECK(run.solution.contact.force.sum() == Approx(40).epsilon(1e-12));
  }
}

// A column 3 wide under edges of the source of 0.5 and 0.125: its corners push where the source has no node. Overlap of target
// nodes over the 0.1 by which both are pressed together. Least with the finer side as the source.
TEST_CASE("a corner of the target inside an edge of the source", "[contact][hard][corner]") {
  const auto overlap = [](const char* gap_operator, double half, Index edges, bool finer) {
    Scene scene = two_blocks(named_block("lower", {-half, -2}, {2 * half, 2}, 40, 8),
                             named_block("upper", {-4, 0}, {8, 4}, edges, edges / 2));
    scene.bodies[1].supports = {prescribed("top", Axis::Y, -0.1),
                                prescribed_at("top", {0, 4}, Axis::X)};
    if (finer) scene.contacts = {{{"top", "lower"}, Side{"bottom", "upper"}}};
    scene.contacts[0].gap_operator = gap_operator;
    return deepest_target_node(scene, solved(scene, "the column")) / 0.1;
  };
  for (const double half : {1.5, 1.25, 1.6}) {
    CAPTURE(half);
    const double mortar = overlap("mortar", half, 32, false);
    const double nodes = overlap("node_to_segment", half, 32, false);
    CHECK(mortar < 0.4 * nodes);
    CHECK(nodes > 0.08);
    CHECK(overlap("mortar", half, 64, false) < 0.005);
    CHECK(overlap("node_to_segment", half, 64, false) > 0.025);
    CHECK(overlap("mortar", half, 32, true) < 0.002);
  }
  CHECK(overlap("mortar", 1.5, 32, false) < 0.0046);
}

TEST_CASE("blocks that touch without load stay where they are", "[contact][hard][touch]") {
  for (const bool floats : {false, true}) {
    CAPTURE(floats);
    Scene scene = two_blocks(named_block("lower", {-1, -2}, {2, 2}, 7, 6),
                             named_block("upper", {-1, 0}, {2, 2}, 9, 4));
    scene.bodies[1].supports = {floats ? prescribed_at("top", {-1, 2}, Axis::X) : fixed("top")};
    for (const char* solver : {"primal_dual_active_set", "fischer_burmeister", "quasi_active_set",
                               "goldfarb_idnani", "lemke"}) {
      CAPTURE(solver);
      scene.solver = find_solver(solver);
      const SolvedScene run = solved(scene, "the blocks");
      CHECK(run.solution.contact.report.iterations <= 2);
      CHECK(run.solution.contact.force.isZero(0));
      CHECK(run.solution.displacements[1].isZero(0));
    }
  }
}

// Load or gap down to 1e-16: the forces are those of 1e-3, scaled.
TEST_CASE("hardly any load, hardly any gap", "[contact][hard][tiny]") {
  enum class Small { Load, Gap, Pressing, GapAndPressing };
  for (const Small small : {Small::Load, Small::Gap, Small::Pressing, Small::GapAndPressing}) {
    Eigen::VectorXd first;
    for (int exponent = -3; exponent >= -16; --exponent) {
      CAPTURE(static_cast<int>(small), exponent);
      const double size = std::pow(10, exponent);
      const bool gap = small == Small::Gap || small == Small::GapAndPressing;
      Scene scene =
          two_blocks(named_block("lower", {-1.5, -2}, {3, 2}, 8, 6),
                     moved(named_block("upper", {-1, 0}, {2, 2}, 9, 4), {0, gap ? size : 0}));
      Body& upper = scene.bodies[1];
      if (small == Small::Load || small == Small::Gap) {
        upper.supports = {prescribed_at("top", {-1, upper.mesh.nodes.col(1).maxCoeff()}, Axis::X)};
        upper.loads.edges = {{"top", small == Small::Load ? size : 5, {}}};
      } else {
        upper.supports = {prescribed("top", Axis::Y, gap ? -2 * size : -size),
                          prescribed("top", Axis::X, 0)};
      }
      const SolvedScene run = solved(scene, "the blocks");
      CHECK(run.solution.contact.report.iterations <= 7);
      const Eigen::VectorXd force = run.solution.contact.force / (small == Small::Gap ? 1 : size);
      if (first.size() == 0) first = force;
      CHECK((force - first).norm() <= 1e-10 * first.norm());
    }
  }
}

// The pressure under the edge of a stiff punch has no limit: it grows by sqrt(2) each time the mesh is halved.
// Inside it falls to the closed form with first order, and the resultant is right on any mesh.
TEST_CASE("under a stiff punch judge the resultant and the inner part", "[contact][hard][punch]") {
  const double edge = 1.5;
  const double q = 15;
  double before = 0;
  for (const Index fine : {1, 2, 4}) {
    CAPTURE(fine);
    EdgeBlockSpec soil;
    soil.edge = edge;
    soil.width = soil.depth = 30;
    soil.cells_under = 12 * fine;
    soil.cells_beside = 13 * fine;
    soil.cells_deep = 14 * fine;
    soil.grading_under = 1;
    Scene scene =
        two_blocks(make_edge_block(soil),
                   make_graded_block("upper", soil.under(), stretched(0, {{1, 4 * fine, 1}})));
    scene.bodies[0].supports = {symmetric("axis"), fixed("base"), fixed("side")};
    scene.bodies[1].supports = {symmetric("left")};
    scene.bodies[1].loads.edges = {{"top", q, {}}};
    scene.bodies[1].material.youngs_modulus *= 1e6;
    scene.contacts = {{{"bottom", "upper"}, Side{"surface", "soil"}}};
    const SolvedScene run = solved(scene, "the punch");
    double worst = 0;
    for (Index i = 0; i < run.solution.pressure.size(); ++i)
      if (const double x = run.model.pairs.position(i, 0); x < 0.81 * edge)
        worst = std::max(worst, std::abs(run.solution.pressure(i) * pi *
                                             std::sqrt(edge * edge - x * x) / (2 * q * edge) -
                                         1));
    CHECK(worst < 0.05 / static_cast<double>(fine));
    CHECK(run.solution.contact.force.sum() == Approx(q * edge).epsilon(1e-12));
    const double peak = run.solution.pressure.maxCoeff() / q;
    if (before > 0) CHECK(peak / before == Approx(std::sqrt(2)).epsilon(0.01));
    before = peak;
  }
}

// Four Gauss points of each edge of a fine source on the edges of a coarse target: far more pairs than nodes can
// tell apart. The sets of closed pairs are dependent; forces on nodes are right all the same.
TEST_CASE("more pairs than the mesh can tell apart are solved", "[contact][hard][gauss_points]") {
  Scene scene = two_blocks(named_block("lower", {-1, -2}, {2, 2}, 4, 4),
                           named_block("upper", {-1, 0}, {2, 2}, 9, 4));
  scene.contacts[0].gap_operator = "gauss_points";
  scene.contacts[0].points = 4;
  for (const bool floats : {false, true}) {
    Body& upper = scene.bodies[1];
    if (floats) {
      upper.supports = {prescribed_at("top", {-1, 2}, Axis::X)};
      upper.loads.edges = {{"top", 5, {}}};
    } else {
      upper.supports = {prescribed("top", Axis::Y, -0.01), prescribed("top", Axis::X, 0)};
    }
    for (const char* solver : {"quasi_active_set", "goldfarb_idnani"}) {
      CAPTURE(floats, solver);
      scene.solver = find_solver(solver);
      const SolvedScene run = solved(scene, "the blocks");
      CHECK(run.solution.certificate.worst() <= 1e-14);
      const NodeArray reaction = support_forces(run.model, run.solution, 0);
      CHECK(run.solution.contact.force.sum() == Approx(reaction.col(1).sum()).epsilon(1e-11));
      if (floats) CHECK(run.solution.contact.force.sum() == Approx(10).epsilon(1e-11));
    }
  }
}
