// Bodies that move and are tied, or held by relations and rigid sides: halves that are tied move as the whole.
#include <algorithm>
#include <memory>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/motion/turns.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"
#include "support/moving_blocks.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

Tie tie(const Side& source, const Side& target) {
  Tie tie;
  tie.sides.source = source;
  tie.sides.target = target;
  return tie;
}

/// The dragged block, whole or of two halves that are tied; the cells of the upper half may be others.
Scene dragged(const char* law, bool halves, Index cells_above = 4, double carried = 0) {
  MovingBlocks of;
  of.cells = 4;
  of.drag = 1;
  of.steps = 4;
  Scene scene = moving_blocks(of);
  if (halves) {
    Body upper = scene.bodies[1];
    scene.bodies[1].mesh = block("block", {1, 1}, {1, 0.5}, 4, 2);
    scene.bodies[1].supports.clear();
    upper.mesh = block("upper", {1, 1.5}, {1, 0.5}, cells_above, 2);
    scene.bodies.push_back(upper);
    auto bonds = std::make_shared<Bonds>();
    bonds->ties = {tie({"top", "block"}, {"bottom", "upper"})};
    scene.bonds = bonds;
  }
  for (Body& body : scene.bodies) {
    if (law != nullptr) body.material.law = find_strain_law(law);
    if (law != nullptr) body.element = "q4";
  }
  if (carried != 0) {
    scene.bodies[0].supports = {prescribed("bottom", Axis::X, carried), prescribed("bottom", Axis::Y, 0)};
    scene.bodies[0].supports[0].history = "carry";
    Support along = prescribed("top", Axis::X, of.drag + carried);
    along.history = "drag";
    scene.bodies.back().supports[0] = along;
    scene.path->histories.push_back({"carry", {1, 2}, {0, 1}});
  }
  return scene;
}

struct Walked {
  PathEnd end;
  std::vector<VectorXd> force;
  std::vector<double> worst;
  BondForces tie = {};                  // at the end
  Eigen::Vector2d pushed = {0, 0};      // contact on the block, there
  double moment = 0;                    // of it about the origin
};

/// What contact does to the block, where it stands.
void add_up(const Model& model, const ContactState& contact, Walked& run) {
  const Pairs& pairs = model.pairs;
  run.pushed.setZero();
  run.moment = 0;
  for (Index k = 0; k < contact.force.size(); ++k) {
    const Eigen::Vector2d n = pairs.normal.row(k).transpose(), x = pairs.position.row(k).transpose();
    const Eigen::Vector2d forces(contact.force(k), contact.friction(k));
    const Eigen::Vector2d f = forces(0) * n + forces(1) * Eigen::Vector2d(n.y(), -n.x());
    run.pushed += f;
    run.moment += x.x() * f.y() - x.y() * f.x() + pairs.moment.row(k).dot(forces.transpose());
  }
}

Walked walked(const Scene& scene) {
  Walked run;
  run.end = solve_steps(scene, [&](const Model& model, const Step& step) {
    VectorXd all(step.solution.contact.force.size() + step.solution.contact.friction.size());
    all << step.solution.contact.force, step.solution.contact.friction;
    run.force.push_back(all);
    run.worst.push_back(step.solution.certificate.worst());
    if (!model.equations) return;
    add_up(model, step.solution.contact, run);
    if (!step.solution.bond_forces.empty()) run.tie = bond_forces(model, step.solution).front();
  });
  return run;
}

double far_apart(const VectorXd& a, const VectorXd& b) { return (a - b).norm() / b.norm(); }

}  // namespace

TEST_CASE("two halves that are tied are dragged as the whole block is", "[motion]") {
  for (const char* law : {static_cast<const char*>(nullptr), "st_venant_kirchhoff", "neo_hooke"}) {
    CAPTURE(law == nullptr ? "moves" : law);
    const Walked whole = walked(dragged(law, false));
    const Walked halves = walked(dragged(law, true));
    INFO(halves.end.reason);
    REQUIRE(whole.end.status == SolveStatus::Solved);
    REQUIRE(halves.end.status == SolveStatus::Solved);
    REQUIRE(halves.force.size() == whole.force.size());
    for (std::size_t k = 0; k < whole.force.size(); ++k) {
      CAPTURE(k);
      REQUIRE(halves.force[k].size() == whole.force[k].size());
      CHECK(far_apart(halves.force[k], whole.force[k]) <= 1e-9);
      CHECK(halves.worst[k] <= 1e-12);
    }
  }
}

