// Pairs that slide: how far, when that is exact, when it is noted, and when a solution is none.
#include <algorithm>
#include <cmath>
#include <utility>

#include "addons/checks/follow.hpp"
#include "addons/checks/moved_forces.hpp"
#include "addons/checks/sliding.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/bodies.hpp"
#include "support/paths.hpp"
#include "support/random_scenes.hpp"
#include "support/sliding_scenes.hpp"
#include "support/two_bodies.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

constexpr double edge = 0.125;  // of the blocks that slide

/// A block of 8 edges, whose top is moved down and along, on something.
Scene ironed(double along, double down, std::variant<Obstacle, Side> target, double begin = 0) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = named_block("iron", {begin - 0.5, 0}, {1, 1}, 8, 8);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.supports = {prescribed("top", Axis::X, along), prescribed("top", Axis::Y, -down)};
  scene.contacts = {{{"bottom", "iron"}, std::move(target)}};
  return scene;
}

/// On a mesh of edges of the same length.
Scene on_base(double along, double down, const char* gap_operator = "mortar", double begin = 0) {
  Scene scene = ironed(along, down, Side{"top", "base"}, begin);
  scene.bodies.emplace_back();
  scene.bodies[1].mesh = named_block("base", {-2, -1}, {4, 1}, 32, 8);
  scene.bodies[1].material = scene.bodies[0].material;
  scene.bodies[1].supports = {fixed("bottom")};
  scene.contacts[0].gap_operator = gap_operator;
  return scene;
}

struct Solved {
  Model model;
  Condensed condensed;
  Solution solution;
};

Solved solved(const Scene& scene) {
  Ledger ledger;
  Model model = build(scene, ledger);
  Condensed condensed = condense(model, ledger);
  Solution solution = solve(model, condensed, ledger);
  return {std::move(model), std::move(condensed), std::move(solution)};
}

bool tells(const Solution& solution) {
  for (const std::string& note : solution.notes)
    if (note.find("Where the bodies have moved to") != std::string::npos) return true;
  return false;
}

SlidingChange only(const Solved& all) {
  return sliding_changes(
             all.model, all.condensed, [] { return 0.0; }, all.solution)
      .front();
}

}  // namespace

TEST_CASE("rows along tangents are the rows along normals, turned", "[sliding][friction]") {
  for (const GapOperator& gap_operator : gap_operators()) {
    Scene scene = on_base(0, 0.01, gap_operator.name);
    Mesh& base = scene.bodies[1]
                     .mesh;  // whose top bends, so that rows of several points have several normals
    base = mapped(base, [](const Vector2d& x) {
      return Vector2d(x.x(), x.y() - (1 + x.y()) * x.x() * x.x() / 8);
    });
    scene.contacts[0].friction = Friction{0.3};
    Ledger ledger;
    const Model model = build(scene, ledger);
    CAPTURE(gap_operator.name);
    REQUIRE(model.pairs.sliding.norm() > 1);
    CHECK((turned(model.pairs.opening) - model.pairs.sliding).norm() <= 1e-15);
  }
}

TEST_CASE(
    "the force that sliding_changes() tells is that on the source, whichever body comes first",
    "[sliding]") {
  for (const bool swapped : {false, true}) {
    Scene scene = on_base(0.5 * edge, 0.01);
    if (swapped) std::swap(scene.contacts[0].source, std::get<Side>(scene.contacts[0].target));
    const SlidingChange one = only(solved(scene));
    CAPTURE(swapped);
    REQUIRE(one.new_force);
    CHECK(one.moves);
    CHECK(one.force.y() * (swapped ? -1 : 1) > 0.9 * one.normal);
    CHECK(one.new_force->y() * (swapped ? -1 : 1) > 0.9 * one.normal);
  }
}

