// Ties beside contact, friction, rigid motions, load steps and other ties; sides that slide and never lift off.
#include <algorithm>
#include <cmath>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::problem_message;

namespace {

Body body_of(Mesh mesh) {
  Body body;
  body.mesh = std::move(mesh);
  body.material = {1000, 0.3, PlaneState::Strain};
  return body;
}

Tie tie_of(const Side& source, std::variant<Obstacle, Side> target, bool slides = false) {
  Tie tie;
  tie.sides.source = source;
  tie.sides.target = std::move(target);
  tie.slides = slides;
  return tie;
}

std::shared_ptr<const Bonds> bonds_of(std::vector<Tie> ties) {
  return std::make_shared<const Bonds>(Bonds{std::move(ties)});
}

EdgeLoad pressed(const std::string& boundary, double pressure) {
  EdgeLoad load;
  load.boundary = boundary;
  load.pressure = pressure;
  return load;
}

/// A block 4 x 4 above a rigid floor, whole or of two halves whose meshes match; on the floor it rubs. \param held  or
/// only by contact
Scene on_floor(bool whole, bool held) {
  Scene scene;
  scene.bodies.clear();
  if (whole)
    scene.bodies = {body_of(block("lower", {0, 0}, {4, 4}, 6, 6))};
  else
    scene.bodies = {body_of(block("lower", {0, 0}, {4, 2}, 6, 3)),
                    body_of(block("upper", {0, 2}, {4, 2}, 6, 3))};
  Body& upper = scene.bodies.back();
  upper.loads.edges = {pressed("top", 5)};
  EdgeLoad push;
  push.boundary = "top";
  push.traction = [](const Vector2d& x) { return Vector2d(0.4, -0.5 * x.x()); };
  upper.loads.edges.push_back(push);
  if (held) upper.supports = {prescribed("top", Axis::X, 0)};
  ContactSpec floor;
  floor.source = {"bottom", "lower"};
  floor.target = half_plane({0, 0}, {0, 1});
  floor.friction = Friction{0.3, 0};
  scene.contacts = {floor};
  if (!whole) scene.bonds = bonds_of({tie_of({"bottom", "upper"}, Side{"top", "lower"})});
  return scene;
}

}  // namespace

// A node of both halves moves as the node of the whole body at its place.
TEST_CASE("a body that is cut and tied along its nodes is the whole one", "[ties]") {
  const bool held = GENERATE(true, false);
  CAPTURE(held);
  const SolvedScene one = solved(on_floor(true, held), "the whole");
  const SolvedScene two = solved(on_floor(false, held), "the halves");
  CHECK(two.model.modes.size() == one.model.modes.size());
  CHECK((two.solution.contact.force - one.solution.contact.force).cwiseAbs().maxCoeff() <=
        1e-10 * one.solution.contact.force.maxCoeff());
  const NodeArray& x = one.model.bodies[0].mesh.nodes;
  const double size = one.solution.displacements[0].cwiseAbs().maxCoeff();
  Index compared = 0;
  for (std::size_t b = 0; b < 2; ++b) {
    const NodeArray& own = two.model.bodies[b].mesh.nodes;
    for (Index i = 0; i < own.rows(); ++i)
      for (Index k = 0; k < x.rows(); ++k)
        if ((own.row(i) - x.row(k)).norm() < 1e-12) {
          ++compared;
          CHECK((two.solution.displacements[b].row(i) - one.solution.displacements[0].row(k))
                    .norm() <= 1e-10 * size);
        }
  }
  CHECK(compared == 2 * 7 * 4);
}

// What is judged before may say that tied bodies have slid too far; then there are no forces to be told.
TEST_CASE("tied bodies that slid too far say so, as the whole body does", "[ties]") {
  for (const bool whole : {true, false}) {
    CAPTURE(whole);
    Scene scene = on_floor(whole, true);
    scene.bodies.push_back(body_of(block("base", {-10, -2}, {30, 2}, 60, 2)));
    scene.bodies.back().supports = {fixed("bottom")};
    scene.contacts[0].target = Side{"top", "base"};
    scene.bodies[scene.bodies.size() - 2].supports = {prescribed("top", Axis::X, 3)};
    const Solution solution = solve(scene);
    CHECK(solution.contact.report.status == SolveStatus::SlidTooFar);
    CHECK(solution.contact.reason.find("has slid by") != std::string::npos);
  }
}

