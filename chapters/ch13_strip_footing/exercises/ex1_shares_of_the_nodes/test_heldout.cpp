#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "meshes/half_space.hpp"
#include "signorini/scene/readings.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using ex13_1::force_between;
using ex13_1::largest_deviation;

namespace {

// Half of the footing of Lin et al., section 3.3, on soil as wide and deep as `far`, 2 m thick.
signorini::Scene footing(Index under, Index beside, Index deep, double grading, double far) {
  signorini::EdgeBlockSpec soil;
  soil.edge = 1.5;
  soil.width = soil.depth = far;
  soil.cells_under = under;
  soil.cells_beside = beside;
  soil.cells_deep = deep;
  soil.grading_under = grading;
  signorini::Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh =
      signorini::make_graded_block("footing", soil.under(), signorini::stretched(0, {{2, 4, 2}}));
  scene.bodies[0].material = {2e7, 0.25, signorini::PlaneState::Strain, 1};
  scene.bodies[0].supports = {signorini::symmetric("left")};
  scene.bodies[0].loads.edges = {{"top", 15, {}}};
  scene.bodies[1].mesh = signorini::make_edge_block(soil);
  scene.bodies[1].material = {2e4, 0.25, signorini::PlaneState::Strain, 1};
  scene.bodies[1].supports = {signorini::symmetric("axis"), signorini::fixed("base")};
  scene.contacts = {{{"surface", "soil"}, signorini::Side{"bottom", "footing"}}};
  return scene;
}

double deviation(const signorini::Scene& scene, double within) {
  const signorini::SolvedScene run = signorini::solved(scene, "the footing");
  const signorini::Mesh& soil = run.model.bodies[1].mesh;
  std::vector<Index> nodes = signorini::boundary_nodes(soil, "loaded");
  std::reverse(nodes.begin(), nodes.end());
  const signorini::NodeArray force = signorini::contact_forces(run.model, run.solution, 1);
  const VectorXd x = soil.nodes(nodes, 0), down = -force(nodes, 1);
  return largest_deviation(x, down, 1.5, 45, within);
}

}  // namespace

// The derivative of the integral is (46): central differences, error of the order of their step squared.
TEST_CASE("ex13.1 held out: the slope of the force is the pressure", "[ex13.1]") {
  for (const double x : {-1.9, -0.3, 0.0, 1.2}) {
    const double pressure = 7 / (std::acos(-1.0) * std::sqrt(4 - x * x));
    CHECK(force_between(2, 7, x - 1e-4, x + 1e-4) / 2e-4 == Approx(pressure).epsilon(1e-6));
  }
}

TEST_CASE("ex13.1 held out: nodes across the whole strip, and none at all", "[ex13.1]") {
  VectorXd x(3), force(3);
  x << -1, 0, 1;
  force << 1, 1, 1;  // a third each: arcsin(1/2) again
  CHECK(largest_deviation(x, force, 1, 3, 1) < 1e-14);
  CHECK(largest_deviation(VectorXd(), VectorXd(), 1, 3, 1) == 0);
}

// Margins: half of the last digit that the chapter quotes.
TEST_CASE("ex13.1 held out: the meshes of the chapter", "[ex13.1]") {
  CHECK(deviation(footing(7, 9, 5, 4, 15), 1.2) == Approx(0.0239).margin(5e-5));
  CHECK(deviation(footing(7, 9, 5, 4, 15), 1.5) == Approx(0.1621).margin(5e-5));
  CHECK(deviation(footing(30, 40, 34, 64, 60), 1.2) < 2.5e-3);
}

TEST_CASE("ex13.1 held out: input that makes no sense is refused", "[ex13.1]") {
  VectorXd x(2), force(2);
  x << 0, 1;
  force << 1, 1;
  CHECK_THROWS_AS(force_between(0, 1, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(largest_deviation(x, force.head(1), 1, 3, 1), std::invalid_argument);
  CHECK_THROWS_AS(largest_deviation(x.reverse(), force, 1, 3, 1), std::invalid_argument);
}
