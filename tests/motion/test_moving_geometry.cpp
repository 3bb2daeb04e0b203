// Bodies that move: pairs where they stand, slips along the surface, whole paths.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "addons/motion/moved_pairs.hpp"
#include "addons/motion/turns.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/step_loop.hpp"
#include "meshes/reshape.hpp"
#include "signorini/core/rounding.hpp"
#include "support/message.hpp"
#include "support/moving_blocks.hpp"
#include "support/paths.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

Model built(const Scene& scene) {
  Ledger ledger;
  return build(scene, ledger);
}

NodeArray places(const Model& model) {
  NodeArray nodes(count_nodes(model.bodies), 2);
  for (const BodyModel& body : model.bodies)
    nodes.middleRows(body.first_node, body.mesh.n_nodes()) = body.mesh.nodes;
  return nodes;
}

/// Displacements of a turn about the origin and a move.
NodeArray turned_by(double angle, const NodeArray& nodes) {
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  NodeArray there = nodes * turn.transpose();
  there.rowwise() += Eigen::RowVector2d(3, -2);
  return there - nodes;
}

/// Gaps and slips of bodies that stand at a displacement, which is not that of the unknowns: with all nodes given.
VectorXd seen(Model& model, const NodeArray& displacement, const NodeArray& before) {
  model.loop->place(displacement, before, model);
  VectorXd u(model.unknowns.count);
  for (Index node = 0; node < displacement.rows(); ++node)
    for (const Index axis : {0, 1})
      if (const Index k = model.unknowns.number(node, axis); k >= 0)
        u(k) = displacement(node, axis);
  VectorXd all = model.programme.initial_gap - model.programme.A * u;
  const Index pairs = model.pairs.weight.size();
  // What supports hold moves as well.
  NodeArray rest = displacement - expand(model.unknowns, u);
  const Eigen::Map<const VectorXd> flat(rest.data(), rest.size());
  all.head(pairs) += model.pairs.opening * flat;
  const VectorXd slip = model.pairs.sliding * flat;
  for (Index k = 0; k < all.size() - pairs; ++k)
    all(pairs + k) += slip(model.law.pair[std::size_t(k)]);
  return all;
}

std::string unsolved(const Scene& scene, SolveStatus status) {
  const PathEnd end = solve_steps(scene);
  CHECK(end.status == status);
  return end.reason;
}

}  // namespace

TEST_CASE("placed where the scene has them, bodies have the linear problem, bit by bit",
          "[motion]") {
  Scene scene = moving_blocks();
  Model moves = built(scene);
  scene.moves = false;
  const Model still = built(scene);
  const NodeArray zero = NodeArray::Zero(count_nodes(still.bodies), 2);
  moves.loop->place(zero, zero, moves);
  CHECK((moves.programme.A - still.programme.A).norm() == 0);
  CHECK(moves.programme.A.nonZeros() == still.programme.A.nonZeros());
  CHECK(moves.law.pair == still.law.pair);
  CHECK(moves.law.coefficient == still.law.coefficient);
  // Loads of the full scene are in both.
  CHECK(moves.programme.load == still.programme.load);
  CHECK(moves.programme.initial_gap == still.programme.initial_gap);
}

TEST_CASE("a gap is that of the place, where the linear one is wrong by s^2/2R", "[motion]") {
  Scene scene = moving_blocks();
  scene.bodies.erase(scene.bodies.begin());
  const double radius = 10;
  scene.contacts = {{{"bottom"}, disc({1.5, 1 - radius}, radius)}};
  scene.contacts[0].friction = Friction{0.3, 0};
  Model model = built(scene);
  NodeArray along = NodeArray::Zero(count_nodes(model.bodies), 2);
  along.col(0).setConstant(0.2);
  const VectorXd first = seen(model, 0 * along, 0 * along);
  const VectorXd gap = seen(model, along, 0 * along);
  const Index pairs = model.pairs.weight.size();
  for (Index pair = 0; pair < pairs; ++pair) {
    const Vector2d x = model.pairs.position.row(pair).transpose();
    const Vector2d old = x - Vector2d(0.2, 0);
    const Vector2d centre(1.5, 1 - radius);
    CHECK(std::abs(gap(pair) - ((x - centre).norm() - radius)) <= 1e-14);
    // A node slides by the arc whose chord its way is.
    const Vector2d normal = (x - centre).normalized(), from = (old - centre).normalized();
    const double half = std::atan2(normal.x() * from.y() - normal.y() * from.x(), normal.dot(from)) / 2;
    const double chord = 0.2 * (normal + from).normalized().y();
    CHECK(std::abs(gap(pairs + pair) - chord * half / std::sin(half)) <= 1e-14);
    // The linear gap of the first place lacks the curvature.
    const Vector2d n = (old - centre).normalized();
    const double linear = first(pair) + 0.2 * n.x();
    const double s = 0.2 * n.y();
    CHECK(std::abs(gap(pair) - linear - s * s / (2 * (old - centre).norm())) <= 1e-4);
  }
}