TEST_CASE("a tie carries what contact does, at the place where the block has come to stand", "[motion]") {
  for (const char* law : {static_cast<const char*>(nullptr), "neo_hooke"}) {
    CAPTURE(law == nullptr ? "moves" : law);
    const Walked halves = walked(dragged(law, true, 3));
    INFO(halves.end.reason);
    REQUIRE(halves.end.status == SolveStatus::Solved);
    CHECK(halves.pushed.y() > 0);
    CHECK((halves.tie.force + halves.pushed).norm() <= 1e-9 * halves.pushed.norm());
    // Small strain balances moments where the meshes are, not a hundredth beside; sides that bend leave a little between them.
    CHECK(halves.tie.moment == Approx(-halves.moment).epsilon(law == nullptr ? 5e-3 : 1e-5));
    CHECK(halves.moment > 2 * halves.pushed.y());  // the block stood at 1.5 and stands at 2.5
  }
}

TEST_CASE("tied bodies that are carried far have the forces of those that are not", "[motion]") {
  const Walked near = walked(dragged(nullptr, true, 3));
  const Walked far = walked(dragged(nullptr, true, 3, 1000));
  INFO(far.end.reason);
  REQUIRE(far.end.status == SolveStatus::Solved);
  REQUIRE(far.force.size() == near.force.size());
  CHECK(far_apart(far.force.back(), near.force.back()) <= 1e-9);
}

TEST_CASE("pressures of a tie turn and stretch with its bodies", "[motion]") {
  // Two bars of a law, turned by 90 degrees about a corner and then pulled along their length, which is along x then.
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t b = 0; b < 2; ++b) {
    Body& body = scene.bodies[b];
    body.mesh = block(b == 0 ? "low" : "high", {0, b == 0 ? 0.0 : 1.0}, {1, 1}, b == 0 ? 2 : 3, 2);
    body.element = "q4";
    body.material = {1000, 0, PlaneState::Strain, 1};
    body.material.law = find_strain_law("st_venant_kirchhoff");
  }
  const auto turned = [](const char* side, Axis axis, double stretch) {
    Support support = prescribed(side, axis, [=](const Eigen::Vector2d& x) {
      const Eigen::Vector2d there(-stretch * x.y(), x.x());
      return axis == Axis::X ? there.x() - x.x() : there.y() - x.y();
    });
    support.history = "turn";
    return support;
  };
  // In steps of a straight way nodes pass the inside of the turn, where the bars are shorter; only the end counts.
  scene.bodies[0].supports = {turned("bottom", Axis::X, 1.1), turned("bottom", Axis::Y, 1.1)};
  scene.bodies[1].supports = {turned("top", Axis::X, 1.1), turned("top", Axis::Y, 1.1)};
  auto bonds = std::make_shared<Bonds>();
  bonds->ties = {tie({"top", "low"}, {"bottom", "high"})};
  scene.bonds = bonds;
  scene.path = Path{equal_steps(4), {proportional("turn")}};
  BondForces sum;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    sum = bond_forces(model, step.solution).front();
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  const double pull = 1000 * 1.1 * (1.1 * 1.1 - 1) / 2;  // stretch times the second stress of Piola and Kirchhoff
  CHECK(sum.force.x() == Approx(-pull).epsilon(1e-9));
  CHECK(sum.least_pressure == Approx(-pull).epsilon(1e-9));
  CHECK(sum.largest_pressure == Approx(-pull).epsilon(1e-9));
  CHECK(sum.largest_shear <= 1e-9 * pull);
}

TEST_CASE("forces of ties and supports keep their digits however far bodies are carried", "[motion]") {
  Scene scene = dragged(nullptr, true, 3, 1e8);
  NodeArray support;
  Walked run;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    add_up(model, step.solution.contact, run);
    support = support_forces(model, step.solution, 2);
    run.tie = bond_forces(model, step.solution).front();
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  CHECK((run.tie.force + run.pushed).norm() <= 1e-8 * run.pushed.norm());
  CHECK((support.matrix().colwise().sum().transpose() + run.pushed).norm() <= 1e-8 * run.pushed.norm());
}