// The node where the tie meets the wall is in both contacts, and one of the two halves has no unknowns of its own there.
TEST_CASE("a tie may end in a contact, whichever side is the source", "[ties]") {
  const bool lower_is_source = GENERATE(true, false);
  CAPTURE(lower_is_source);
  const auto beside_wall = [&](bool whole) {
    Scene scene = on_floor(whole, false);
    scene.contacts[0].friction.reset();
    EdgeLoad push;
    push.boundary = "left";
    push.traction = [](const Vector2d&) { return Vector2d(3, 0); };
    for (Body& body : scene.bodies) {
      body.loads.edges.push_back(push);
      ContactSpec wall;
      wall.source = {"right", body.mesh.name};
      wall.target = half_plane({4.001, 0}, {-1, 0});
      scene.contacts.push_back(wall);
    }
    if (!whole && lower_is_source)
      scene.bonds = bonds_of({tie_of({"top", "lower"}, Side{"bottom", "upper"})});
    return solved(scene, "the body at the wall").solution.displacements;
  };
  const std::vector<NodeArray> one = beside_wall(true);
  const std::vector<NodeArray> two = beside_wall(false);
  const double size = one[0].cwiseAbs().maxCoeff();
  CHECK((two[0] - one[0].topRows(28)).cwiseAbs().maxCoeff() <= 1e-10 * size);
  CHECK((two[1] - one[0].bottomRows(28)).cwiseAbs().maxCoeff() <= 1e-10 * size);
}

TEST_CASE("the certificate measures ties with the displacements of the nodes", "[ties]") {
  const SolvedScene run = solved(on_floor(false, true), "the halves");
  Solution wrong = run.solution;
  wrong.bond_forces.clear();
  wrong.displacements[1].array() += 1e-6 * wrong.displacements[1].cwiseAbs().maxCoeff();
  check_bonds(run.model, run.condensed, wrong);
  CHECK(wrong.certificate.penetration > 1e-7);
  CHECK(wrong.contact.report.status == SolveStatus::Breakdown);
}

TEST_CASE("two halves that contact alone holds move as one body", "[ties]") {
  const Plan planned = plan(on_floor(false, false));
  CHECK(planned.modes.size() == 3);
  const auto says = [&](const std::string& words) {
    return std::any_of(planned.on.begin(), planned.on.end(), [&](const std::string& line) {
      return line.find(words) != std::string::npos;
    });
  };
  CHECK(says("body 'lower' (18 cells around (2, 1)) and body 'upper' (18 cells around (2, 3)) can"));
  CHECK(says("tie of 'bottom' of 'upper' with 'top' of 'lower': 14 equations by mortar"));
}

// Loads and a displacement that grow, in three steps: the whole body and the halves at each.
TEST_CASE("ties hold in every load step", "[ties][steps]") {
  const auto last = [](bool whole) {
    Scene scene = on_floor(whole, false);
    Support moved = prescribed("top", Axis::X, 0.004);
    moved.history = "drag";
    scene.bodies.back().supports = {moved};
    for (EdgeLoad& load : scene.bodies.back().loads.edges) load.history = "press";
    scene.path = Path{{1, 2, 3}, {{"press", {0, 1, 3}, {0, 1, 0.8}}, {"drag", {1, 3}, {0, 1}}}};
    std::vector<double> forces;
    const PathEnd end = solve_steps(scene, [&](const Model& /*model*/, const Step& step) {
      for (const double force : step.solution.contact.force) forces.push_back(force);
      for (const double force : step.solution.contact.friction) forces.push_back(force);
      CHECK(step.solution.certificate.holds());
    });
    return forces;
  };
  const std::vector<double> one = last(true);
  const std::vector<double> two = last(false);
  REQUIRE(one.size() == two.size());
  REQUIRE(one.size() == 3 * 14);
  for (std::size_t k = 0; k < one.size(); ++k)
    CHECK(two[k] == Approx(one[k]).epsilon(1e-8).margin(1e-8));
}