TEST_CASE("a turn of both bodies by any angle opens no gap and is no slip", "[motion]") {
  Scene scene = moving_blocks();
  scene.bodies[1].mesh.nodes.col(1).array() += 1e-3;  // open
  Model model = built(scene);
  const NodeArray zero = NodeArray::Zero(count_nodes(model.bodies), 2);
  const VectorXd still = seen(model, zero, zero);
  const Index pairs = model.pairs.weight.size();
  for (const double angle : {1e-3, 0.5, 1.5707963267948966, 3.0}) {
    CAPTURE(angle);
    const NodeArray turn = turned_by(angle, places(model));
    const VectorXd there = seen(model, turn, zero);
    REQUIRE(there.size() == still.size());
    CHECK((there.head(pairs) - still.head(pairs)).cwiseAbs().maxCoeff() <= 3e-14);
    CHECK(there.tail(there.size() - pairs).cwiseAbs().maxCoeff() <= 3e-14);
    // A block that slid by 0.37 before all turned, or after: so much is told.
    NodeArray slid = zero;
    slid.bottomRows(model.bodies[1].mesh.n_nodes()).col(0).setConstant(0.37);
    const VectorXd both = seen(model, turned_by(angle, places(model) + slid) + slid, zero);
    CHECK((both.tail(both.size() - pairs).array() - 0.37).abs().maxCoeff() <= 3e-14);
  }
}

TEST_CASE("a block is dragged over many sides of a stiff base: friction is mu times pressure",
          "[motion]") {
  MovingBlocks of;
  of.stiffness = 1e6;
  of.base_cells = 102;  // the drag goes over 51 of them
  of.steps = 24;
  const Scene scene = moving_blocks(of);
  double least = 1e300, most = 0;
  Index steps = 0, searches = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    ++steps;
    CHECK(step.solution.certificate.holds());
    searches += step.solution.ledger.counted("pairs", "searches");
    // In the present configuration contact forces and their moments are in balance.
    CHECK(step.solution.certificate.balance <= 1e-13);
    if (step.state.time < 1.2) return;
    const Resultants sum = resultants(model, step.solution);
    least = std::min(least, std::abs(sum.force.x()));
    most = std::max(most, std::abs(sum.force.x()));
    CHECK(std::abs(std::abs(sum.force.x() / sum.force.y()) - 0.3) <= 2e-5);
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  CHECK(end.halvings == 0);
  CHECK(steps == 25);
  CHECK(searches <= 12 * steps);
  CHECK((most - least) / most <= 2e-5);
}

TEST_CASE("a block and its base that go the same way keep what they have", "[motion]") {
  Scene scene = moving_blocks();
  scene.bodies[0].supports = {prescribed("bottom", Axis::X, 3), prescribed("bottom", Axis::Y, 0)};
  scene.bodies[0].supports[0].history = "drag";
  scene.contacts[0].friction = Friction{5, 0};
  std::vector<Step> steps;
  const PathEnd end =
      solve_steps(scene, [&](const Model&, const Step& step) { steps.push_back(step); });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  for (const Step& step : steps) {
    CHECK(step.state.increment.cwiseAbs().maxCoeff() == 0);
    CHECK((step.state.solution.force - steps[0].state.solution.force).cwiseAbs().maxCoeff() <=
          1e-10 * steps[0].state.solution.force.cwiseAbs().maxCoeff());
  }
}

