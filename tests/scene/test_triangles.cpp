// Scenes on triangles and on mixed meshes.
#include "addons/files/gmsh.hpp"
#include "catch_compat.hpp"
#include "meshes/split.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::cantilever;
using signorini_test::problem_message;

namespace {

/// An arch pressed onto a plate, both straight from Gmsh; contact alone holds the arch up.
Scene arch_on_plate(const std::string& file) {
  Scene scene;
  scene.bodies.clear();
  for (Mesh& mesh : read_gmsh(SIGNORINI_TEST_DATA "/gmsh/" + file + ".msh")) {
    Body body;
    body.mesh = std::move(mesh);
    body.material = {1000, 0.3, PlaneState::Strain, 1};
    scene.bodies.push_back(std::move(body));
  }
  scene.bodies[0].supports = {fixed("base")};
  scene.bodies[1].supports = {prescribed_at("round", {1, 2}, Axis::X)};
  scene.bodies[1].loads.body_force = [](const Vector2d&) { return Vector2d(0, -10); };
  scene.contacts = {{{"shared", "arch"}, Side{"shared", "plate"}}};
  return scene;
}

}  // namespace

TEST_CASE("a file of Gmsh with triangles is solved as it is", "[triangles][gmsh]") {
  for (const char* file : {"mixed_linear_v41", "mixed_quadratic_v41"}) {
    CAPTURE(file);
    const SolvedScene run = solved(arch_on_plate(file), "arch");
    CHECK(run.solution.certificate.holds());
    const NodeArray arch = contact_forces(run.model, run.solution, 1);
    const NodeArray plate = contact_forces(run.model, run.solution, 0);
    const double weight = nodal_loads(run.model.bodies[1].mesh, run.model.bodies[1].element,
                                      run.model.bodies[1].material, run.model.bodies[1].loads)
                              .col(1)
                              .sum();
    CHECK(arch.col(1).sum() == Approx(-weight).epsilon(1e-12));
    CHECK(plate.col(1).sum() == Approx(weight).epsilon(1e-12));
    CHECK(run.solution.pressure.minCoeff() >= 0);
  }
}

TEST_CASE("the plan says which elements are on, and which are too stiff", "[triangles][plan]") {
  const auto planned = [](const char* element, bool mixed, PlaneState state, double nu) {
    Scene scene = cantilever(element, 10, 1);
    Body& body = scene.bodies[0];
    body.mesh = mixed ? split(body.mesh, {0, 1}) : split(body.mesh);
    body.material.state = state;
    body.material.poisson_ratio = nu;
    if (!mixed) body.element.clear();
    return plan(scene);
  };
  const Plan linear = planned("q4", false, PlaneState::Stress, 0.3);
  CHECK_THAT(linear.on.front(), ContainsSubstring("20 cells t3, "));
  REQUIRE(linear.notes.size() == 1);
  CHECK_THAT(linear.notes[0], ContainsSubstring("t3 (20 of 20 cells of 'beam') is too stiff"));
  const Plan mixed = planned("q4_bbar", true, PlaneState::Stress, 0.3);
  CHECK_THAT(mixed.on.front(), ContainsSubstring("12 cells q4_bbar and 4 of them t3, "));
  REQUIRE(mixed.notes.size() == 1);
  CHECK_THAT(mixed.notes[0], ContainsSubstring("t3 (4 of 12 cells of 'beam')"));
  const Plan locking = planned("q4_bbar", true, PlaneState::Strain, 0.49);
  REQUIRE(locking.notes.size() == 1);
  CHECK_THAT(locking.notes[0], ContainsSubstring("t3 locks for Poisson's ratio 0.49"));
  CHECK(planned("q8", false, PlaneState::Strain, 0.49).notes.empty());
  CHECK(planned("q8", true, PlaneState::Strain, 0.49).notes.empty());
  // Quadratic cells have right forces there, and stresses that oscillate.
  for (const bool some : {false, true}) {
    const Plan rubber = planned("q8", some, PlaneState::Strain, 0.4999);
    REQUIRE(rubber.notes.size() == 1);
    CHECK_THAT(rubber.notes[0], ContainsSubstring("oscillate") && ContainsSubstring("q4_bbar"));
    CHECK(planned("q8", some, PlaneState::Stress, 0.4999).notes.empty());
  }
}

// Both have the exact tip deflection in reach; the quadrilaterals that are left do not spoil the triangles.
TEST_CASE("a beam of mixed quadratic cells bends as one of q8", "[triangles]") {
  const auto tip = [](const Mesh& mesh) {
    Scene scene = cantilever("q8", 20, 2);
    if (mesh.n_cells() > 0) scene.bodies[0].mesh = mesh;
    scene.bodies[0].element.clear();
    scene.contacts.clear();
    const SolvedScene run = solved(scene, "beam");
    const Index node = boundary_nodes(run.model.bodies[0].mesh, "right").front();
    return run.solution.displacements[0](node, 1);
  };
  const Mesh whole = cantilever("q8", 20, 2).bodies[0].mesh;
  std::vector<Index> every_third;
  for (Index cell = 0; cell < whole.n_cells(); cell += 3) every_third.push_back(cell);
  const double exact = tip(whole);
  CHECK(tip(split(whole)) == Approx(exact).epsilon(2e-3));
  CHECK(tip(split(whole, every_third)) == Approx(exact).epsilon(2e-3));
}
