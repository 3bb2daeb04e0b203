// Sides that move as rigid bodies: prescribed, driven, and free.
#include <cmath>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/estimate/estimate.hpp"
#include "addons/steps/steps.hpp"
#include "addons/steps/steps_limit.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::problem_message;

namespace {

/// A block 4 x 2 at (1, 1), of Poisson's ratio nu, its top a rigid side.
Scene pressed_block(const RigidSide& rigid, double nu, MeshOrder order = MeshOrder::Quadratic) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {1, 1}, {4, 2}, 5, 3, order);
  body.material = {1000, nu, PlaneState::Stress};
  body.supports = {fixed("bottom")};
  Bonds bonds;
  bonds.rigid = {rigid};
  scene.bonds = std::make_shared<const Bonds>(bonds);
  return scene;
}

RigidSide top() {
  RigidSide rigid;
  rigid.side = {"top", "block"};
  rigid.centre = {2, 4};
  return rigid;
}

}  // namespace

TEST_CASE("a rigid side that is moved is a side with given displacements", "[rigid-sides]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    RigidSide moved = top();
    moved.x = 0.002;
    moved.y = -0.001;
    moved.turn = 0.003;
    const Scene scene = pressed_block(moved, 0.3, order);
    Scene given = scene;
    given.bonds = nullptr;
    given.bodies[0].supports = {
        fixed("bottom"), {"top", true, true, [](const Vector2d& x) {
                            return Vector2d(0.002 - 0.003 * (x.y() - 4), -0.001 + 0.003 * (x.x() - 2));
                          }}};
    const SolvedScene one = solved(scene, "the rigid side");
    const SolvedScene two = solved(given, "the given one");
    const NodeArray& u = two.solution.displacements[0];
    CHECK((one.solution.displacements[0] - u).cwiseAbs().maxCoeff() <=
          1e-12 * u.cwiseAbs().maxCoeff());
    Vector2d force = Vector2d::Zero();
    double moment = 0;
    const NodeArray supports = support_forces(two.model, two.solution, 0);
    for (const Index node : boundary_nodes(two.model.bodies[0].mesh, "top")) {
      const Eigen::RowVector2d x = two.model.bodies[0].mesh.nodes.row(node);
      force += supports.row(node).transpose();
      moment += x(0) * supports(node, 1) - x(1) * supports(node, 0);
    }
    const BondForces sum = bond_forces(one.model, one.solution).front();
    CHECK((sum.force - force).norm() <= 1e-10 * force.norm());
    CHECK(sum.moment == Approx(moment).epsilon(1e-10));
  }
}

// What a moved side needs moves it: the same force and moment on its centre give the same motion.
TEST_CASE("a rigid side that is driven by force and moment goes where these were needed", "[rigid-sides]") {
  RigidSide moved = top();
  moved.x = 0.002;
  moved.y = -0.001;
  moved.turn = 0.003;
  const SolvedScene first = solved(pressed_block(moved, 0.3), "the moved side");
  const BondForces needed = bond_forces(first.model, first.solution).front();
  RigidSide driven = top();
  driven.force = needed.force;
  driven.moment = needed.moment - (2 * needed.force.y() - 4 * needed.force.x());
  const Scene scene = pressed_block(driven, 0.3);
  const SolvedScene second = solved(scene, "the driven side");
  const NodeArray& u = first.solution.displacements[0];
  CHECK((second.solution.displacements[0] - u).cwiseAbs().maxCoeff() <=
        1e-11 * u.cwiseAbs().maxCoeff());
  CHECK((bond_forces(second.model, second.solution)[0].force - needed.force).norm() <=
        1e-10 * needed.force.norm());
  CHECK(bond_forces(second.model, second.solution)[0].moment == Approx(needed.moment).epsilon(1e-10));
  // The same in load steps, where loads are those of the whole path.
  Scene steps = scene;
  steps.path = Path{{1, 2}, {}};
  static_cast<void>(solve_steps(steps, [&](const Model& /*model*/, const Step& step) {
    CHECK((step.solution.displacements[0] - u).cwiseAbs().maxCoeff() <=
          1e-11 * u.cwiseAbs().maxCoeff());
  }));
}