// What is left is the rounding of normals, whose target is carried and not the source: 100 lengths in 1e-16 beside cells of 0.2.
TEST_CASE("a block that slides on a base that is carried far has the forces of one that is not",
          "[motion]") {
  const auto forces = [](double carried) {
    MovingBlocks of;
    of.press = 1e-3;
    of.drag = carried + 0.5;
    of.steps = 2;
    Scene scene = moving_blocks(of);
    scene.bodies[0].supports = {prescribed("bottom", Axis::X, carried),
                                prescribed("bottom", Axis::Y, 0)};
    scene.bodies[0].supports[0].history = "drag";
    const PathEnd end = solve_steps(scene);
    CHECK(end.status == SolveStatus::Solved);
    return end.state.solution.force;
  };
  const VectorXd still = forces(0);
  const VectorXd far = forces(100);
  REQUIRE(far.size() == still.size());
  CHECK((far - still).cwiseAbs().maxCoeff() <= 1e-9 * still.cwiseAbs().maxCoeff());
}

// Nothing holds the block but contact: its amplitudes are unknowns of every linear problem, and it goes along as a whole.
TEST_CASE("a loose block rides on a base that moves away", "[motion]") {
  Scene scene = moving_blocks();
  scene.bodies[0].supports = {prescribed("bottom", Axis::X, 50), prescribed("bottom", Axis::Y, 0)};
  scene.bodies[0].supports[0].history = "drag";
  scene.bodies[1].supports.clear();
  scene.bodies[1].loads.edges = {{"top", 5, {}, "press"}};
  std::vector<Step> steps;
  const PathEnd end =
      solve_steps(scene, [&](const Model&, const Step& step) { steps.push_back(step); });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  const NodeArray& first = steps.front().solution.displacements[1];
  const NodeArray& last = steps.back().solution.displacements[1];
  CHECK(((last - first).col(0).array() - 50).abs().maxCoeff() <= 1e-10);
  CHECK((last - first).col(1).cwiseAbs().maxCoeff() <= 1e-10);
}

TEST_CASE("friction remembers along the surface what slid where nodes lose their pairs",
          "[motion]") {
  MovingBlocks of;
  of.drag = 4.5;  // the last quarter of the block goes over the end of the base
  of.steps = 18;
  double before = 0;
  Index left = 0;
  const PathEnd end = solve_steps(moving_blocks(of), [&](const Model& model, const Step& step) {
    const double all = step.state.dissipation.sum() + step.state.dissipated_elsewhere.sum();
    // So do the sums that are told, of all contacts and of each.
    const std::optional<PathTotals> sums = totals(&step.state);
    CHECK(resultants(model, step.solution, sums).dissipated_total == Approx(all).epsilon(1e-14));
    CHECK(resultants_of_contacts(model, step.solution, sums)[0].dissipated_total ==
          Approx(all).epsilon(1e-14));
    CHECK(all >= before * (1 - 1e-14));
    before = all;
    left = Index(model.pairs.unpaired.size());
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  CHECK(left > 0);
  REQUIRE(end.state.dissipated_elsewhere.size() == 1);
  CHECK(end.state.dissipated_elsewhere(0) > 0);
  PathState two = end.state;  // of two contacts
  two.dissipated_elsewhere = Eigen::Vector2d(0.25, 1.0 / 3);
  std::ostringstream of_two;
  write_state(two, of_two);
  CHECK(read_state(of_two.str(), "saved").dissipated_elsewhere == two.dissipated_elsewhere);
  std::ostringstream out;
  write_state(end.state, out);
  const PathState again = read_state(out.str(), "saved");
  CHECK(again.dissipated_elsewhere == end.state.dissipated_elsewhere);
  CHECK(again.solution.force == end.state.solution.force);
  CHECK_THAT(
      problem_message([&] { static_cast<void>(read_state(out.str() + "more 1\n", "saved")); }),
      ContainsSubstring("the end of the file"));
}

// Pressed by a load to a strain of 9 %, on three nodes. With one factor and without the turn of contact forces an iteration leaves more
// than a third of the error, and a step ends after 27. With it in the load no step has more than 20, and no correction leads away.
TEST_CASE("a slip of 1e-6 has its digits beside a way of 1e6 that both bodies go", "[motion]") {
  const Scene scene = moving_blocks();
  Model model = built(scene);
  const NodeArray zero = NodeArray::Zero(count_nodes(model.bodies), 2);
  Displaced gone(zero);
  gone.high.col(0).setConstant(0x1p20);
  const BodyModel& block = model.bodies[1];
  gone.high.middleRows(block.first_node, block.mesh.n_nodes()).col(0).array() += 0x1p-20;
  gone.low.middleRows(block.first_node, block.mesh.n_nodes()).col(0).array() = 1e-13;
  place_bodies(scene, gone, zero, model);
  const VectorXd slips = model.programme.initial_gap.tail(static_cast<Index>(model.law.pair.size()));
  REQUIRE(slips.size() == 6);
  CHECK((slips.array().abs() - (0x1p-20 + 1e-13)).abs().maxCoeff() <= 1e-16);
}

TEST_CASE("gaps to a disc have digits of their own: small loads end in one step, in any unit", "[motion]") {
  for (const double unit : {1.0, 1000.0}) {
    for (const double part : {1e-4, 1e-7, 1e-9}) {
      CAPTURE(unit, part);
      Scene scene;
      Body& body = scene.bodies[0];
      body.mesh = block("wheel", {0, 0}, {3 * unit, 2 * unit}, 7, 4);
      body.material = {1000, 0.3, PlaneState::Strain, 1};
      body.supports = {prescribed("top", Axis::X, 0)};
      body.loads.edges = {{"top", 1000 * part, {}, "press"}};
      scene.contacts = {{{"bottom"}, disc({1.5 * unit, -60 * unit}, 60 * unit)}};
      scene.path = Path{{1}, {proportional("press")}};
      scene.moves = true;
      double worst = 1;
      const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
        worst = step.solution.certificate.worst();
      });
      INFO(end.reason);
      CHECK(end.status == SolveStatus::Solved);
      CHECK(end.halvings == 0);
      CHECK(worst <= 1e-12);
    }
  }
}

