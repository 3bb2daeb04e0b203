// Finite strain of cells and bodies: derivatives, closed forms, turns, and small strain as their limit.
#include <cmath>
#include <sstream>

#include "addons/motion/finite_strain.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "meshes/split.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/problem/residual.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/scene/step_loop.hpp"
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
      CHECK(run.iterations[0] <= 5);
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
  // A mesh of quadrilaterals and triangles strains as one of either.
  for (const char* element : {"q4", "q8"}) {
    Scene whole = pressed("neo_hooke", element, 0.7, 1), mixed = whole;
    mixed.bodies[0].mesh = split(mixed.bodies[0].mesh, {1, 2});
    const Walked run = walked(mixed);
    INFO(run.end.reason);
    REQUIRE(run.end.status == SolveStatus::Solved);
    CHECK(std::abs(run.top[0].y() - walked(whole).top[0].y()) <= 1e-11);
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

// By hand from sigma = F S F^T / J; both motions have the same strain everywhere.
TEST_CASE("true stresses of a simple shear and of a widened ring are those of the closed forms",
          "[motion]") {
  const double mu = 1 / 2.6;
  const double lambda = 0.3 / (1.3 * 0.4);
  const double shear = 0.4;
  const double J = 1.2 * 1.2;  // a ring that is wider by a fifth, and as high as before
  struct Stresses {
    const char* law;
    double sheared;
    double hoop;
  };
  for (const Stresses& exact :
       {Stresses{"neo_hooke", mu * shear, (mu * (J - 1) + lambda * std::log(J)) / J},
        Stresses{"st_venant_kirchhoff", mu * shear + (lambda + 2 * mu) * std::pow(shear, 3) / 2,
                 lambda * (J - 1) + mu * (J - 1)}})
    for (const char* element : {"q4", "q8", "t3", "t6"}) {
      CAPTURE(exact.law, element);
      const auto stress = [&](PlaneState state, double along_x, double along_y) {
        Scene scene = pressed(exact.law, element, 1, 1, state);
        scene.bodies[0].mesh = moved(scene.bodies[0].mesh, {1, 0});
        Ledger ledger;
        const Model model = build(scene, ledger);
        const BodyModel& body = model.bodies[0];
        NodeArray u = NodeArray::Zero(body.mesh.n_nodes(), 2);
        u.col(0) = along_x * body.mesh.nodes.col(0) + along_y * body.mesh.nodes.col(1);
        return cell_stress(body.mesh, body.element, body.material, u);
      };
      const StressArray sheared = stress(PlaneState::Strain, 0, shear);
      const StressArray ring = stress(PlaneState::Axial, 0.2, 0);
      // Sums of some ten terms of size 1.
      CHECK((sheared.col(2).array() - exact.sheared).abs().maxCoeff() <= 1e-14);
      CHECK((ring.col(3).array() - exact.hoop).abs().maxCoeff() <= 1e-14);
      CHECK((ring.col(0).array() - exact.hoop).abs().maxCoeff() <= 1e-14);
      CHECK(ring.col(2).array().abs().maxCoeff() <= 1e-14);
    }
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

TEST_CASE("a strain of 1e-14 has its digits, in a sheet as well", "[motion]") {
  for (const char* law : {"st_venant_kirchhoff", "neo_hooke"})
    for (const PlaneState state : {PlaneState::Strain, PlaneState::Stress}) {
      CAPTURE(law, to_string(state));
      const Element& element = find_element("q4");
      const Mesh mesh = skew(element);
      Material material{7, 0.49, state, 0.4};
      const NodeArray u = random_nodes(mesh.n_nodes(), 1e-14, 3);
      const NodeArray small = internal_forces(mesh, element, material, u);
      material.law = find_strain_law(law);
      // The law leaves 1e-14 of the strain; lambda is 49 times mu, and sums of ten such terms are rounded to 1e-13.
      CHECK((internal_forces(mesh, element, material, u) - small).norm() <= 1e-12 * small.norm());
    }
}

namespace {

/// A block that is pressed on a base and dragged with friction, both of a law, then both are carried away.
Scene rubbing(const char* law, double carried, const char* element = "q4",
              PlaneState state = PlaneState::Strain) {
  MovingBlocks of;
  of.press = std::string(law) == "small" ? 0.005 : 0.05;  // that turns less than is refused
  of.drag = 0.4;
  of.steps = 2;
  of.base_cells = 12;
  of.state = state;
  of.order = order_of(find_element(element));
  Scene scene = moving_blocks(of);
  for (Body& body : scene.bodies) {
    body.mesh = fitting(body.mesh, find_element(element));
    body.element = element;
    body.material.law = find_strain_law(law);
  }
  if (carried == 0) return scene;
  // The drag goes on while the base follows.
  scene.bodies[0].supports = {prescribed("bottom", Axis::X, carried),
                              prescribed("bottom", Axis::Y, 0)};
  scene.bodies[0].supports[0].history = "away";
  scene.path->times.push_back(3);
  scene.path->histories[1].times.push_back(3);
  scene.path->histories[1].values.push_back(1 + carried / of.drag);
  scene.path->histories.push_back({"away", {2, 3}, {0, 1}});
  return scene;
}

/// Displacements of a place that everything has turned from by 90 degrees, and moved; exact, as sums of two doubles.
Displaced turned(const NodeArray& nodes, const Displaced& moved) {
  using Exact = Eigen::Matrix<long double, Eigen::Dynamic, 2>;
  const Exact x = nodes.cast<long double>();
  const Exact from = x + moved.high.cast<long double>() + moved.low.cast<long double>();
  Exact to(from.rows(), 2);
  to << (3 - from.col(1).array()).matrix(), (from.col(0).array() - 2).matrix();
  to -= x;
  const NodeArray high = to.cast<double>();
  return {high, (to - high.cast<long double>()).cast<double>()};
}

}  // namespace

// Small strain fails here: it takes the turn for a strain of 1.
TEST_CASE("turned by 90 degrees, bodies that are pressed and sheared have the same forces, gaps and slips",
          "[motion]") {
  for (const char* law : {"st_venant_kirchhoff", "neo_hooke", "small"})
    for (const char* element : {"q4", "q4_bbar", "q8", "t6"}) {
      CAPTURE(law, element);
      const Scene scene = rubbing(law, 0, element);
      const Walked run = walked(scene);
      INFO(run.end.reason);
      REQUIRE(run.end.status == SolveStatus::Solved);
      const PrimalDual& last = run.end.state.solution;
      Ledger ledger;
      Model model = build(scene, ledger);
      set_time(2, model);
      NodeArray nodes(model.unknowns.held.rows(), 2);
      nodes << model.bodies[0].mesh.nodes, model.bodies[1].mesh.nodes;
      const Displaced at = displaced(model.unknowns, last);
      model.loop->place(at, at, model);
      const VectorXd gaps = signorini::gaps(model.programme, last);
      CHECK(model.loop->certify(last, model).worst() <= 1e-12);
      const Displaced there = turned(nodes, at);
      model.unknowns.held = (model.unknowns.number < 0).select(there.high, 0);  // but for 1e-16
      model.loop->place(there, at, model);
      PrimalDual claim = last;
      claim.displacement = restricted(model.unknowns, there.high);
      claim.displacement_low = restricted(model.unknowns, there.low);
      const VectorXd now = signorini::gaps(model.programme, claim);
      REQUIRE(now.size() == gaps.size());
      CHECK((now - gaps).cwiseAbs().maxCoeff() <= 1e-14);  // slips are the last rows: none since then
      const double worst = model.loop->certify(claim, model).worst();
      INFO("1e12 of " << 1e12 * worst);
      if (std::string(law) == "small")
        CHECK(worst > 0.1);
      else
        CHECK(worst <= 1e-12);
    }
}

TEST_CASE("bodies that are carried 1e4 of their sizes keep their forces",
          "[motion]") {
  for (const char* law : {"neo_hooke", "small"}) {
    CAPTURE(law);
    const Walked run = walked(rubbing(law, 1e4));
    INFO(run.end.reason);
    REQUIRE(run.end.status == SolveStatus::Solved);
    REQUIRE(run.steps.size() == 4);
    const VectorXd& still = run.steps[2].state.solution.force;
    const VectorXd& far = run.steps[3].state.solution.force;
    REQUIRE(far.size() == still.size());
    CHECK(run.steps[3].solution.certificate.worst() <= 1e-12);
    // Of each of the two, a certificate lets 1e-12 of forces pass; a block has five times as stiff a mode as its softest.
    CHECK((far - still).cwiseAbs().maxCoeff() <= 5e-12 * still.cwiseAbs().maxCoeff());
  }
}

// Its ends are taken down by six heights, onto a disc: a stress is some 1e-4 of what a cell that is stretched as far would have.
TEST_CASE("a strip a hundred times as long as high bends over a disc", "[motion]") {
  Scene scene;
  Body& strip = scene.bodies[0];
  strip.mesh = block("strip", {-50, 0}, {100, 1}, 100, 2, MeshOrder::Quadratic);
  strip.element = "q8";
  strip.material = {1000, 0.3, PlaneState::Strain, 1};
  strip.material.law = find_strain_law("st_venant_kirchhoff");
  for (const char* side : {"left", "right"}) {
    strip.supports.push_back(prescribed(side, Axis::Y, -6));
    strip.supports.back().history = "press";
  }
  scene.contacts = {{{"bottom", "strip"}, disc({0, -20.5}, 20)}};
  scene.path = Path{equal_steps(4), {proportional("press")}};
  Vector2d sum(0, 0);
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    CHECK(step.solution.certificate.worst() <= 1e-12);
    sum = resultants(model, step.solution).force;
    CHECK(std::abs(sum.x()) <= 1e-9 * std::abs(sum.y()));  // the mirror of itself
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  CHECK(sum.y() > 0);
}

TEST_CASE("the tangents of a step hardly differ in pattern, and share an order of elimination",
          "[motion]") {
  long long tangents = 0, orders = 0;
  const PathEnd end = solve_steps(rubbing("neo_hooke", 0), [&](const Model&, const Step& step) {
    long long own = 0;
    for (const LedgerEntry& entry : step.solution.ledger.entries())
      for (const auto& [name, count] : entry.counts) {
        if (name == "tangents tried") tangents += count;
        if (name == "orders") own += count;
      }
    CHECK(own >= 1);  // or a step from a state would have another order
    orders += own;
  });
  REQUIRE(end.status == SolveStatus::Solved);
  CAPTURE(tangents, orders);
  CHECK(2 * orders <= tangents);
}

TEST_CASE("a path of finite strain goes on from a state to the same bits", "[motion]") {
  const Scene scene = rubbing("neo_hooke", 0);
  const Walked run = walked(scene);
  REQUIRE(run.steps.size() == 3);
  std::ostringstream out;
  write_state(run.steps[1].state, out);
  std::vector<PathState> again;
  const PathEnd end = solve_steps(
      scene, [&](const Model&, const Step& step) { again.push_back(step.state); },
      read_state(out.str(), "saved"));
  REQUIRE(end.status == SolveStatus::Solved);
  REQUIRE(again.size() == 1);
  const PathState& last = run.steps[2].state;
  CHECK(again[0].solution.displacement == last.solution.displacement);
  CHECK(again[0].solution.displacement_low == last.solution.displacement_low);
  CHECK(again[0].solution.force == last.solution.force);
  CHECK(again[0].slip == last.slip);
  CHECK_THAT(problem_message([&] {
               static_cast<void>(
                   solve_steps(rubbing("st_venant_kirchhoff", 0), {}, read_state(out.str(), "saved")));
             }),
             ContainsSubstring("is of another scene"));
}

TEST_CASE("what a law cannot have is refused with the way out", "[motion]") {
  const auto message = [](const auto& change) {
    Scene scene = rubbing("neo_hooke", 0);
    change(scene);
    return problem_message([&] { static_cast<void>(plan(scene)); });
  };
  CHECK(message([](Scene&) {}).empty());
  CHECK_THAT(message([](Scene& s) { s.bodies[0].element = "q4_incompatible"; }),
             ContainsSubstring("hourglasses") && ContainsSubstring("q4_bbar"));
  CHECK_THAT(message([](Scene& s) {
               for (Body& body : s.bodies)
                 for (Support& support : body.supports) support.history = "";
               s.path.reset();
             }),
             ContainsSubstring("[[steps]]"));
  CHECK_THAT(message([](Scene& s) {
               s.bodies[0].material.expansion = 1e-5;
               s.bodies[0].temperature = Temperature{10, {0, 0}};
             }),
             ContainsSubstring("temperature"));
  const auto in_a_layer = [&](const char* law, const char* of_body) {
    return message([&](Scene& s) {
      s.bodies[0].mesh.regions["half"] = {0};
      Layer layer{"half", s.bodies[0].material};
      layer.material.law = find_strain_law(law);
      s.bodies[0].layers = {layer};
      s.bodies[0].material.law = find_strain_law(of_body);
      s.bodies[1].material.law = s.bodies[0].material.law;
    });
  };
  CHECK(in_a_layer("st_venant_kirchhoff", "neo_hooke").empty());
  CHECK_THAT(in_a_layer("small", "neo_hooke"), ContainsSubstring("either all of a body"));
  CHECK_THAT(in_a_layer("neo_hooke", "small"), ContainsSubstring("either all of a body"));
  CHECK_THAT(problem_message([] { static_cast<void>(find_strain_law("neohooke")); }),
             ContainsSubstring("did you mean") && ContainsSubstring("neo_hooke"));
  // A layer that differs in nothing but its law is one.
  Scene layered = rubbing("neo_hooke", 0);
  layered.bodies[0].mesh.regions["half"] = {0};
  layered.bodies[0].layers = {{"half", layered.bodies[0].material}};
  CHECK(plan(layered).bodies[0].material.others.empty());
  layered.bodies[0].layers[0].material.law = find_strain_law("st_venant_kirchhoff");
  CHECK(std::string(plan(layered).bodies[0].material.of(0).law->name) == "st_venant_kirchhoff");
  // The usual element of quadrilaterals has internal modes: another one is taken, and told.
  Scene scene = rubbing("neo_hooke", 0);
  for (Body& body : scene.bodies) body.element.clear();
  const Plan draft = plan(scene);
  CHECK(std::string(draft.bodies[0].element.name) == "q4_bbar");
}

TEST_CASE("a first step that fails leaves nothing to a shorter one", "[motion]") {
  MovingBlocks of;
  of.press = 1.2;  // of 2
  Scene scene = moving_blocks(of);
  for (Body& body : scene.bodies) {
    body.element = "q4";
    body.material.law = find_strain_law("st_venant_kirchhoff");
  }
  const auto shorter = [&](bool after_another) {
    Ledger ledger;
    Model model = build(scene, ledger);
    CondensedPath path = condense_path(model, ledger);
    if (after_another)
      CHECK(step({}, 1, model, path, {}).solution.contact.report.status != SolveStatus::Solved);
    const Step next = step({}, 0.05, model, path, {});
    REQUIRE(next.solution.contact.report.status == SolveStatus::Solved);
    return next.state.solution.displacement;
  };
  CHECK(shorter(true) == shorter(false));
}