// With nu = 0, on rollers, a force of -6 at the distance e = 0.5 from the middle makes sigma_yy = -6 / 4 - 6 e x / (4^3 / 12), x
// from the middle, and no other stress: at the top u_y = h sigma_yy / E, a shift and a turn.
TEST_CASE("a cushion under a rigid plate and a force beside its middle", "[rigid-sides]") {
  RigidSide plate = top();
  plate.centre = {3.5, 3};
  plate.force = {0, -6};
  Scene scene = pressed_block(plate, 0);
  scene.bodies[0].supports = {symmetric("bottom"), prescribed_at("bottom", {1, 1}, Axis::X)};
  const SolvedScene run = solved(scene, "the cushion");
  const Mesh& mesh = run.model.bodies[0].mesh;
  for (const Index node : boundary_nodes(mesh, "top")) {
    const double x = mesh.nodes(node, 0) - 3;
    const double sigma = -6.0 / 4 - 6 * 0.5 * x / (64.0 / 12);
    CHECK(run.solution.displacements[0](node, 1) == Approx(2 * sigma / 1000).epsilon(1e-10));
  }
}

// 6 press the plate onto a cushion of stiffness E b / h = 2000, and springs of 500 in sum hold its nodes: the way is 6 / 2500, the
// springs bear 1.2 of it, and what drives the plate, at nodes that the springs hold too, is a force of the plate alone.
TEST_CASE("springs on a driven rigid side bear their own share and no more", "[rigid-sides]") {
  RigidSide plate = top();
  plate.centre = {3, 3};
  plate.force = {0, -6};
  Scene scene = pressed_block(plate, 0);
  scene.bodies[0].supports = {symmetric("bottom"), prescribed_at("bottom", {1, 1}, Axis::X)};
  Bonds bonds = *scene.bonds;
  bonds.relations = {{{{plate.side, {}, {0, 1}, 1}}, 0, 500.0 / 11}};
  scene.bonds = std::make_shared<const Bonds>(bonds);
  const SolvedScene run = solved(scene, "the plate");
  const std::vector<BondForces> sums = bond_forces(run.model, run.solution);
  REQUIRE(sums.size() == 2);
  CHECK(sums[0].name == "relation 1");
  CHECK(sums[0].force.y() == Approx(1.2).epsilon(1e-10));
  CHECK(sums[0].moment == Approx(3 * 1.2).epsilon(1e-10));
  CHECK(sums[1].force.y() == Approx(-6).epsilon(1e-10));
  CHECK(sums[1].moment == Approx(3 * -6).epsilon(1e-10));
}

// One node of the side follows a history, and the side, which may not turn, follows the node.
TEST_CASE("a rigid side goes along with a node that a history moves", "[rigid-sides][steps]") {
  RigidSide level = top();
  level.turn = 0;
  Scene scene = pressed_block(level, 0.3);
  Support pressed = prescribed_at("top", {1, 3}, Axis::Y, -0.002);
  pressed.history = "press";
  scene.bodies[0].supports.push_back(pressed);
  scene.path = Path{{1, 2, 4}, {{"press", {0, 4}, {0, 1}}}};
  static_cast<void>(solve_steps(scene, [](const Model& model, const Step& step) {
    CHECK(step.solution.certificate.holds());
    for (const Index node : boundary_nodes(model.bodies[0].mesh, "top"))
      CHECK(step.solution.displacements[0](node, 1) ==
            Approx(-0.002 * step.state.time / 4).epsilon(1e-11));
  }));
}

