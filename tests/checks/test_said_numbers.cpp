// Counts, lengths and ranges in notes, each of a scene where another number would be wrong.
#include <limits>
#include <utility>

#include "addons/certified/end_words.hpp"
#include "addons/checks/fit_warnings.hpp"
#include "addons/checks/shared_words.hpp"
#include "addons/effects/fit.hpp"
#include "catch_compat.hpp"
#include "support/doubtful_scenes.hpp"
#include "support/loose_meshes.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

std::string notes_of(const Scene& scene) {
  std::string all;
  for (const std::string& note : plan(scene).notes) all += note + '\n';
  return all;
}

Model built(const Scene& scene) {
  Ledger ledger;
  return build(scene, ledger);
}

/// Two blocks on each other, both held at the far end.
Scene held_blocks(Mesh lower, Mesh upper) {
  Scene scene = two_blocks(std::move(lower), std::move(upper));
  scene.bodies[1].supports = {fixed("top")};
  return scene;
}

Scene doubtful(const std::string& mistake) {
  for (const DoubtfulScene& one : doubtful_scenes())
    if (one.mistake == mistake) return one.scene;
  throw std::invalid_argument(mistake);
}

}  // namespace

TEST_CASE("of forces that are not determined four are told, each with the ends that it has",
          "[said]") {
  constexpr double far = std::numeric_limits<double>::infinity();
  const Model model = built(held_blocks(named_block("lower", {0, 0}, {2, 1}, 8, 1),
                                        named_block("upper", {0, 1}, {2, 1}, 8, 1)));
  Solution solution;
  solution.refined.force = Eigen::VectorXd::Zero(model.pairs.opening.rows());
  SharedForces group;
  group.pairs = {0, 1, 3, 4, 5};
  group.exchanges.resize(solution.refined.force.size(), 1);
  group.forces = {{0, 7, far}, {1, -far, 8}, {3, 1, 2}, {4, -far, far}, {5, 3, 9}};
  solution.shared = {group};
  const std::string said = shared_forces_in_words(model, solution, 0);
  CHECK_THAT(said, ContainsSubstring("5 pairs are not determined (0, 1, 3 to 5)") &&
                       ContainsSubstring("presses with 7 or more, pair 1 of ") &&
                       ContainsSubstring("presses with 8 or less, pair 3 of ") &&
                       ContainsSubstring("presses with 1 to 2, pair 4 of ") &&
                       ContainsSubstring("presses with any force; pairs ") &&
                       ContainsSubstring("Their rows repeat each other"));
}

TEST_CASE("where Lemke's method runs off, the largest friction and cohesion are told", "[said]") {
  Scene scene;
  scene.bodies[0].mesh = named_block("stone", {0, 0}, {2, 1}, 4, 2);
  scene.bodies[0].material = {1000, 0.3, PlaneState::Strain, 1};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = Friction{0.5, 0.7};
  CHECK_THAT(ray_in_words(built(scene)),  // the pairs at the ends stand for half an edge
             ContainsSubstring("coefficient is 0.5, of pair 0 of node 0") &&
                 ContainsSubstring("the largest cohesion of a pair 0.35;"));
}

TEST_CASE("a length is compared with the thinner of two bodies", "[said][fit]") {
  const Scene scene = held_blocks(named_block("lower", {0, 0}, {2, 1}, 2, 1),
                                  named_block("upper", {0, 1}, {2, 3}, 2, 3));
  const Model model = built(scene);
  const auto warning = [&](double length) {
    return fit_warning(scene.contacts[0], model.bodies, "interference", length);
  };
  CHECK(warning(0.9).empty());
  CHECK_THAT(warning(2), ContainsSubstring("2 is more than the thinner body is thick there, 1."));
}

TEST_CASE("a gap that was closed is compared with the smaller of two bodies", "[said][fit]") {
  Model model = built(held_blocks(named_block("lower", {0, 0}, {8, 6}, 4, 3),
                                  named_block("upper", {0, 6}, {4, 3}, 2, 2)));
  Solution solution;
  solution.contact.force = Eigen::VectorXd::Unit(model.pairs.initial_gap.size(), 2);
  solution.contact.contact_status.assign(std::size_t(model.pairs.initial_gap.size()), ContactStatus::Open);
  solution.contact.contact_status[2] = ContactStatus::Stick;
  model.pairs.initial_gap(2) = 20;
  const std::vector<std::string> warnings = closed_gap_warnings(model, solution);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], ContainsSubstring("closed a gap of 20, 4 times the size of 'upper'"));
}