TEST_CASE("slips have digits of their own: small loads give the forces of bodies at rest",
          "[motion]") {
  Scene scene = moving_blocks();
  scene.bodies[1].supports.clear();
  const auto forces = [&scene] {
    VectorXd force;
    const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
      force = step.solution.contact.force;
    });
    INFO(end.reason);
    REQUIRE(end.status == SolveStatus::Solved);
    CHECK(end.halvings == 0);
    return force;
  };
  for (const double part : {1e-3, 1e-6, 1e-9, 1e-12, 1e-20}) {
    CAPTURE(part);
    scene.bodies[1].loads.edges = {{"top", 1000 * part, {}, "press"}};
    scene.moves = false;
    const VectorXd still = forces();
    CHECK(still.sum() == Approx(1000 * part).epsilon(1e-12));
    scene.moves = true;
    CHECK((forces() - still).norm() <= (10 * part + 1e-12) * still.norm());
  }
}

TEST_CASE("with one factor, contact forces that turn are a load", "[motion]") {
  MovingBlocks of;
  of.friction = 0;
  of.cells = 2;
  of.base_cells = 8;
  of.drag = 1;
  of.steps = 4;
  Scene scene = moving_blocks(of);
  for (Body& body : scene.bodies) body.element = "q4";
  scene.bodies[1].supports.pop_back();
  scene.bodies[1].loads.edges = {{"top", 100, {}, "press"}};
  scene.path->halvings = 0;
  long long most = 0, factors = 0, dropped = 0;
  const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
    most = std::max(most, step.solution.ledger.counted("pairs", "searches"));
    dropped += step.solution.ledger.counted("corrections", "dropped");
    for (const LedgerEntry& entry : step.solution.ledger.entries())
      if (const auto found = entry.counts.find("factors"); found != entry.counts.end())
        factors += found->second;
    CHECK(step.solution.certificate.holds());
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  CHECK(most <= 20);
  CHECK(dropped == 0);
  CHECK(factors == 0);
}

TEST_CASE("a path of moving bodies goes on from a state to the same bits", "[motion]") {
  const Scene scene = moving_blocks();
  std::vector<PathState> all;
  static_cast<void>(
      solve_steps(scene, [&](const Model&, const Step& step) { all.push_back(step.state); }));
  REQUIRE(all.size() == 13);
  std::ostringstream out;
  write_state(all[6], out);
  const PathState saved = read_state(out.str(), "saved");
  std::size_t k = 7;
  const PathEnd end = solve_steps(
      scene,
      [&](const Model&, const Step& step) {
        CHECK(step.state.solution.displacement == all[k].solution.displacement);
        CHECK(step.state.solution.displacement_low == all[k].solution.displacement_low);
        CHECK(step.state.solution.force == all[k].solution.force);
        CHECK(step.state.slip == all[k].slip);
        CHECK(step.state.contact_status == all[k++].contact_status);
      },
      saved);
  CHECK(end.status == SolveStatus::Solved);
  CHECK(k == all.size());
  MovingBlocks other;
  other.press = 0.02;
  CHECK_THAT(
      problem_message([&] { static_cast<void>(solve_steps(moving_blocks(other), {}, saved)); }),
      ContainsSubstring("is of another scene"));
  other.cells = 6;
  CHECK_THAT(
      problem_message([&] { static_cast<void>(solve_steps(moving_blocks(other), {}, saved)); }),
      ContainsSubstring("is of another scene"));
}