// The foot of a block stands on the plane that it is pressed onto, so that all that its equations move is rounding. Without lateral
// strain the whole block is under one pressure.
TEST_CASE("a rigid foot that stands flat on a plane stays there", "[rigid-sides]") {
  for (const double modulus : {1e-6, 1.0, 2.1e11})
    for (const double friction : {0.0, 0.3})
      for (const Index cells : {1, 4, 7}) {
        CAPTURE(modulus, friction, cells);
        RigidSide foot;
        foot.side = {"bottom", "block"};
        foot.x = 0;
        if (cells != 4) foot.turn = 0;
        Scene scene;
        Body& body = scene.bodies[0];
        body.mesh = block("block", {-1.0 / 3, 0}, {3.7, 1}, cells, 3, MeshOrder::Linear);
        body.material = {modulus, 0, PlaneState::Strain};
        EdgeLoad load;
        load.boundary = "top";
        load.pressure = 0.002 * modulus;
        body.loads.edges = {load};
        Bonds bonds;
        bonds.rigid = {foot};
        scene.bonds = std::make_shared<const Bonds>(bonds);
        scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
        if (friction > 0) scene.contacts[0].friction = Friction{friction, 0};
        const SolvedScene run = solved(scene, "the block");
        CHECK(run.solution.contact.force.sum() == Approx(3.7 * 0.002 * modulus).epsilon(1e-12));
        const NodeArray& u = run.solution.displacements[0];
        for (const Index node : boundary_nodes(run.model.bodies[0].mesh, "top"))
          CHECK(u(node, 1) == Approx(-0.002).epsilon(1e-11));
      }
}

namespace {

/// A block on a plane with friction, pressed and then dragged by a plate on its top.
Scene dragged_block(bool moves) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {2, 1}, 6, 3, MeshOrder::Linear);
  body.material = {100, 0.3, PlaneState::Strain};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = Friction{0.3, 0};
  scene.path = Path{{0.5, 1, 1.5, 2, 3}, {{"press", {0, 1}, {0, 1}}, {"drag", {1, 2, 3}, {0, 1, 0.5}}}};
  scene.moves = moves;
  return scene;
}

/// The plate: \param shifted  whether its shift down is given, or the force on it
Scene with_plate(Scene scene, bool shifted) {
  RigidSide plate;
  plate.side = {"top", "block"};
  plate.centre = {1, 1};
  plate.x = 0.02;
  plate.turn = 0;
  plate.histories.x = "drag";
  (shifted ? plate.histories.y : plate.histories.force) = "press";
  if (shifted)
    plate.y = -0.01;
  else
    plate.force = {0, -3};
  Bonds bonds;
  bonds.rigid = {plate};
  scene.bonds = std::make_shared<const Bonds>(bonds);
  return scene;
}

std::vector<Step> steps_of(const Scene& scene) {
  std::vector<Step> steps;
  const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) { steps.push_back(step); });
  CHECK(end.status == SolveStatus::Solved);
  return steps;
}

}  // namespace

TEST_CASE("a rigid side that follows two histories is a side whose displacements do", "[rigid-sides][steps]") {
  for (const bool moves : {false, true}) {
    CAPTURE(moves);
    Scene given = dragged_block(moves);
    Support press = prescribed("top", Axis::Y, -0.01), drag = prescribed("top", Axis::X, 0.02);
    press.history = "press";
    drag.history = "drag";
    given.bodies[0].supports = {press, drag};
    const std::vector<Step> expected = steps_of(given), steps = steps_of(with_plate(dragged_block(moves), true));
    REQUIRE(steps.size() == expected.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const Solution &one = steps[k].solution, &two = expected[k].solution;
      CHECK(one.certificate.holds());
      CHECK((one.displacements[0] - two.displacements[0]).cwiseAbs().maxCoeff() <= 1e-12 * 0.02);
      CHECK((one.contact.friction - two.contact.friction).cwiseAbs().maxCoeff() <= 1e-11 * 3);
    }
  }
}

TEST_CASE("a force that drives a rigid side grows with its history", "[rigid-sides][steps]") {
  for (const bool moves : {false, true}) {
    CAPTURE(moves);
    const std::vector<Step> steps = steps_of(with_plate(dragged_block(moves), false));
    REQUIRE(steps.size() == 5);
    for (std::size_t k = 0; k < steps.size(); ++k)
      CHECK(steps[k].solution.contact.force.sum() == Approx(k == 0 ? 1.5 : 3).epsilon(1e-10));
    CHECK(steps[3].solution.contact.friction.sum() == Approx(-0.9).epsilon(1e-9));  // all of it slides
  }
}

