// Ties of meshes that do not match, under a uniform stress.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "addons/equations/equations.hpp"
#include "addons/prediction/prediction.hpp"
#include "catch_compat.hpp"
#include "signorini/core/rounding.hpp"
#include "support/tied_stack.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace signorini;
using namespace stacked_blocks;

// The upper body has no support at all: the tie alone holds it.
TEST_CASE("a uniform stress passes a tie of meshes that do not match", "[ties][patch]") {
  const Vector3d stress = GENERATE(Vector3d(0, 2, 0), Vector3d(1, -3, 0.5), Vector3d(-2, 1, 1));
  const double angle = GENERATE(0.0, 0.4, 2.0);
  const Units unit = GENERATE(Units{1, 1}, Units{1e-3, 1e6});
  for (const std::string& element : all_elements) {
    CAPTURE(element, angle, unit.length, stress.transpose());
    Scene scene = stack(element, unit);
    for (Body& body : scene.bodies) body.mesh = turned_by(angle, body.mesh);
    load_uniformly(unit.stress * stress, angle, scene);
    const SolvedScene run = solved(scene, "the stack");
    CHECK(stress_error(run, unit.stress * stress) <= 1e-11);
    CHECK(run.solution.certificate.holds());
    CHECK(run.model.modes.empty());
  }
}

// Supports hold the ends of both sides, so that the rows of these nodes have nothing to hold, and the traction there is borne by others.
TEST_CASE("a uniform stress passes a tie whose ends are held on both sides", "[ties][patch]") {
  const double angle = GENERATE(0.0, 0.4);
  const int source_cells = GENERATE(1, 2, 3, 7);  // of one cell all nodes are held, and nobody is left to bear what they would
  const bool slides = GENERATE(false, true);
  const Vector3d stress(1, -3, slides ? 0 : 0.5);
  const double shear = 2 * 1.3 / 1000;  // 2 (1 + nu) / E
  const double xx = 1.3 / 1000 * (0.7 * stress(0) - 0.3 * stress(1));
  const double yy = 1.3 / 1000 * (0.7 * stress(1) - 0.3 * stress(0));
  const Eigen::Matrix2d strain{{xx, shear * stress(2)}, {0, yy}};
  const Eigen::Rotation2Dd turn(angle);
  const Eigen::Matrix2d there = turn.toRotationMatrix() * strain * turn.inverse().toRotationMatrix();
  for (const std::string& element : all_elements) {
    CAPTURE(element, angle, source_cells, slides);
    Scene scene = stack(element);
    scene.bodies[1].mesh = block_of(element, "upper", {0, 2}, {6, 2}, source_cells, 2);
    scene.bonds = bonds_of({tie_of({"bottom", "upper"}, Side{"top", "lower"}, slides)});
    for (Body& body : scene.bodies) {
      body.mesh = turned_by(angle, body.mesh);
      for (const char* side : {"left", "right", body.mesh.name == "lower" ? "bottom" : "top"})
        body.supports.push_back({side, true, true, [there](const Vector2d& x) { return Vector2d(there * x); }});
    }
    const SolvedScene run = solved(scene, "the stack");
    const Eigen::Matrix2d tensor =
        turn.toRotationMatrix() * Eigen::Matrix2d{{stress(0), stress(2)}, {stress(2), stress(1)}} * turn.inverse().toRotationMatrix();
    for (std::size_t b = 0; b < 2; ++b) {
      const BodyModel& body = run.model.bodies[b];
      const NodeArray& u = run.solution.displacements[b];
      const NodeArray exact = body.mesh.nodes * there.transpose();
      CHECK((u - exact).cwiseAbs().maxCoeff() <= 1e-12 * exact.cwiseAbs().maxCoeff());
    }
    const BondForces sum = bond_forces(run.model, run.solution)[0];
    CHECK(sum.least_pressure == Approx(3).epsilon(1e-10));
    CHECK(sum.largest_pressure == Approx(3).epsilon(1e-10));
    CHECK(sum.largest_shear == Approx(slides ? 0 : 0.5).epsilon(1e-10).margin(1e-12));
    const Vector2d out = turn * Vector2d(0, -1);
    CHECK((sum.force - Vector2d(6 * tensor * out)).norm() <= 1e-10 * 18);
  }
}

