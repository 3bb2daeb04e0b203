// A body that nothing holds but the shape of what it lies in.
#include <cmath>

#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/fem/assembly.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/scene/readings.hpp"

using namespace signorini;
using Eigen::Vector2d;

namespace {

constexpr double radius = 4;  // of the bowl, about (0, 4)

double bowl(double x) { return radius - std::sqrt(radius * radius - x * x); }

/// A tool with a round bottom of the radius of the bowl lies in it, off its bottom by an angle about its centre.
Scene tool_in_bowl(const char* law, bool tool_is_source, double angle) {
  Scene scene;
  scene.bodies.resize(2);
  Body& base = scene.bodies[0];
  base.mesh = mapped(block("bowl", {-2, -1}, {4, 1}, 40, 10), [](const Vector2d& x) -> Vector2d {
    return {x.x(), x.y() + (x.y() + 1) * bowl(x.x())};
  });
  base.supports = {fixed("bottom")};
  Body& tool = scene.bodies[1];
  tool.mesh = mapped(block("tool", {-0.5, 0}, {1, 0.5}, 14, 8), [=](const Vector2d& x) -> Vector2d {
    const Vector2d arm(x.x(), x.y() + bowl(x.x()) * (1 - x.y() / 0.5) - radius);
    return {std::cos(angle) * arm.x() - std::sin(angle) * arm.y(),
            radius + std::sin(angle) * arm.x() + std::cos(angle) * arm.y()};
  });
  tool.loads.body_force = [](const Vector2d&) { return Vector2d(0, -1); };
  for (Body& body : scene.bodies) {
    body.element = "q4";
    body.material = {1e4, 0.3, PlaneState::Strain, 1};
    body.material.law = find_strain_law(law);
  }
  const Side of_bowl{"top", "bowl"};
  const Side of_tool{"bottom", "tool"};
  scene.contacts = {{tool_is_source ? of_tool : of_bowl, tool_is_source ? of_bowl : of_tool}};
  scene.path = Path{{1}, {}};
  return scene;
}

}  // namespace

// The pairs leave the slide along the bowl free. What resists it is that contact forces turn with it: the weight over the
// radius, 1e-5 of the stiffness of a cell. A certificate lets 1e-12 of the weight pass, and so 1e-12 of the radius; internal
// forces beside it are up to ten times the weight.
TEST_CASE("off the bottom of a round bowl, a body slides to it by its weight", "[motion]") {
  for (const char* law : {"neo_hooke", "st_venant_kirchhoff"})
    for (const bool tool_is_source : {true, false}) {
      CAPTURE(law, tool_is_source);
      Vector2d middle(1, 1);
      double pushed = 0;
      double weight = 0;
      const PathEnd end = solve_steps(
          tool_in_bowl(law, tool_is_source, 0.1), [&](const Model& model, const Step& step) {
            const Mesh& tool = model.bodies[1].mesh;
            CHECK(tool.nodes.col(0).mean() > 0.37);
            middle = (tool.nodes + step.solution.displacements[1]).colwise().mean();
            pushed = support_forces(model, step.solution, 0).col(1).sum();
            const BodyModel& body = model.bodies[1];
            weight = -nodal_loads(tool, body.element, body.material, body.loads).col(1).sum();
          });
      INFO(end.reason);
      REQUIRE(end.status == SolveStatus::Solved);
      CHECK(std::abs(middle.x()) <= 1e-10);
      CHECK(std::abs(pushed - weight) <= 1e-10 * weight);
    }
}

// Their tangents have a factor of which rounding is all that holds the slide. Corrections lead away from it, and springs are tried.
TEST_CASE("soft bodies slide to the bottom of a bowl in a few iterations", "[motion]") {
  for (const char* law : {"neo_hooke", "st_venant_kirchhoff"})
    for (const double angle : {0.02, 0.05}) {
      CAPTURE(law, angle);
      Scene scene = tool_in_bowl(law, true, angle);
      for (Body& body : scene.bodies) body.material.youngs_modulus = 100;
      const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
        CHECK(step.solution.ledger.counted("pairs", "searches") <= 25);
        const NodeArray there = model.bodies[1].mesh.nodes + step.solution.displacements[1];
        CHECK(std::abs(there.col(0).mean()) <= 1e-12);
      });
      INFO(end.reason);
      CHECK(end.status == SolveStatus::Solved);
    }
}