TEST_CASE("the number of a relation grows with its history, that of a spring too", "[relations][steps]") {
  for (const bool spring : {false, true}) {
    CAPTURE(spring);
    Scene scene = dragged_block(false);
    scene.contacts.clear();
    scene.bodies[0].material.poisson_ratio = 0;
    scene.bodies[0].supports = {fixed("bottom")};
    Relation pulled;
    pulled.terms = {{{"top", "block"}, {}, {0, 1}, 1}};
    pulled.right = 0.01;
    pulled.history = "drag";
    if (spring) pulled.stiffness = 50;
    Bonds bonds;
    bonds.relations = {pulled};
    scene.bonds = std::make_shared<const Bonds>(bonds);
    scene.bodies[0].mesh = block("block", {0, 0}, {2, 1}, 1, 1, MeshOrder::Linear);
    const std::vector<Step> steps = steps_of(scene);
    // The block is a spring of 200, and the two nodes have one of 50 each.
    const double share = spring ? 100.0 / 300 : 1;
    const std::vector<double> drag = {0, 0, 0.5, 1, 0.5};
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const NodeArray& u = steps[k].solution.displacements[0];
      CHECK(u(2, 1) == Approx(0.01 * share * drag[k]).epsilon(1e-11).margin(1e-17));
    }
  }
}

TEST_CASE("histories that bonds cannot follow are refused", "[rigid-sides][relations][steps][errors]") {
  Scene scene = with_plate(dragged_block(false), true);
  scene.path->histories.pop_back();
  CHECK(problem_message([&] { static_cast<void>(plan(scene)); }).find("no history is called 'drag'") !=
        std::string::npos);
  scene.path.reset();
  CHECK(problem_message([&] { static_cast<void>(plan(scene)); }).find("has no load steps") != std::string::npos);
  Relation bound;
  bound.terms = {{{"top", "block"}, {}, {0, 1}, 1}};
  bound.holds = Holds::AtMost;
  bound.history = "press";
  scene = dragged_block(false);
  Bonds bonds;
  bonds.relations = {bound};
  scene.bonds = std::make_shared<const Bonds>(bonds);
  CHECK(problem_message([&] { static_cast<void>(plan(scene)); }).find("stays where it is") != std::string::npos);
}

// What is estimated are stresses, and the tractions along a bond belong to nobody's load.
TEST_CASE("the error of a scene with bonds is not estimated", "[rigid-sides][errors]") {
  RigidSide level = top();
  level.y = -0.001;
  const SolvedScene run = solved(pressed_block(level, 0.3), "the block");
  CHECK(problem_message([&] {
          Ledger ledger;
          static_cast<void>(estimate(run.model, run.condensed, run.solution,
                                     {"mean", Displacement{"block", Axis::Y, "top"}}, ledger));
        }).find("leave them out") != std::string::npos);
}

// What is given needs no force, and what is held needs no equation: neither would show in the numbers.
TEST_CASE("forces that move nothing and bonds that hold nothing are noted", "[rigid-sides]") {
  const auto notes = [](const RigidSide& rigid) {
    std::string all;
    for (const std::string& note : plan(pressed_block(rigid, 0.3)).notes) all += note + '\n';
    return all;
  };
  RigidSide given = top();
  given.x = 0.1;
  given.force = {3, 10};
  given.moment = 2;
  CHECK(notes(given).find("x is given, so that the prescribed motion takes up a force along x") != std::string::npos);
  CHECK(notes(given).find("y is given") == std::string::npos);
  CHECK(notes(given).find("turn is given") == std::string::npos);
  CHECK(notes(given).find("does nothing") == std::string::npos);
  RigidSide held = top();
  held.side.boundary = "bottom";
  CHECK(notes(held).find("supports hold all of its nodes, so that it does nothing") != std::string::npos);
}

