// Loads in balance on bodies that only contact stops, and that touch nothing: what K leaves of rigid motions is
// rounding, which no contact force carries.
#include "catch_compat.hpp"
#include "support/two_bodies.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

struct Squeezed {
  double length;
  Eigen::Index cells;
  const char* element;
  bool upright;  ///< pressed on top and bottom and beside a wall, or on both ends
};

Scene scene_of(const Squeezed& given) {
  const bool quadratic = std::string(given.element) == "q8";
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = named_block("block", {0.1, 1e-3}, {given.length, 1}, given.cells, 3,
                          quadratic ? MeshOrder::Quadratic : MeshOrder::Linear);
  body.element = given.element;
  body.material = {1e3, 0.499, PlaneState::Strain, 1};
  body.loads.edges = {{given.upright ? "top" : "left", 1, {}},
                      {given.upright ? "bottom" : "right", 1, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  if (given.upright)
    scene.contacts.push_back({{"left"}, half_plane({0, 0}, {1, 0})});
  else
    body.supports = {prescribed_at("top", {0.1, 1.001}, Axis::X)};
  return scene;
}

}  // namespace

// Each broke down with the imbalance in the one node that grounds K^-1, where it is some 1e-12 of the load.
TEST_CASE("a squeezed block above a plane is solved though K feels its rigid motions",
          "[contact][hard][floating]") {
  for (const Squeezed& given :
       {Squeezed{1, 4, "q8", false}, Squeezed{1, 4, "q8", true}, Squeezed{1, 13, "q4", true},
        Squeezed{10, 4, "q4", false}, Squeezed{10, 13, "q4", false}, Squeezed{10, 13, "q4", true},
        Squeezed{10, 13, "q8", false}, Squeezed{100, 13, "q4", false},
        Squeezed{100, 13, "q8", false}}) {
    CAPTURE(given.length, given.cells, given.element, given.upright);
    const SolvedScene run = solved(scene_of(given), "the block");
    CHECK(run.solution.certificate.holds());
    CHECK(run.solution.contact.active().empty());
    // The other way it is free to grow: q / E (1 - nu^2) along the load, q / E nu (1 + nu) across.
    const NodeArray& u = run.solution.displacements[0];
    const double along = u.col(0).maxCoeff() - u.col(0).minCoeff();
    const double strain = given.upright ? 0.499 * 1.499e-3 : (1 - 0.499 * 0.499) * 1e-3;
    CHECK(along == Approx(strain * given.length).epsilon(1e-8));
  }
}

// Whether a pair holds a motion is measured in its own system: neither by forces of others, nor by rounding of its own.
TEST_CASE("a light block is held by its small forces though a heavy one stands beside it",
          "[contact][hard][floating]") {
  for (const double small : {1.0, 1e-14, 1e-30}) {
    CAPTURE(small);
    Scene scene;
    scene.bodies.resize(2);
    for (int b = 0; b < 2; ++b) {
      Body& body = scene.bodies[static_cast<std::size_t>(b)];
      body.mesh = named_block(b == 0 ? "heavy" : "light", {2.0 * b, 0}, {1, 1}, 3, 3);
      body.material = {1e3, 0.25, PlaneState::Strain, 1};
      body.supports = {symmetric("left")};
      body.loads.edges = {{"top", b == 0 ? 1 : small, {}}};
      scene.contacts.push_back({{"bottom", body.mesh.name}, half_plane({0, 0}, {0, 1})});
    }
    const SolvedScene run = solved(scene, "the blocks");
    for (const std::string& note : run.solution.notes)
      CHECK(note.find("do not determine how far") == std::string::npos);
    CHECK(run.solution.contact.force.tail(run.solution.contact.force.size() / 2).sum() ==
          Approx(small).epsilon(1e-12));
  }
}

TEST_CASE("where rounding of the stiffness is more than a certificate allows, that is said",
          "[contact][hard][floating]") {
  for (const double length : {1.0, 10.0})
    for (const Eigen::Index cells : {4, 13, 30})
      for (const char* element : {"q4", "q4_incompatible", "q8"})
        for (const bool upright : {false, true}) {
          const Solution solution = solve(scene_of({length, cells, element, upright}));
          CAPTURE(length, cells, element, upright, solution.contact.reason);
          if (solution.contact.report.status == SolveStatus::Solved) continue;
          CHECK(solution.certificate.worst() <= 1e-10);
          CHECK_THAT(solution.contact.reason,
                     ContainsSubstring("rounding of the stiffness pushes along rigid motions"));
        }
}