// Each step is taken twice, with what the state knows of the last way and without: both end at the same place.
TEST_CASE("a step begins where the way of the last one leads on, and takes fewer iterations",
          "[motion]") {
  MovingBlocks of;
  of.press = 0.05;
  of.drag = 1.25;
  of.steps = 15;
  Scene scene = moving_blocks(of);
  for (Body& body : scene.bodies) {
    body.element = "q4";
    body.material.law = find_strain_law("neo_hooke");
  }
  const std::vector<TakenTwice> steps = steps_taken_twice(scene, 1e-10);
  long long with = 0, without = 0;
  for (const auto& [before, step, blind] : steps) {
    if (before.way.displacement.size() > 0) {
      with += step.solution.ledger.counted("pairs", "searches");
      without += blind.solution.ledger.counted("pairs", "searches");
    } else {
      CHECK(step.state.steps <= 3);  // from the scene, at a turn of the loads and behind it
      CHECK(blind.state.solution.displacement == step.state.solution.displacement);
    }
  }
  CAPTURE(with, without);
  CHECK(10 * with <= 9 * without);
  CHECK(steps.back().step.state.began < steps.back().step.state.time);
}

TEST_CASE("what bodies that move cannot have is refused with the way out", "[motion]") {
  const auto message = [](const auto& change) {
    Scene scene = moving_blocks();
    change(scene);
    return problem_message([&] { static_cast<void>(plan(scene)); });
  };
  CHECK(message([](Scene&) {}).empty());
  CHECK_THAT(message([](Scene& s) {
               for (Body& body : s.bodies)
                 for (Support& support : body.supports) support.history = "";
               s.path.reset();
             }),
             ContainsSubstring("load steps") && ContainsSubstring("[[steps]]"));
  CHECK_THAT(message([](Scene& s) { s.contacts[0].gap_operator = "node_to_segment"; }),
             ContainsSubstring("mortar") && ContainsSubstring("segments"));
  CHECK_THAT(message([](Scene& s) { s.contacts[0].quadrature = Quadrature::SourceEdges; }),
             ContainsSubstring("quadrature"));
  CHECK_THAT(message([](Scene& s) { s.contacts[0].interference = 0.1; }),
             ContainsSubstring("draw"));
  CHECK_THAT(message([](Scene& s) { s.contacts[0].adjust = 0.1; }), ContainsSubstring("draw"));
  CHECK_THAT(message([](Scene& s) { s.contacts[0].small_sliding = true; }),
             ContainsSubstring("leave small_sliding out"));
  CHECK_THAT(message([](Scene& s) { s.contacts.clear(); }), ContainsSubstring("without contact"));
}

TEST_CASE("a source that leaves its target for good ends the path at the last good state",
          "[motion]") {
  MovingBlocks of;
  of.drag = 7;
  of.steps = 14;
  Scene scene = moving_blocks(of);
  scene.path->halvings = 3;
  const PathEnd end = solve_steps(scene);
  CHECK(end.status == SolveStatus::IterationLimit);
  CHECK(end.state.time > 1.5);
  CHECK_THAT(end.reason,
             ContainsSubstring("cannot come to stand where") && ContainsSubstring("the last good state"));
  CHECK_NOTHROW([&] {
    Model model = built(scene);
    check_state(end.state, model);
  }());
}