TEST_CASE("slips told by displacements are those of friction", "[sliding][friction]") {
  int seen = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) try {
      Scene scene = random_scene(seed, RandomScenes::Frictional).scene;
      for (ContactSpec& contact : scene.contacts) contact.small_sliding = true;
      const Solved all = solved(scene);
      const ContactState& contact = all.solution.contact;
      if (contact.report.status != SolveStatus::Solved) continue;
      const Eigen::VectorXd slip = slips(all.model, all.solution.displacements);
      double size = 0;
      for (const NodeArray& u : all.solution.displacements)
        size = std::max(size, u.cwiseAbs().maxCoeff());
      for (std::size_t k = 0; k < contact.frictional_pairs.size(); ++k) {
        CAPTURE(seed, k);
        CHECK(slip(contact.frictional_pairs[k]) ==
              Approx(contact.slip(static_cast<Index>(k))).margin(1e-12 * size));
        ++seen;
      }
    } catch (const ProblemError&) {  // no scene
    }
  CHECK(seen > 300);
}

TEST_CASE("along a half plane sliding is exact however far it goes", "[sliding]") {
  for (const double along : {0.01, 1.0, 24.0}) {
    CAPTURE(along);
    const Solved all = solved(ironed(along, 0.01, half_plane({0, 0}, {0, 1})));
    REQUIRE(all.solution.contact.report.status == SolveStatus::Solved);
    CHECK_FALSE(tells(all.solution));
    CHECK(all.model.followed == nullptr);
    // Poisson's ratio widens the block evenly about its middle, which moves as the top does.
    const Eigen::VectorXd slip = slips(all.model, all.solution.displacements);
    CHECK(slip.mean() == Approx(along).epsilon(1e-12));
  }
}

// A block that slid over a rigid disc by s is the block that was meshed there: its force is known.
//
// Its bottom lags behind its top, because the force N acts s beside its middle and bends it: by N s / (2 E' I) = 6 (N / E') s as a
// beam of height and width 1, that is by less than 0.09 s with N / E' < 0.015. A lag turns N by 0.09 s / R: 0.0007 N at a
// quarter of an edge, where the force changes by 0.01 N, and changes grow faster than s. So slips, forces and changes are foreseen
// to a tenth. Seen: lags of 0.048 to 0.064, no larger with four times as many cells along each side; forces to 0.05 of the change,
// and half the depth, which is less than half the force, leaves a quarter of that.
TEST_CASE("the force where a block has moved to over a disc is foreseen", "[sliding]") {
  const double down = 0.02;
  const Obstacle round = disc({0, -4}, 4);
  for (const double edges : {0.25, 0.5, 1.0, 1.5}) {
    CAPTURE(edges);
    Scene scene = ironed(edges * edge, down, round);
    scene.contacts[0].small_sliding = true;
    const Solved all = solved(scene);
    const Solved there = solved(ironed(0, down, round, edges * edge));
    const SlidingChange foreseen = only(all);
    const SlidingChange true_end = only(there);
    const double change = (true_end.force - foreseen.force).norm() / foreseen.normal;
    REQUIRE(foreseen.new_force);
    CHECK((*foreseen.new_force - true_end.force).norm() <= 0.1 * change * true_end.normal);
    CHECK(foreseen.change == Approx(change).epsilon(0.1));
    CHECK(tells(all.solution) == (foreseen.change > 0.025));
    if (change > 0.05) CHECK(tells(all.solution));
    CHECK_FALSE(tells(there.solution));
    CHECK(foreseen.edge == edge);
    CHECK(foreseen.slip == Approx(edges * edge).epsilon(0.1));
  }
}