TEST_CASE("numbers that a rigid side cannot have are refused", "[rigid-sides][errors]") {
  RigidSide odd = top();
  odd.moment = std::nan("");
  CHECK(problem_message([&] { static_cast<void>(plan(pressed_block(odd, 0.3))); })
            .find("expected finite numbers") != std::string::npos);
  RigidSide stuck = top();
  stuck.side = {"bottom", "block"};
  stuck.y = 0.1;
  CHECK(problem_message([&] { static_cast<void>(plan(pressed_block(stuck, 0.3))); })
            .find("1 equation contradicts others") != std::string::npos);
}

// What cancels in elimination leaves rounding on right sides that are 0.
TEST_CASE("a rigid side that is said twice, once without its motion, repeats itself on any mesh", "[rigid-sides]") {
  const Index cells = GENERATE(range(1, 13));
  CAPTURE(cells);
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {2, 2}, cells, cells);
  body.material = {1000, 0.3, PlaneState::Stress};
  body.supports = {fixed("left")};
  RigidSide moved;
  moved.side = {"right", "block"};
  moved.x = 0.02;
  moved.turn = 0.01;
  RigidSide free = moved;
  free.x.reset();
  free.turn.reset();
  const bool freely_first = GENERATE(false, true);
  Bonds bonds;
  bonds.rigid = {moved};
  scene.bonds = std::make_shared<const Bonds>(bonds);
  const SolvedScene once = solved(scene, "once");
  bonds.rigid = freely_first ? std::vector<RigidSide>{free, moved} : std::vector<RigidSide>{moved, free};
  scene.bonds = std::make_shared<const Bonds>(bonds);
  const SolvedScene twice = solved(scene, "twice");
  CHECK((once.solution.displacements[0] - twice.solution.displacements[0]).cwiseAbs().maxCoeff() <= 1e-14);
  // And one that moves otherwise contradicts, by however little more than rounding.
  RigidSide other = moved;
  other.turn = 0.01 * (1 + 1e-9);
  bonds.rigid = {moved, other};
  scene.bonds = std::make_shared<const Bonds>(bonds);
  CHECK(problem_message([&] { static_cast<void>(solved(scene, "otherwise")); }).find("contradict") != std::string::npos);
}

// Closed form: without Poisson's effect a cylinder of radius R and height H gets shorter by F H / (pi R^2 E), uniformly.
TEST_CASE("in axial symmetry a rigid side is pressed along the axis by a force all round", "[rigid-sides][closed-form]") {
  const bool hollow = GENERATE(false, true);
  CAPTURE(hollow);
  const double inner = hollow ? 1 : 0;
  Scene scene = pressed_block(top(), 0, MeshOrder::Quadratic);
  Body& body = scene.bodies[0];
  body.mesh = block("block", {inner, 0}, {3, 2}, 4, 3, MeshOrder::Quadratic);
  body.material.state = PlaneState::Axial;
  body.supports = {symmetric("bottom")};
  RigidSide pressed = top();
  pressed.force = {0, -50};
  Bonds bonds;
  bonds.rigid = {pressed};
  scene.bonds = std::make_shared<const Bonds>(bonds);
  const SolvedScene run = solved(scene, "the cylinder");
  const double area = pi * ((inner + 3) * (inner + 3) - inner * inner);
  const NodeArray& u = run.solution.displacements[0];
  for (const Index node : boundary_nodes(run.model.bodies[0].mesh, "top")) {
    CHECK(u(node, 1) == Approx(-50 * 2 / (area * 1000)).epsilon(1e-10));
    CHECK(std::abs(u(node, 0)) <= 1e-12 * std::abs(u(node, 1)));
  }
  CHECK(bond_forces(run.model, run.solution).front().force.y() == Approx(-50).epsilon(1e-12));
}