TEST_CASE("a rigid side that is prescribed moves as supports do", "[motion]") {
  MovingBlocks of;
  of.steps = 2;
  of.drag = 0.5;
  Scene held = moving_blocks(of);
  for (Support& support : held.bodies[1].supports) support.history.clear();
  held.path = Path{{1, 2}, {}};
  Scene rigid = held;
  rigid.bodies[1].supports.clear();
  auto bonds = std::make_shared<Bonds>();
  RigidSide top;
  top.side = {"top", "block"};
  top.centre = {1.5, 2};
  top.x = of.drag;
  top.y = -of.press;
  top.turn = 0;
  bonds->rigid = {top};
  rigid.bonds = bonds;
  const Walked a = walked(held);
  const Walked b = walked(rigid);
  INFO(a.end.reason << " and " << b.end.reason);
  REQUIRE(a.end.status == SolveStatus::Solved);
  REQUIRE(b.end.status == SolveStatus::Solved);
  REQUIRE(a.force.size() == b.force.size());
  for (std::size_t k = 0; k < a.force.size(); ++k) CHECK(far_apart(b.force[k], a.force[k]) <= 1e-9);
}

TEST_CASE("stiff springs along a tie come near to the tie as bodies move", "[motion]") {
  Scene scene = dragged(nullptr, true, 3);
  const Walked tied = walked(scene);
  double last = 1;
  for (const double stiffness : {1e5, 1e6, 1e7}) {
    CAPTURE(stiffness);
    Bonds bonds = *scene.bonds;
    bonds.ties[0].stiffness = {stiffness, stiffness};
    scene.bonds = std::make_shared<Bonds>(bonds);
    const Walked springs = walked(scene);
    INFO(springs.end.reason);
    REQUIRE(springs.end.status == SolveStatus::Solved);
    const double far = far_apart(springs.force.back(), tied.force.back());
    CHECK(far <= 0.15 * last);
    last = far;
  }
  CHECK(last <= 1e-3);
}

TEST_CASE("a path of tied bodies goes on from a state to the same bits", "[motion]") {
  for (const char* law : {static_cast<const char*>(nullptr), "neo_hooke"}) {
    CAPTURE(law == nullptr ? "moves" : law);
    const Scene scene = dragged(law, true, 3);
    std::vector<PathState> all;
    static_cast<void>(solve_steps(scene, [&](const Model&, const Step& step) { all.push_back(step.state); }));
    REQUIRE(all.size() == 5);
    std::size_t k = 3;
    static_cast<void>(solve_steps(scene, [&](const Model&, const Step& step) {
      REQUIRE(k < all.size());
      CHECK(step.state.solution.force == all[k].solution.force);
      CHECK(step.state.solution.displacement == all[k].solution.displacement);
      ++k;
    }, all[2]));
    CHECK(k == all.size());
  }
}

TEST_CASE("what slides along sides, or turns, is refused where bodies move, with the way out", "[motion]") {
  const auto says = [](const Scene& scene, const char* words) {
    return problem_message([&] { static_cast<void>(plan(scene)); }).find(words) != std::string::npos;
  };
  Scene scene = dragged(nullptr, true);
  Bonds bonds = *scene.bonds;
  bonds.ties[0].slides = true;
  scene.bonds = std::make_shared<Bonds>(bonds);
  CHECK(says(scene, "slides along sides as the meshes have them"));
  scene = dragged("neo_hooke", true);
  bonds.ties[0].slides = false;
  bonds.ties[0].stiffness = {10, 10};
  scene.bonds = std::make_shared<Bonds>(bonds);
  CHECK(says(scene, "is made for small turns"));
  bonds.ties[0].stiffness = {};
  scene.bonds = std::make_shared<Bonds>(bonds);
  scene.bodies[2].mesh.nodes.col(1).array() += 0.01;
  CHECK(says(scene, "its sides are up to 0.01 apart"));
  scene = dragged(nullptr, true);
  bonds = *scene.bonds;
  bonds.ties.push_back(tie({"bottom", "block"}, {"top", "base"}));
  scene.bonds = std::make_shared<Bonds>(bonds);
  CHECK(says(scene, "no node in common"));
}