TEST_CASE("of uneven edges the pair that slid by most of its own is told", "[sliding]") {
  for (const double bend : {-0.3, 0.3}) {
    Scene scene = ironed(0.5 * edge, 0.02, disc({0, -4}, 4));
    Mesh& iron = scene.bodies[0].mesh;
    iron = mapped(iron,
                  [&](const Vector2d& x) { return Vector2d(x.x() + bend * x.x() * x.x(), x.y()); });
    scene.contacts[0].small_sliding = true;
    const Solved all = solved(scene);
    const std::vector<Index> nodes = boundary_nodes(iron, "bottom");  // from the left
    const Eigen::VectorXd slip = slips(all.model, all.solution.displacements).cwiseAbs();
    const auto own_edge = [&](Index pair) {  // the longer of those beside its node
      const auto at = std::find(nodes.begin(), nodes.end(), all.model.pairs.node[pair]);
      const auto length = [&](auto left) {
        return iron.nodes(left[1], 0) - iron.nodes(left[0], 0);
      };
      return std::max(at == nodes.begin() ? 0 : length(at - 1),
                      at + 1 == nodes.end() ? 0 : length(at));
    };
    Index most = -1;
    for (Index pair = 0; pair < slip.size(); ++pair)
      if (all.solution.contact.force(pair) > 0 &&
          (most < 0 || slip(pair) / own_edge(pair) > slip(most) / own_edge(most)))
        most = pair;
    const SlidingChange one = only(all);
    CAPTURE(bend);
    CHECK(one.pair == most);
    CHECK(one.edge == Approx(own_edge(most)).epsilon(1e-12));
  }
}

TEST_CASE("a change is by the force as solved, also where it grows", "[sliding]") {
  Scene scene = ironed(edge, 0.01, hole({0, 4}, 4));
  scene.contacts[0].small_sliding = true;
  const Solved all = solved(scene);
  const SlidingChange one = only(all);
  REQUIRE(one.new_force);
  REQUIRE(one.new_force->y() > 1.05 * one.force.y());
  CHECK(one.change * all.solution.contact.force.sum() >= (*one.new_force - one.force).norm());
}

TEST_CASE("past the end of a target the force is that of what is still on it", "[sliding]") {
  Scene scene = on_base(2.5 * edge, 0.01, "mortar", 1.5);  // the base ends where the iron does
  scene.contacts[0].small_sliding = true;
  const SlidingChange one = only(solved(scene));
  const SlidingChange true_end = only(solved(on_base(0, 0.01, "mortar", 1.5 + 2.5 * edge)));
  REQUIRE(one.new_force);
  // 0.6875 is still on the base, its middle 0.156 beside that of the iron. The lag is 6 * 0.005 * 0.156 = 0.0047, as above with
  // N / E' = 0.01 / 2, and the bottom widens by 0.43 * 0.005 / 2: together 0.9 % of what is on the base. Seen: 0.7 %.
  CHECK(one.new_force->y() == Approx(true_end.force.y()).epsilon(0.01));
}

TEST_CASE("past an edge a solution is none, unless the contact says so", "[sliding]") {
  for (const double edges : {0.2, 0.6, 1.4, 10.0}) {
    Scene scene = on_base(edges * edge, 0.01);
    const Solution usual = solved(scene).solution;
    CAPTURE(edges, usual.contact.reason);
    CHECK(usual.contact.report.status ==
          (edges > 1 ? SolveStatus::SlidTooFar : SolveStatus::Solved));
    if (edges < 0.25) CHECK_FALSE(tells(usual));
    if (edges > 1) {
      CHECK_THAT(usual.contact.reason, ContainsSubstring("contact iron.bottom on base.top") &&
                                           ContainsSubstring("of its edge") &&
                                           ContainsSubstring("small_sliding = true"));
      CHECK_THROWS_WITH(require_solved(usual, "the iron"), ContainsSubstring("slid too far"));
    }
    scene.contacts[0].small_sliding = true;
    const Solution kept = solved(scene).solution;
    CHECK(kept.contact.report.status == SolveStatus::Solved);
    CHECK(tells(kept) == (edges > 1));
    CHECK(kept.contact.force == usual.contact.force);
  }
}

