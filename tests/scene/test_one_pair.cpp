// Bodies that one closed pair carries, or none: their position is not determined, and the solution says so.
#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "papers/solver_table.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/scene.hpp"

using namespace signorini;

namespace {

const std::vector<const char*> family = {"primal_dual_active_set", "quasi_active_set",
                                         "goldfarb_idnani", "fischer_burmeister", "lemke"};

/// A disc under its own weight on a plane, with the lowest node as the only one that carries it.
Scene disc_on_plane(Eigen::Index cells) {
  Scene scene;
  DiscSpec disc;
  disc.name = "disc";
  disc.centre = {0, 1};
  disc.core_cells = cells;
  disc.layers = cells;
  Body& body = scene.bodies[0];
  body.mesh = make_disc(disc);
  body.supports = {prescribed_at("rim", {0, 0}, Axis::X)};
  body.loads.body_force = [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, -1e-6); };
  scene.contacts = {{{"rim"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

/// A block whose weight a pull balances: it hovers.
Scene hovering_block() {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0.5}, {1, 1}, 4, 4);
  body.supports = {symmetric("left")};
  body.loads.edges = {{"top", -1e-3, {}}};
  body.loads.body_force = [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, -1e-3); };
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

}  // namespace

TEST_CASE("a disc that rests on one node is solved by the family, and free to roll",
          "[floating][hard]") {
  for (const Eigen::Index cells : {3, 4, 5})
    for (const char* solver : family) {
      Scene scene = disc_on_plane(cells);
      scene.solver = find_solver(solver);
      const Solution solution = solve(scene);
      CAPTURE(cells, solver);
      REQUIRE(solution.contact.report.status == SolveStatus::Solved);
      CHECK(solution.certificate.worst() <= 1e-13);
      const Eigen::VectorXd& force = solution.contact.force;  // a neighbour may touch without any
      CHECK((force.array() > 1e-12 * force.sum()).count() == 1);
      REQUIRE_FALSE(solution.notes.empty());  // how far it turned may be noted as well
      CHECK_THAT(solution.notes[0], ContainsSubstring("disc") && ContainsSubstring("turn") &&
                                        ContainsSubstring("do not determine"));
    }
}

TEST_CASE("a block that hovers is solved, and that its height is open is said",
          "[floating][hard]") {
  for (const char* solver : family) {
    Scene scene = hovering_block();
    scene.solver = find_solver(solver);
    const Solution solution = solve(scene);
    CAPTURE(solver);
    REQUIRE(solution.contact.report.status == SolveStatus::Solved);
    CHECK(solution.contact.active().empty());
    REQUIRE(solution.notes.size() == 2);
    CHECK_THAT(solution.notes[0], ContainsSubstring("do not determine"));
    CHECK_THAT(solution.notes[1], ContainsSubstring("no pair carries a force"));
  }
}