TEST_CASE("in axial symmetry a rigid side keeps its radii, and the force that a given y takes drives it there", "[rigid-sides]") {
  Scene scene = pressed_block(top(), 0.3, MeshOrder::Linear);
  scene.bodies[0].mesh = block("block", {0, 0}, {3, 2}, 6, 4);
  scene.bodies[0].material.state = PlaneState::Axial;
  const auto with = [&](const RigidSide& rigid) {
    Bonds bonds;
    bonds.rigid = {rigid};
    Scene one = scene;
    one.bonds = std::make_shared<const Bonds>(bonds);
    return solved(one, "the rigid side");
  };
  RigidSide moved = top();
  moved.y = -0.01;
  const SolvedScene first = with(moved);
  Scene given = scene;
  given.bonds = nullptr;
  given.bodies[0].supports.push_back({"top", true, true, [](const Vector2d&) { return Vector2d(0, -0.01); }});
  const NodeArray u = solved(given, "the given one").solution.displacements[0];
  CHECK((first.solution.displacements[0] - u).cwiseAbs().maxCoeff() <= 1e-12 * u.cwiseAbs().maxCoeff());
  const Vector2d needed = bond_forces(first.model, first.solution).front().force;
  CHECK(needed.x() == 0);
  CHECK(needed.y() < 0);
  RigidSide driven = top();
  driven.force = needed;
  CHECK((with(driven).solution.displacements[0] - u).cwiseAbs().maxCoeff() <= 1e-10 * u.cwiseAbs().maxCoeff());
  RigidSide tilted = moved;
  tilted.turn = 0.1;
  CHECK(problem_message([&] { static_cast<void>(with(tilted)); }).find("along the axis alone: give y") != std::string::npos);
}

// A foot is pressed into the ground by an interference, which is there from the beginning: 400 hold 0.3 * 400 along it.
TEST_CASE("the force of a rigid side that is held is found as a share of it", "[rigid-sides][limit]") {
  RigidSide dragged = top();
  dragged.y = 0;
  dragged.turn = 0;
  dragged.force = {160, 0};
  Scene scene = pressed_block(dragged, 0, MeshOrder::Linear);
  scene.bodies[0].mesh = block("block", {0, 0}, {4, 1}, 8, 2);
  scene.bodies[0].supports.clear();
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = Friction{0.3};
  scene.contacts[0].interference = 0.1;
  if (GENERATE(false, true)) {  // and a stop that is never reached, which stays where it is
    Bonds bonds = *scene.bonds;
    bonds.relations = {{{{{"right", "block"}, {}, {0, 1}, 1}}, 10, {}, Holds::AtMost}};
    scene.bonds = std::make_shared<const Bonds>(bonds);
  }
  const Solution solution = solve_to_limit(scene);
  CHECK(solution.contact.report.status != SolveStatus::Solved);
  REQUIRE(solution.limit.has_value());
  CHECK(*solution.limit == Approx(0.75).epsilon(1e-9));
}

// In axial symmetry no side turns, so that finite strain takes it, too: uniaxial compression of a Neo-Hookean cylinder.
TEST_CASE("in axial symmetry a rigid side presses a body at finite strain", "[rigid-sides][finite-strain]") {
  Scene scene = pressed_block(top(), 0.3, MeshOrder::Linear);
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {3, 2}, 4, 3);
  body.element = "q4";
  body.material.state = PlaneState::Axial;
  body.material.law = find_strain_law("neo_hooke");
  body.supports = {fixed("bottom")};
  RigidSide pressed = top();
  pressed.y = -0.4;
  pressed.histories.y = "press";
  Bonds bonds;
  bonds.rigid = {pressed};
  scene.path = Path{equal_steps(2), {proportional("press")}};
  Scene given = scene;
  scene.bonds = std::make_shared<const Bonds>(bonds);
  given.bonds = nullptr;
  Support moved{"top", true, true, [](const Vector2d&) { return Vector2d(0, -0.4); }};
  moved.history = "press";
  given.bodies[0].supports.push_back(moved);
  const auto end = [](const Scene& one) {
    NodeArray u;
    const PathEnd path = solve_steps(one, [&](const Model&, const Step& step) { u = step.solution.displacements[0]; });
    CHECK(path.status == SolveStatus::Solved);
    return u;
  };
  const NodeArray u = end(given);
  CHECK((end(scene) - u).cwiseAbs().maxCoeff() <= 1e-10 * u.cwiseAbs().maxCoeff());
}