// Pulled up by 2: a contact would lift off, a tie that slides does not, and its width shrinks as Poisson's ratio says.
TEST_CASE("sides that slide do not lift off, and feel no shear", "[ties]") {
  const double angle = GENERATE(0.0, 0.5, -1.2, 2.5);
  CAPTURE(angle);
  const Vector2d along(std::cos(angle), std::sin(angle));
  const Vector2d up(-along.y(), along.x());
  Scene scene;
  scene.bodies = {body_of(mapped(block("block", {0, 0}, {3, 2}, 4, 3), [&](const Vector2d& x) {
    return (x.x() * along + x.y() * up).eval();
  }))};
  EdgeLoad pull;
  pull.boundary = "top";
  pull.traction = [up](const Vector2d&) { return (2 * up).eval(); };
  scene.bodies[0].loads.edges = {pull};
  scene.bonds = bonds_of({tie_of({"bottom", "block"}, half_plane({0, 0}, up), true),
                          tie_of({"left", "block"}, half_plane({0, 0}, along), true)});
  const SolvedScene run = solved(scene, "the block");
  const Mesh& mesh = run.model.bodies[0].mesh;
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const Vector2d x = mesh.nodes.row(node).transpose();
    const Vector2d u = run.solution.displacements[0].row(node).transpose();
    CHECK(u.dot(up) == Approx(2 * 0.91 / 1000 * x.dot(up)).margin(1e-14));          // 1 - nu^2
    CHECK(u.dot(along) == Approx(-2 * 0.39 / 1000 * x.dot(along)).margin(1e-14));  // nu (1 + nu)
  }
  const std::vector<BondForces> sums = bond_forces(run.model, run.solution);
  CHECK(sums[0].force.dot(up) == Approx(-6).epsilon(1e-11));
  CHECK(sums[0].force.dot(along) == Approx(0).margin(1e-11));
  CHECK(sums[0].largest_shear == 0);
  CHECK(sums[1].force.norm() == Approx(0).margin(1e-11));
}

TEST_CASE("a tie that is there twice is noted, and changes nothing", "[ties]") {
  Scene once = on_floor(false, true);
  Scene twice = once;
  twice.bonds = bonds_of({once.bonds->ties[0], once.bonds->ties[0]});
  const SolvedScene one = solved(once, "one");
  const SolvedScene two = solved(twice, "two");
  const auto notes = plan(twice).notes;
  CHECK(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.rfind("14 of 28 equations say what others say, and are left out", 0) == 0;
  }));
  CHECK((one.solution.displacements[1] - two.solution.displacements[1]).cwiseAbs().maxCoeff() <=
        1e-13 * one.solution.displacements[1].cwiseAbs().maxCoeff());
}

TEST_CASE("ties that cannot be meant are refused, with what to do", "[ties][errors]") {
  Scene scene = on_floor(false, true);
  // The upper half is held at 0.1 above the place that the tie wants it at.
  scene.bodies[0].supports = {fixed("top")};
  scene.bodies[1].mesh = moved(scene.bodies[1].mesh, {0, 0.1});
  scene.bodies[1].supports = {fixed("bottom"), prescribed("top", Axis::X, 0)};
  Tie closing = scene.bonds->ties[0];
  closing.closes = true;
  scene.bonds = bonds_of({closing});
  CHECK(problem_message([&] { static_cast<void>(plan(scene)); }).find("equations contradict") !=
        std::string::npos);
  scene = on_floor(false, true);
  Tie points = scene.bonds->ties[0];
  points.sides.gap_operator = "gauss_points";
  scene.bonds = bonds_of({points});
  CHECK(problem_message([&] { static_cast<void>(plan(scene)); }).find("take mortar") !=
        std::string::npos);
}
