// Scenes that broke an earlier version: each must be solved and certified, or refused by name.
#include <cmath>
#include <limits>

#include "addons/frontal/frontal_factor.hpp"
#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/scene.hpp"

namespace {

using namespace signorini;
using Eigen::Index;

Scene beam(double length, double height, Index nx, Index ny, const char* element) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("beam", {0, 0}, {length, height}, nx, ny,
                    std::string(element) == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear);
  body.element = element;
  body.material = {1e6, 0.3, PlaneState::Stress, 1};
  body.supports = {fixed("left")};
  scene.contacts = {{{"bottom"}, half_plane({0, -1}, {0, 1})}};
  return scene;
}

}  // namespace

// Built backwards from forces of which a third is zero: every gap is zero, a third of the pairs neither
// open nor pressed. Rounding puts such a pair on either side.
TEST_CASE("pairs that just touch without force do not keep the solver busy", "[degenerate]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Ledger ledger;
    Model model = build(beam(50, 50, 10, 2, "q8"), ledger);
    const Index pairs = model.programme.A.rows();
    Eigen::VectorXd force(pairs);
    unsigned state = 12345 + 977 * seed;
    for (Index i = 0; i < pairs; ++i) {
      state = state * 1664525U + 1013904223U;
      const double draw = static_cast<double>(state >> 8) / 16777216.0;
      force(i) = draw < 1.0 / 3.0 ? 0 : draw;
    }
    Eigen::VectorXd load = model.programme.load - model.programme.A.transpose() * force;
    const Condensed factor = condense(model, ledger);
    model.programme.initial_gap = model.programme.A * factor.factor.solve(load);
    const Condensed condensed = condense(model, ledger);
    const Solution solution = solve(model, condensed, primal_dual_active_set(), {});
    CHECK(solution.contact.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.holds());
  }
}

TEST_CASE("a body too slender for double precision is never called solved", "[slender]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible"}) {
    CAPTURE(element);
    Scene scene = beam(1e5, 1, 200, 1, element);
    scene.bodies[0].loads.edges = {{"top", 1e-9, {}}};
    try {
      const Solution solution = solve(scene);
      CHECK(
          (solution.contact.report.status != SolveStatus::Solved || solution.certificate.holds()));
    } catch (const ProblemError& refused) {
      CHECK_THAT(refused.what(), ContainsSubstring("slender"));
    }
  }
}

TEST_CASE("a free body never passes the factor, whatever its size", "[free]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible"})
    for (Index nx = 1; nx <= 8; ++nx)
      for (Index ny = 1; ny <= 5; ++ny) {
        CAPTURE(element, nx, ny);
        Scene scene = beam(3, 1.1, nx, ny, element);
        const Unknowns unknowns = number_unknowns(scene.bodies[0].mesh, {});
        const LinearSystem system = assemble(scene.bodies[0].mesh, find_element(element),
                                             scene.bodies[0].material, unknowns, {});
        Ledger ledger;
        CHECK_THROWS_AS(FrontalFactor(system.stiffness, separator_tree(system.stiffness), ledger),
                        ProblemError);
      }
}

TEST_CASE("a node that belongs to no cell is named", "[input]") {
  Scene scene = beam(50, 5, 4, 2, "q4");
  scene.bodies[0].mesh.nodes.conservativeResize(scene.bodies[0].mesh.n_nodes() + 1, 2);
  scene.bodies[0].mesh.nodes.bottomRows<1>() << 7, 7;
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("node 15") && ContainsSubstring("no cell"));
}

// cos(pi/2) is 6e-17, not 0: it must not count as a direction in which a held node can give way.
TEST_CASE("a normal tilted by rounding is the axis it was meant to be", "[contact]") {
  Scene scene = beam(50, 5, 20, 2, "q4");
  scene.bodies[0].supports = {prescribed("left", Axis::Y, -0.1), symmetric("right")};
  scene.contacts[0].target = half_plane({0, 0}, {std::cos(pi / 2), 1});
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("is held by supports and overlaps"));
}

TEST_CASE("what a scene says about a normal of the wrong length", "[contact]") {
  Scene scene = beam(50, 5, 4, 2, "q4");
  scene.contacts[0].target = Obstacle{"stretched", [](const Eigen::Vector2d& x) {
                                        return ObstacleContact{x.y() + 1, {0, 2}};
                                      }};
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("must have length 1, got 2"));
}

TEST_CASE("a side that is listed twice is refused", "[input]") {
  Scene scene = beam(50, 5, 4, 2, "q4");
  scene.bodies[0].mesh.boundaries["bottom"].push_back({0, 0});
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("lists side 0 of cell 0 twice"));
}

TEST_CASE("a slender plate pressed flat keeps its gaps closed to rounding", "[hard][certificate]") {
  for (const double thickness : {0.03, 0.02, 0.01}) {
    Scene scene = beam(1, thickness, 23, 2, "q4_incompatible");
    scene.contacts[0].target = half_plane({0, 0}, {0, 1});
    scene.bodies[0].material.state = PlaneState::Strain;
    scene.bodies[0].loads.edges = {{"top", 0, [](const Eigen::Vector2d& x) {
                                      const double far = x.x() - 0.4;
                                      return Eigen::Vector2d(0, -std::exp(-50 * far * far));
                                    }}};
    const Solution solution = solve(scene);
    REQUIRE(solution.contact.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.holds(1e-14));
  }
}