// Bodies of revolution: pulled along the axis they grow thinner alike, whatever their radii.
TEST_CASE("a uniform stress along the axis passes a tie of bodies of revolution", "[ties][patch]") {
  const double radius = GENERATE(0.0, 1.5);
  for (const std::string& element : all_elements) {
    CAPTURE(element, radius);
    Scene scene = stack(element);
    for (Body& body : scene.bodies) {
      body.mesh = moved(body.mesh, {radius, 0});
      body.material.state = PlaneState::Axial;
      body.material.thickness = 1;
    }
    scene.bodies[0].supports = {symmetric("bottom")};
    EdgeLoad pull;
    pull.boundary = "top";
    pull.traction = [](const Vector2d&) { return Vector2d(0, 2); };
    scene.bodies[1].loads.edges = {pull};
    const SolvedScene run = solved(scene, "the cylinders");
    CHECK(stress_error(run, {0, 2, 0}) <= 1e-11);
    CHECK(bond_forces(run.model, run.solution)[0].force.y() ==
          Approx(-2 * pi * (std::pow(radius + 6, 2) - radius * radius)).epsilon(1e-11));
  }
}

// A quadratic side whose edges each face two dozen: hundreds of small entries, of which none may be lost.
TEST_CASE("a tie of a coarse side with a fine one is as exact as any", "[ties]") {
  Scene scene = stack("q8");
  scene.bodies[0].mesh = block_of("q8", "lower", {0, 0}, {6, 2}, 220, 1);
  scene.bodies[1].mesh = block_of("q8", "upper", {0, 2}, {6, 2}, 9, 1);
  load_uniformly({1, 2, 0.5}, 0, scene);
  const SolvedScene run = solved(scene, "the stack");
  CHECK(stress_error(run, {1, 2, 0.5}) <= 1e-11);
  CHECK(run.solution.certificate.penetration <= 1e-13);
}

// Four blocks that meet in one point, each tied to its neighbours, and no two meshes match.
TEST_CASE("ties that cross pass the patch test", "[ties][patch]") {
  for (const std::string element : {"q4", "q8", "t6"}) {
    CAPTURE(element);
    const Material material{1000, 0.3, PlaneState::Strain};
    const auto piece = [&](const std::string& name, double x, double y, Index nx, Index ny) {
      return body_of(block_of(element, name, {x, y}, {2, 2}, nx, ny), element, material);
    };
    Scene scene;
    scene.bodies = {piece("a", 0, 0, 4, 3), piece("b", 2, 0, 3, 5), piece("c", 0, 2, 3, 4),
                    piece("d", 2, 2, 5, 3)};
    const auto pull = [](const std::string& side, const Vector2d& traction) {
      EdgeLoad load;
      load.boundary = side;
      load.traction = [traction](const Vector2d&) { return traction; };
      return load;
    };
    scene.bodies[0].supports = {symmetric("left"), symmetric("bottom")};
    scene.bodies[1].supports = {symmetric("bottom")};
    scene.bodies[1].loads.edges = {pull("right", {-1, 0})};
    scene.bodies[2].supports = {symmetric("left")};
    scene.bodies[2].loads.edges = {pull("top", {0, 2})};
    scene.bodies[3].loads.edges = {pull("right", {-1, 0}), pull("top", {0, 2})};
    scene.bonds = bonds_of({tie_of({"bottom", "c"}, Side{"top", "a"}),
                            tie_of({"bottom", "d"}, Side{"top", "b"}),
                            tie_of({"left", "b"}, Side{"right", "a"}),
                            tie_of({"left", "d"}, Side{"right", "c"})});
    CHECK(stress_error(solved(scene, "the blocks"), {-1, 2, 0}) <= 1e-11);
  }
}

// What a run takes is told before it with the equations in K.
TEST_CASE("the forecast of a scene with ties counts what equations join", "[ties]") {
  for (const std::string element : {"q4", "q8"}) {
    Scene scene = stack(element);
    load_uniformly({0, 2, 0}, 0, scene);
    const Prediction prediction = predict(plan(scene));
    const Solution solution = solve(scene);
    const auto figure = std::find_if(
        prediction.figures.begin(), prediction.figures.end(),
        [](const PredictedFigure& one) { return one.what == "stiffness entries"; });
    REQUIRE(figure != prediction.figures.end());
    CHECK(figure->amount == double(solution.ledger.counted("assembly", "stiffness entries")));
  }
}