TEST_CASE("load steps end before a pair is past its edge in total", "[sliding][steps]") {
  Scene scene = on_base(2 * edge, 0.01);
  scene.bodies[0].supports[0].history = "drag";
  scene.path = Path{equal_steps(10), {proportional("drag")}};
  const PathEnd end = solve_steps(scene);
  CHECK(end.status == SolveStatus::SlidTooFar);
  // At 0.4 the top has moved by 0.8 edges; at 0.5 by one, and the transverse strain takes the outer pairs further.
  CHECK(end.state.time == Approx(0.4).epsilon(1e-12));
  CHECK(end.halvings == 0);
  CHECK_FALSE(end.limit);
  CHECK_THAT(end.reason, ContainsSubstring("slid too far") && ContainsSubstring("small_sliding") &&
                             ContainsSubstring("the last good state"));
  scene.contacts[0].small_sliding = true;
  CHECK(solve_steps(scene).status == SolveStatus::Solved);
}

TEST_CASE("pairs found where bodies moved together are those that they were", "[sliding]") {
  for (const GapOperator& gap_operator : gap_operators()) {
    Ledger ledger;
    Model model = build(on_base(0, 0.01, gap_operator.name), ledger);
    NodeArray together(count_nodes(model.bodies), 2);
    together.rowwise() = Eigen::RowVector2d(3, -0.25);
    const MovedPairs there = follow(*model.followed, model, together);
    CAPTURE(gap_operator.name);
    CHECK((there.opening - model.pairs.opening).norm() <= 1e-12);
    CHECK(there.opens.cwiseAbs().maxCoeff() <= 1e-13);
    CHECK(there.fresh_gap.size() == 0);
    CHECK(there.edge == Eigen::VectorXd::Constant(there.edge.size(), edge));
  }
}

TEST_CASE("a pair that faces nothing any more is open, one that is new and overlaps is seen",
          "[sliding]") {
  Scene scene = on_base(0, 0.01);
  std::swap(scene.contacts[0].source, std::get<Side>(scene.contacts[0].target));
  Ledger ledger;
  const Model model = build(scene, ledger);
  NodeArray moved = NodeArray::Zero(count_nodes(model.bodies), 2);
  moved.topRows(model.bodies[0].mesh.n_nodes()).rowwise() = Eigen::RowVector2d(2 * edge, -0.01);
  const MovedPairs there = follow(*model.followed, model, moved);
  CHECK(there.opens.array().isInf().count() == 2);
  CHECK(there.fresh_gap.size() == 2);
  CHECK((there.fresh_gap.array() + 0.01).abs().maxCoeff() <= 1e-15);
  CHECK(there.fresh_contact == std::vector<std::size_t>{0, 0});
}

TEST_CASE("gaps of a pin that are linear stay linear", "[sliding]") {
  const Obstacle pin = pin_in_hole({0, 0}, 0.1, {0, 0});
  CHECK(pin.linear);
  CHECK_FALSE(disc({0, 0}, 1).linear);
  Ledger ledger;
  const Scene scene = ironed(0, 0.01, pin, 3);
  const Model model = build(scene, ledger);
  CHECK(model.followed == nullptr);
  NodeArray moved(count_nodes(model.bodies), 2);
  moved.rowwise() = Eigen::RowVector2d(0.5, -0.25);
  const MovedPairs there = follow({{scene.contacts[0], model.pairs.initial_gap}}, model, moved);
  const Eigen::Map<const Eigen::VectorXd> u(moved.data(), moved.size());
  CHECK(there.opening.isApprox(model.pairs.opening, 0));
  CHECK((there.opens - model.pairs.opening * u).norm() == 0);
}

TEST_CASE("where a force changes by more than 5 % as bodies move, it is said",
          "[sliding][random]") {
  int changed = 0;
  int vain = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const SlidingTrial trial = try_sliding(seed);
    CAPTURE(seed, trial.text, trial.change);
    const bool said = trial.refused || trial.noted;
    if (!trial.found) continue;
    if (trial.change > 0.05) CHECK(said);
    changed += trial.change > 0.05 ? 1 : 0;
    vain += said && trial.change < 0.01 ? 1 : 0;
  }
  CHECK(changed >= 15);
  CHECK(vain <= 3);
}