// The tool ends in the middle of half a ring, where every place of the ring is as near as any other. A point of the tool asks for
// what it faces: so each of its sides has the part of the ring that lies before it.
TEST_CASE("of targets that are equally near with opposite normals a point takes the one that it faces", "[motion]") {
  Scene scene;
  scene.bodies.resize(2);
  Body& ring = scene.bodies[0];
  ring.mesh = mapped(block("ring", {0, 0}, {1, 1}, 48, 4), [](const Vector2d& x) -> Vector2d {
    const double angle = pi * (0.5 + 2 * (x.x() - 0.5) * 0.9);
    return (1 + x.y()) * Vector2d(std::cos(angle), std::sin(angle));
  });
  ring.mesh = mapped(ring.mesh, [](const Vector2d& x) -> Vector2d { return {-x.x(), x.y()}; });
  Body& tool = scene.bodies[1];
  tool.mesh = block("tool", {-0.01, -0.4}, {0.02, 0.2}, 1, 4);
  for (const char* side : {"left", "right"})
    for (const CellSide& one : boundary(tool.mesh, side)) tool.mesh.boundaries["flanks"].push_back(one);
  ring.supports = {fixed("top")};
  tool.supports = {prescribed("bottom", Axis::X, 0), prescribed("bottom", Axis::Y, 0.3)};
  tool.supports[1].history = "rise";
  for (Body& body : scene.bodies) body.material = {1000, 0.3, PlaneState::Strain, 1};
  scene.contacts = {{{"flanks", "tool"}, Side{"bottom", "ring"}}};
  scene.path = Path{{1}, {proportional("rise")}};
  scene.moves = true;
  Index opposite = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    for (Index pair = 0; pair < model.pairs.weight.size(); ++pair) {
      const double side = model.pairs.position(pair, 0);
      CHECK(model.pairs.normal(pair, 0) * side < 0);
      CHECK(std::abs(step.solution.contact.gap(pair) - 0.95) <= 0.06);  // its nodes end 0 to 0.1 off the middle
      opposite += side > 0 ? 1 : 0;
    }
    CHECK(2 * opposite == model.pairs.weight.size());
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  CHECK(opposite > 0);
}

// At time 2 the block is far beyond the end of its base.
TEST_CASE("without halvings a step that fails is not tried in parts", "[motion]") {
  MovingBlocks of;
  of.drag = 7;
  of.steps = 1;
  Scene scene = moving_blocks(of);
  scene.path->halvings = 0;
  std::vector<double> times;
  const PathEnd end = solve_steps(
      scene, [&](const Model&, const Step& step) { times.push_back(step.state.time); });
  CHECK(end.status == SolveStatus::IterationLimit);
  CHECK(end.halvings == 0);
  CHECK(times == std::vector<double>{1});
  CHECK_THAT(end.reason, ContainsSubstring("may not be halved (halvings = 0)") &&
                             !ContainsSubstring("was halved"));
  scene.path->halvings = 1;
  times.clear();
  CHECK(solve_steps(scene, [&](const Model&, const Step& step) {
          times.push_back(step.state.time);
        }).halvings > 0);
  CHECK(times.size() > 1);
}

TEST_CASE("a body that turns is noted, and refused beyond 1e-2", "[motion]") {
  const auto scene = [](double turn) {
    Scene turns = moving_blocks();
    Body& body = turns.bodies[1];
    const auto given = [turn](Axis axis) {
      return prescribed("top", axis, [=](const Vector2d& x) {
        return axis == Axis::X ? 0 : -0.01 + turn * (x.x() - 1.5);
      });
    };
    body.supports = {given(Axis::X), given(Axis::Y)};
    turns.path = Path{{1}, {}};
    return turns;
  };
  CHECK_THAT(unsolved(scene(0.03), SolveStatus::TurnedTooFar),
             ContainsSubstring("body 'block' has turned by 0.01"));
  std::vector<std::string> notes;
  const PathEnd end = solve_steps(
      scene(0.004), [&](const Model&, const Step& step) { notes = step.solution.notes; });
  CHECK(end.status == SolveStatus::Solved);
  CHECK(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("has turned by 0.00") != std::string::npos;
  }));
}

TEST_CASE("the mean turn is that of a turn, and none of a strain", "[motion]") {
  const Mesh mesh = block("body", {1, 2}, {3, 1}, 3, 2);
  const std::vector<MeshPiece> whole = pieces(mesh);
  REQUIRE(whole.size() == 1);
  for (const double angle : {-3.0, -0.1, 1e-9, 0.3, 1.5, 3.1})
    CHECK(std::abs(mean_turn(mesh, whole[0], turned_by(angle, mesh.nodes)) - angle) <= 1e-14);
  Eigen::Matrix2d strain;
  strain << 0.1, 0.05, 0.05, -0.2;
  CHECK(std::abs(mean_turn(mesh, whole[0], mesh.nodes * strain)) <= 1e-15);
}

