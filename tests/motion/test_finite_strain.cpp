// Finite strain of cells and bodies: derivatives, closed forms, turns, and small strain as their limit.
#include <cmath>

#include "addons/motion/finite_strain.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/stress.hpp"
#include "support/meshes.hpp"
#include "support/message.hpp"
#include "support/moving_blocks.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

/// A skew mesh away from the axis, of the cells of an element.
Mesh skew(const Element& element) {
  Mesh mesh = block_for(element, {1, 1}, 2, 1);
  for (Index k = 0; k < mesh.n_nodes(); ++k) {
    const double x = mesh.nodes(k, 0);
    const double y = mesh.nodes(k, 1);
    mesh.nodes.row(k) << 1 + x + 0.1 * y, y + 0.15 * x;
  }
  return mesh;
}

NodeArray random_nodes(Index n, double size, std::uint64_t seed) {
  Random random(seed);
  return NodeArray::NullaryExpr(n, 2, [&] { return random.uniform(-size, size); });
}

/// A unit block, pressed flat between smooth plates to a height in equal steps, free at its sides.
Scene pressed(const char* law, const char* element, double height, int steps,
              PlaneState state = PlaneState::Strain) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.element = element;
  body.mesh = block_for(find_element(element), {1, 1}, 3, 2);
  body.material = {1, 0.3, state, 1};
  body.material.law = find_strain_law(law);
  body.supports = {prescribed("bottom", Axis::Y, 0), prescribed("left", Axis::X, 0),
                   prescribed("top", Axis::Y, height - 1)};
  body.supports[2].history = "press";
  scene.path = Path{equal_steps(steps), {proportional("press")}};
  return scene;
}

struct Walked {
  PathEnd end;
  std::vector<Step> steps;
  std::vector<Index> iterations;
  std::vector<Vector2d> top;  ///< force of the support at the top
};

Walked walked(const Scene& scene) {
  Walked all;
  all.end = solve_steps(scene, [&](const Model& model, const Step& step) {
    all.steps.push_back(step);
    all.iterations.push_back(Index(step.solution.ledger.counted("pairs", "searches")) - 1);
    Vector2d sum(0, 0);
    const NodeArray force = support_forces(model, step.solution, model.bodies.size() - 1);
    for (const Index node : boundary_nodes(model.bodies.back().mesh, "top"))
      sum += force.row(node).transpose();
    all.top.push_back(sum);
  });
  return all;
}

}  // namespace

TEST_CASE("forces are the gradient of the energy, and the tangent is that of the forces",
          "[motion]") {
  for (const char* law : {"st_venant_kirchhoff", "neo_hooke"})
    for (const char* name : {"q4", "q4_bbar", "q8", "t3", "t6"})
      for (const PlaneState state : {PlaneState::Strain, PlaneState::Stress, PlaneState::Axial}) {
        CAPTURE(law, name, to_string(state));
        const Element& element = find_element(name);
        const Mesh mesh = skew(element);
        Material material{7, 0.3, state, state == PlaneState::Axial ? 1 : 0.4};
        material.law = find_strain_law(law);
        const NodeArray u = random_nodes(mesh.n_nodes(), 0.05, 1);
        const NodeArray way = random_nodes(mesh.n_nodes(), 1, 2);
        const double h = 1e-5;
        const NodeArray forces = internal_forces(mesh, element, material, u);
        const double before = strain_energy(mesh, element, material, u - h * way);
        const double after = strain_energy(mesh, element, material, u + h * way);
        // Central differences: h^2 of the third derivative, which is some 1e2 of the forces, and rounding / h.
        const double work = forces.cwiseProduct(way).sum();
        CHECK(std::abs((after - before) / (2 * h) - work) <= 1e-7 * forces.norm() * way.norm());
        const NodeArray change = (internal_forces(mesh, element, material, u + h * way) -
                                  internal_forces(mesh, element, material, u - h * way)) /
                                 (2 * h);
        NodeArray tangent = NodeArray::Zero(mesh.n_nodes(), 2);
        visit_cells(mesh, element, material, [&](const Cell& cell) {
          const CellAnswer answer = answer_of(cell, u);
          CHECK((answer.tangent - answer.tangent.transpose()).norm() == 0);
          const CellVector own = answer.tangent * gathered(cell, way);
          for (Index k = 0; k < cell.element.n_nodes; ++k)
            tangent.row(cell.node(k)) += own.segment<2>(2 * k).transpose();
        });
        CHECK((tangent - change).norm() <= 1e-7 * tangent.norm());
      }
}