TEST_CASE("gaps and overlaps that cancel are no gaps of nothing", "[said][fit]") {
  const Scene scene = doubtful("edges with more sag than clearance");
  const Model model = built(scene);
  Pairs pairs = model.pairs;
  const auto warning = [&] { return sag_warning(scene.contacts[0], model.bodies, pairs); };
  CHECK_FALSE(warning().empty());
  pairs.initial_gap.setZero();
  pairs.initial_gap(0) = 1;
  pairs.initial_gap(1) = -1;
  CHECK(warning().empty());
}

TEST_CASE("of a press fit the sag is measured by the interference, of adjusted gaps by what adjusts them", "[said][fit]") {
  Scene scene = doubtful("edges with more sag than clearance");
  const Model model = built(scene);
  const auto warning = [&](double interference, double adjust) {
    scene.contacts[0].interference = interference;
    scene.contacts[0].adjust = adjust;
    Pairs pairs = model.pairs;
    pairs.initial_gap.setConstant(-interference);
    const std::vector<std::string> all = sag_warning(scene.contacts[0], model.bodies, pairs);
    return all.empty() ? "" : all[0];
  };
  const std::string said = warning(1e-9, 0);
  const double sag = std::stod(said.substr(said.find("lie up to ") + 10));
  CHECK_THAT(warning(2 * sag, 0), ContainsSubstring(text("but the interference is ", 2 * sag)));
  CHECK(warning(30 * sag, 0).empty());
  CHECK(warning(2 * sag, 1.1 * sag).empty());
}

TEST_CASE("the corners of a source are counted, not its nodes", "[said]") {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = named_block("block", {0, 0}, {2, 1}, 4, 2);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.supports = {fixed("top")};
  std::vector<CellSide>& round = body.mesh.boundaries["round"] = body.mesh.boundaries["bottom"];
  for (const CellSide& side : body.mesh.boundaries["right"]) round.push_back(side);
  scene.contacts = {{{"round"}, half_plane({0, -1}, {0, 1})}};
  CHECK_THAT(notes_of(scene),
             ContainsSubstring("turns by 90 degrees at node 4, (2, 0), and by more than 30 at 1 "
                               "node:"));
}

TEST_CASE("the nodes that have passed through a plate are counted", "[said]") {
  const Scene scene = doubtful("a source that passes through a thin target");
  const Mesh& disc = scene.bodies[1].mesh;
  Index below = 0;
  for (const Index node : boundary_nodes(disc, "rim"))
    if (disc.nodes(node, 1) < -0.1) ++below;  // the plate is 0.1 thick
  CHECK_THAT(notes_of(scene),
             ContainsSubstring(text(": ", below,
                                    " source nodes lie behind the target, up to 0.2 "
                                    "deep")));
}

TEST_CASE("nodes that coincide and nodes that hang are counted each by themselves", "[said]") {
  Scene scene;
  Body& body = scene.bodies[0];
  Mesh hanging = hanging_block(3);
  hanging.nodes.col(0).array() += 10;
  body.mesh = together(split_block(0.5, 2), hanging);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.supports = {fixed("bottom"), fixed("bottom22")};
  CHECK_THAT(notes_of(scene), ContainsSubstring(": 3 nodes coincide with others") &&
                                  ContainsSubstring(": 4 nodes hang on the side"));
}

TEST_CASE("of gaps that are left the smallest is told, and where it is", "[said]") {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = named_block("block", {0, 0}, {2, 1}, 4, 2);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.supports = {fixed("top")};
  scene.contacts = {{{"bottom"}, half_plane({2, -1}, {-0.6, 0.8})}};  // gap 2 - 0.6 x
  const std::vector<std::string> notes = solve(scene).notes;
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], ContainsSubstring("the smallest gap left is 0.8, at (2, 0)."));
}