TEST_CASE("a ring that has been pressed outwards has its pairs at the radius where it stands", "[motion]") {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = block("inner", {1, 0}, {1, 1}, 2, 3);
  scene.bodies[1].mesh = block("outer", {2, -0.5}, {1, 2}, 2, 4);
  for (Body& body : scene.bodies) body.material = {1, 0.3, PlaneState::Axial, 1};
  scene.bodies[0].supports = {prescribed("left", Axis::X, 0.1), prescribed("left", Axis::Y, 0)};
  scene.bodies[0].supports[0].history = "press";
  scene.bodies[1].supports = {prescribed("right", Axis::Y, 0)};
  scene.contacts = {{{"right", "inner"}, Side{"left", "outer"}}};
  scene.path = Path{{1}, {proportional("press")}};
  scene.moves = true;
  double area = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    const Mesh& mesh = model.bodies[0].mesh;
    const NodeArray there = mesh.nodes + step.solution.displacements[0];
    for (const CellSide& side : boundary(mesh, "right")) {
      const std::vector<Index> ends = mesh.side_nodes(side);
      // Of a truncated cone.
      area += pi * (there(ends[0], 0) + there(ends[1], 0)) *
              (there.row(ends[1]) - there.row(ends[0])).norm();
    }
    CHECK(std::abs(model.pairs.weight.sum() - area) <= 1e-14 * area);
  });
  CHECK(end.status == SolveStatus::Solved);
  CHECK(area > 2.05 * 2 * pi);
}

// Moments of contact forces were asked for more digits than the places of pairs have.
TEST_CASE("bodies that are far from the origin by 1e4 of their sizes have the same forces",
          "[motion]") {
  for (const char* law : {"small", "neo_hooke"}) {
    CAPTURE(law);
    const auto forces = [law](double far) {
      MovingBlocks of;
      of.press = 0.005;
      of.drag = 0.3;
      of.steps = 2;
      Scene scene = moving_blocks(of);
      for (Body& body : scene.bodies) {
        body.mesh = moved(body.mesh, {far, -far});
        body.element = "q4";
        body.material.law = find_strain_law(law);
      }
      VectorXd force;
      const PathEnd end = solve_steps(
          scene, [&](const Model&, const Step& step) { force = step.solution.contact.force; });
      INFO(end.reason);
      CHECK(end.status == SolveStatus::Solved);
      return force;
    };
    const VectorXd near = forces(0);
    const VectorXd far = forces(1e4);
    REQUIRE(near.size() == far.size());
    // Meshes are rounded to 1e-12 there, and a height of 1 is pressed by 5e-3, nodes beside each other by a fifth of that.
    CHECK((near - far).cwiseAbs().maxCoeff() <= 1e-9 * near.maxCoeff());
  }
}

// Nodes have coordinates of few binary digits, so the meshes are the same to the last digit however far they are.
TEST_CASE("bodies keep the digits of their forces however far they are from the origin", "[motion]") {
  struct Far {
    VectorXd force;
    double worst = 0;
  };
  const auto forces = [](double away) {
    MovingBlocks of;
    of.press = 0.0078125;
    of.drag = 0.25;
    of.steps = 2;
    of.cells = 4;
    Scene scene = moving_blocks(of);
    for (Body& body : scene.bodies) body.mesh = moved(body.mesh, {away, -away});
    Far found;
    const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
      found.force = step.solution.contact.force;
      found.worst = std::max(found.worst, step.solution.certificate.worst());
    });
    INFO(end.reason);
    CHECK(end.status == SolveStatus::Solved);
    return found;
  };
  const Far near = forces(0);
  for (const double away : {128.0, 16384.0, 131072.0}) {
    CAPTURE(away);
    const Far far = forces(away);
    CHECK(far.worst <= 1e-12);
    REQUIRE(far.force.size() == near.force.size());
    const double off = (near.force - far.force).cwiseAbs().maxCoeff() / near.force.maxCoeff();
    // Places are rounded to 1e-16 of the size of all, and pressed by 1/128 of it.
    CHECK(off <= 1e-13);
  }
}