// In one step each. Homogeneous strain is exact in every element: the numbers are those of the law, to rounding of the
// stiffness that a certificate of 1e-12 leaves.
TEST_CASE("a block between smooth plates has the force and the width of the closed form",
          "[motion]") {
  const double nu = 0.3;
  const double mu = 1 / (2 * (1 + nu));
  const double lambda = nu / ((1 + nu) * (1 - 2 * nu));
  for (const char* element : {"q4", "q4_bbar", "q8", "t3", "t6"})
    for (const double s : {0.9, 0.7, 0.5}) {
      CAPTURE(element, s);
      double width = 1;  // mu (w^2 - 1) + lambda ln(w s) = 0
      for (int k = 0; k < 50; ++k)
        width -= (mu * (width * width - 1) + lambda * std::log(width * s)) /
                 (2 * mu * width + lambda / width);
      const double force = (mu * (s * s - 1) + lambda * std::log(width * s)) / s;
      const Walked run = walked(pressed("neo_hooke", element, s, 1));
      INFO(run.end.reason);
      REQUIRE(run.end.status == SolveStatus::Solved);
      CHECK(run.iterations[0] <= (s < 0.7 ? 6 : 5));
      CHECK(std::abs(run.top[0].y() - force) <= 1e-11);
      CHECK(std::abs(run.steps[0].solution.displacements[0].col(0).maxCoeff() - (width - 1)) <=
            1e-11);
      const Model model = [&] {
        Ledger ledger;
        return build(pressed("neo_hooke", element, s, 1), ledger);
      }();
      const StressArray stress =
          cell_stress(model.bodies[0].mesh, model.bodies[0].element, model.bodies[0].material,
                      run.steps[0].solution.displacements[0]);
      CHECK(std::abs(stress(0, 1) - force / width) <= 1e-10);  // true stress: of the width now
      CHECK(std::abs(stress(0, 0)) <= 1e-10);
    }
  for (const double s : {0.9, 0.7}) {
    CAPTURE(s);
    const Walked run = walked(pressed("st_venant_kirchhoff", "q8", s, 1));
    INFO(run.end.reason);
    REQUIRE(run.end.status == SolveStatus::Solved);
    CHECK(std::abs(run.top[0].y() - s * (s * s - 1) / (2 * (1 - nu * nu))) <= 1e-11);
  }
  // Beyond a stretch of 0.577 less force presses the law of St Venant and Kirchhoff further.
  const Walked run = walked(pressed("st_venant_kirchhoff", "q8", 0.5, 5));
  CHECK(run.end.status != SolveStatus::Solved);
  CHECK(run.end.state.time < (1 - 1 / std::sqrt(3)) / 0.5);
  CHECK_THAT(run.end.reason, ContainsSubstring("the last good state"));
}

// Without stress across, E33 = -nu/(1-nu) (E11 + E22), and a bar with free sides has Young's modulus alone.
TEST_CASE("a sheet of the law of St Venant and Kirchhoff is a bar of Young's modulus",
          "[motion]") {
  for (const double s : {0.8, 1.3}) {
    const Walked run = walked(pressed("st_venant_kirchhoff", "q4", s, 1, PlaneState::Stress));
    REQUIRE(run.end.status == SolveStatus::Solved);
    CHECK(std::abs(run.top[0].y() - s * (s * s - 1) / 2) <= 1e-11);
  }
}

TEST_CASE("as loads shrink finite strain becomes small strain, by the strain", "[motion]") {
  for (const char* law : {"st_venant_kirchhoff", "neo_hooke"})
    for (const char* element : {"q4", "q4_bbar", "q8", "t6"})
      for (const PlaneState state : {PlaneState::Strain, PlaneState::Stress, PlaneState::Axial}) {
        CAPTURE(law, element, to_string(state));
        double last = 0;
        for (const double strain : {1e-2, 1e-4, 1e-6}) {
          Scene scene = pressed(law, element, 1 - strain, 1, state);
          scene.bodies[0].supports.push_back(prescribed("top", Axis::X, 0));  // rough: not homogeneous
          const Walked finite = walked(scene);
          scene.bodies[0].material.law = nullptr;
          const Walked small = walked(scene);
          REQUIRE(finite.end.status == SolveStatus::Solved);
          const NodeArray& u = small.steps[0].solution.displacements[0];
          const double difference =
              (finite.steps[0].solution.displacements[0] - u).norm() / u.norm() / strain;
          CHECK(difference <= 5);
          if (strain < 1e-2) CHECK(std::abs(difference / last - 1) <= 20 * strain * 100);
          last = difference;
        }
      }
}
