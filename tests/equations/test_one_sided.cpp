// Relations that hold up to a number, as contact does: stops, levers, and the seat of a preloaded bolt.
#include <cmath>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/contact/obstacle.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using signorini_test::message_of, signorini_test::problem_message;

namespace {

/// E = 1000 and nu = 0, between lines of symmetry at its left and lower side, pulled upwards at its top.
Body bar(Mesh mesh, double pull) {
  Body body;
  body.mesh = std::move(mesh);
  body.material = {1000, 0, PlaneState::Stress};
  body.supports = {symmetric("bottom"), symmetric("left")};
  EdgeLoad load;
  load.boundary = "top";
  load.traction = [pull](const Vector2d&) { return Vector2d(0, pull); };
  body.loads.edges = {load};
  return body;
}

RelationTerm term(const Side& side, double times = 1) { return {side, {}, {0, 1}, times}; }

RelationTerm point(const Side& side, const Vector2d& at, double times) { return {side, at, {0, 1}, times}; }

void bind(Scene& scene, const std::vector<Relation>& relations) {
  Bonds bonds;
  bonds.relations = relations;
  scene.bonds = std::make_shared<const Bonds>(bonds);
}

Scene one_bar(double pull, const Relation& relation) {
  Scene scene;
  scene.bodies = {bar(block("bar", {0, 0}, {2, 4}, 2, 3), pull)};
  bind(scene, {relation});
  return scene;
}

double top_of(const SolvedScene& run, std::size_t body) {
  const std::vector<Index> nodes = boundary_nodes(run.model.bodies[body].mesh, "top");
  const VectorXd u = run.solution.displacements[body](nodes, 1);
  CHECK((u.array() - u(0)).abs().maxCoeff() <= 1e-13 * std::abs(u(0)));
  return u(0);
}

}  // namespace

// Stiffness E b / h = 500: a pull of 10 moves the top by 0.02, and a stop at 0.008 bears 10 - 500 * 0.008 = 6.
TEST_CASE("a side stops at the number of a relation", "[one_sided]") {
  const double sign = GENERATE(1, -1);
  const Holds holds = sign > 0 ? Holds::AtMost : Holds::AtLeast;
  const SolvedScene run = solved(one_bar(5 * sign, {{term({"top", "bar"})}, 0.008 * sign, {}, holds}), "the bar");
  CHECK(top_of(run, 0) == Approx(0.008 * sign).epsilon(1e-14));
  CHECK(run.solution.contact.force.sum() == Approx(6).epsilon(1e-12));
  CHECK(run.solution.contact.active().size() == 3);
  CHECK((run.solution.pressure.array() - 3).abs().maxCoeff() <= 1e-11);
  CHECK(run.model.contacts == std::vector<std::string>{"relation 1"});
  const Resultants sum = resultants_of_contacts(run.model, run.solution)[0];
  CHECK(sum.force.y() == Approx(-6 * sign).epsilon(1e-12));
  CHECK(sum.moment == Approx(-6 * sign).epsilon(1e-12));
  const SolvedScene open = solved(one_bar(5 * sign, {{term({"top", "bar"})}, 0.03 * sign, {}, holds}), "the bar");
  CHECK(open.solution.contact.force.cwiseAbs().maxCoeff() == 0);
  CHECK((open.solution.contact.gap.array() - 0.01).abs().maxCoeff() <= 1e-15);
}

TEST_CASE("a relation that is multiplied is told as it was", "[one_sided]") {
  const auto times = [](double factor) {
    return solved(one_bar(5, {{term({"top", "bar"}, factor)}, 0.008 * factor, {}, Holds::AtMost}), "the bar");
  };
  const SolvedScene one = times(1);
  for (const double factor : {10.0, 1e8, 1e-8}) {
    const SolvedScene other = times(factor);
    CHECK((other.solution.contact.force - one.solution.contact.force).cwiseAbs().maxCoeff() <= 1e-12 * 3);
    CHECK((other.solution.pressure - one.solution.pressure).cwiseAbs().maxCoeff() <= 1e-12 * 3);
    CHECK((other.model.pairs.normal - one.model.pairs.normal).cwiseAbs().maxCoeff() <= 1e-15);
  }
}

// The load pulls at the right and pushes at the left, so that one node of three reaches the plane.
TEST_CASE("a relation of one displacement is contact with a half-plane", "[one_sided]") {
  Scene relation = one_bar(0, {{term({"top", "bar"})}, 0.004, {}, Holds::AtMost});
  relation.bodies[0].loads.edges[0].traction = [](const Vector2d& x) { return Vector2d(0, 20 * x.x() - 18); };
  Scene contact = relation;
  contact.bonds = nullptr;
  ContactSpec plane;
  plane.source = {"top", "bar"};
  plane.target = half_plane({0, 4.004}, {0, -1});
  contact.contacts = {plane};
  const SolvedScene one = solved(relation, "the relation"), two = solved(contact, "the contact");
  const double most = two.solution.contact.force.maxCoeff();
  CHECK(two.solution.contact.active().size() == 1);
  CHECK(one.solution.contact.active() == two.solution.contact.active());
  CHECK((one.solution.contact.force - two.solution.contact.force).cwiseAbs().maxCoeff() <= 1e-12 * most);
  CHECK((one.solution.pressure - two.solution.pressure).cwiseAbs().maxCoeff() <= 1e-12 * most);
}

// The bottom rubs on a plane, the right side comes to a stop: as a second contact, and as a relation behind the first one. Pressed first, then pulled.
TEST_CASE("a relation stands behind a contact with friction, in load steps, too", "[one_sided][steps]") {
  Scene relation = one_bar(0, {{{{"right", "bar"}, {}, {1, 0}, 1}}, 0.002, {}, Holds::AtMost});
  relation.bodies[0].supports.clear();
  EdgeLoad& press = relation.bodies[0].loads.edges[0];
  press.traction = [](const Vector2d& x) { return Vector2d(0, -4 - x.x()); };
  press.history = "press";
  EdgeLoad pull = press;
  pull.boundary = "left";
  pull.traction = [](const Vector2d&) { return Vector2d(2, 0); };
  pull.history = "pull";
  relation.bodies[0].loads.edges.push_back(pull);
  relation.path = Path{{0.5, 1, 1.5, 2}, {{"press", {0, 1}, {0, 1}}, {"pull", {1, 2}, {0, 1}}}};
  ContactSpec ground;
  ground.source = {"bottom", "bar"};
  ground.target = half_plane({0, 0}, {0, 1});
  ground.friction = Friction{0.3};
  relation.contacts = {ground};
  Scene contact = relation;
  contact.bonds = nullptr;
  ContactSpec stop;
  stop.source = {"right", "bar"};
  stop.target = half_plane({2.002, 0}, {-1, 0});
  contact.contacts.push_back(stop);
  std::vector<Solution> one, two;
  const auto keep = [](std::vector<Solution>& all) {
    return [&all](const Model&, const Step& step) { all.push_back(step.solution); };
  };
  REQUIRE(solve_steps(relation, keep(one)).status == SolveStatus::Solved);
  REQUIRE(solve_steps(contact, keep(two)).status == SolveStatus::Solved);
  REQUIRE(one.size() == two.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    CAPTURE(k);
    CHECK(one[k].contact.contact_status == two[k].contact.contact_status);
    const double most = two[k].contact.force.maxCoeff();
    CHECK((one[k].contact.force - two[k].contact.force).cwiseAbs().maxCoeff() <= 1e-11 * most);
    CHECK((one[k].contact.friction - two[k].contact.friction).cwiseAbs().maxCoeff() <= 1e-11 * most);
  }
  CHECK(one.back().contact.force.tail(4).sum() > 0.1 * one.back().contact.force.sum());
}

// Bars of stiffness 1000 and 2000: u1 = (10 - 2 f) / 1000 and u2 = -f / 2000, and 2 u1 + u2 = 0.01 says f (0.004 + 0.0005) = 0.01.
TEST_CASE("a force on a lever acts on all terms", "[one_sided]") {
  Scene scene;
  scene.bodies = {bar(block("one", {0, 0}, {2, 2}, 3, 2), 5), bar(block("two", {5, 0}, {2, 1}, 3, 2), 0)};
  bind(scene, {{{term({"top", "one"}, 2), term({"top", "two"})}, 0.01, {}, Holds::AtMost}});
  const SolvedScene run = solved(scene, "the lever");
  const double force = 0.01 / 0.0045;
  CHECK(run.solution.contact.force.sum() == Approx(2 * force).epsilon(1e-12));  // on the first term
  CHECK(top_of(run, 0) == Approx((10 - 2 * force) / 1000).epsilon(1e-12));
  CHECK(top_of(run, 1) == Approx(-force / 2000).epsilon(1e-12));
  CHECK(support_forces(run.model, run.solution, 1).col(1).sum() == Approx(force).epsilon(1e-11));
  CHECK(resultants_of_contacts(run.model, run.solution)[0].force.y() == Approx(-2 * force).epsilon(1e-12));
}

// What supports move is in the gap: the stop is at 0.008 above a plate that is moved up by 0.004, so that it bears 10 - 500 * 0.012.
TEST_CASE("a number is reached where supports have moved the other side to", "[one_sided]") {
  Scene scene = one_bar(5, {{term({"top", "bar"}), term({"bottom", "plate"}, -1)}, 0.008, {}, Holds::AtMost});
  scene.bodies.push_back(bar(block("plate", {5, 0}, {2, 1}, 2, 1), 0));
  scene.bodies[1].supports = {prescribed("bottom", Axis::Y, 0.004), symmetric("left")};
  const SolvedScene run = solved(scene, "the bar and the plate");
  CHECK(top_of(run, 0) == Approx(0.012).epsilon(1e-13));
  CHECK(run.solution.contact.force.sum() == Approx(4).epsilon(1e-12));
  CHECK(support_forces(run.model, run.solution, 1).col(1).sum() == Approx(-4).epsilon(1e-11));
}

// A relation is all that holds the bar along y, and another one is never reached.
TEST_CASE("relations stop rigid motions", "[one_sided]") {
  Scene scene = one_bar(-5, {{term({"top", "bar"})}, 1, {}, Holds::AtMost});
  scene.bodies[0].supports = {symmetric("left")};
  Bonds bonds = *scene.bonds;
  bonds.relations.push_back({{term({"bottom", "bar"})}, -0.1, {}, Holds::AtLeast});
  scene.bonds = std::make_shared<const Bonds>(bonds);
  const SolvedScene run = solved(scene, "the bar");
  CHECK(top_of(run, 0) == Approx(-0.12).epsilon(1e-13));
  const std::vector<Resultants> sums = resultants_of_contacts(run.model, run.solution);
  CHECK(sums[0].force.y() == 0);
  CHECK(sums[1].force.y() == Approx(10).epsilon(1e-12));
  bonds.relations.pop_back();
  scene.bonds = std::make_shared<const Bonds>(bonds);
  CHECK(message_of<std::exception>([&] { static_cast<void>(solved(scene, "the bar")); }).find("can move freely in direction y") !=
        std::string::npos);
}

// A cylinder of radius 2, nu = 0: 0.008 of its 0.02 are left, E eps = 2 of the pull of 5.
TEST_CASE("in axial symmetry the force of a relation is that of the circle", "[one_sided]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    Scene scene = one_bar(5, {{term({"top", "bar"})}, 0.008, {}, Holds::AtMost});
    scene.bodies[0].mesh = block("bar", {0, 0}, {2, 4}, 2, 3, order);
    scene.bodies[0].material.state = PlaneState::Axial;
    scene.bodies[0].supports = {symmetric("bottom")};
    const SolvedScene run = solved(scene, "the cylinder");
    CHECK(run.solution.contact.force.sum() == Approx(std::acos(-1.0) * 4 * 3).epsilon(1e-11));
    CHECK(top_of(run, 0) == Approx(0.008).epsilon(1e-13));
  }
}

namespace {

/// Half of a bolt that is cut through, and half of the sleeve that it clamps: k_b = 1000 * 2 / 20 = 100, k_m = 300. The top of the
/// bolt stays level, and the sleeve is seated on it.
Scene bolt(double pull, const Relation& cut) {
  Scene scene;
  scene.bodies = {bar(block("shank", {0, 0}, {2, 10}, 2, 3), 0), bar(block("nut", {0, 10}, {2, 10}, 2, 3), pull / 2),
                  bar(block("sleeve", {4, 0}, {6, 20}, 2, 5), 0)};
  scene.bodies[1].supports = {symmetric("left")};
  const RelationTerm middle = point({"top", "nut"}, {0, 20}, -1);
  const Relation level = {{term({"top", "nut"}), middle}, 0};
  const Relation seat = {{term({"top", "sleeve"}), middle}, 0, {}, Holds::AtMost};
  bind(scene, {cut, level, seat});
  return scene;
}

const Relation drawn_together = {{term({"bottom", "nut"}), term({"top", "shank"}, -1)}, -0.04};

}  // namespace

// The cut is drawn together by 0.04: F0 = 0.04 k_b k_m / (k_b + k_m) = 3. A pull of P leaves F0 - P k_m / (k_b + k_m) between nut
// and sleeve, which is 0 at P = 4; the bolt has F0 + P k_b / (k_b + k_m), and all of P from there on.
TEST_CASE("a bolt is drawn together by a length", "[one_sided][pretension]") {
  const double pull = GENERATE(0.0, 2.0, 3.5, 6.0);
  const SolvedScene run = solved(bolt(pull, drawn_together), "the bolt");
  const double seat = std::max(0.0, 3 - pull * 0.75);
  const std::vector<BondForces> sums = bond_forces(run.model, run.solution);
  CHECK(sums[0].force.y() == Approx(-(pull + seat)).epsilon(1e-11));
  CHECK(run.solution.contact.force.sum() == Approx(seat).epsilon(1e-11).margin(1e-12));
  CHECK(support_forces(run.model, run.solution, 0).col(1).sum() == Approx(-(pull + seat)).epsilon(1e-11));
}

// The pull grows to 6 at the time 1 and the sleeve is raised to 0.02: a share t of both leaves (0.04 + 0.02 t) 75 - 0.75 * 6 t, which is 0 at t = 1.
TEST_CASE("load steps close and open what holds up to a number", "[one_sided][steps]") {
  Scene scene = bolt(6, drawn_together);
  scene.bodies[1].loads.edges[0].history = "pull";
  scene.bodies[2].supports[0] = prescribed("bottom", Axis::Y, 0.02);
  scene.bodies[2].supports[0].history = "raise";
  Path path;
  path.times = {1, 2, 3};
  path.histories = {{"pull", {0, 1, 2, 3}, {0, 0.5, 1, 2}}, {"raise", {0, 1, 2, 3}, {0, 0.5, 1, 1}}};
  scene.path = path;
  const std::vector<double> seat = {1.5, 0, 0}, pull = {3, 6, 12};
  std::size_t step = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& at) {
    CHECK(at.solution.contact.force.sum() == Approx(seat[step]).epsilon(1e-11).margin(1e-12));
    CHECK(-bond_forces(model, at.solution)[0].force.y() == Approx(pull[step] + seat[step]).epsilon(1e-11));
    ++step;
  });
  CHECK(end.status == SolveStatus::Solved);
  CHECK(step == 3);
}

// All nodes of the cut are drawn together alike, by two forces of 3: that is what the bolt bears, whatever pulls.
TEST_CASE("a bolt is drawn together by a force", "[one_sided][pretension]") {
  const double pull = GENERATE(0.0, 2.0);
  Relation alike = drawn_together;
  alike.right = 0;
  alike.terms.push_back(point({"bottom", "nut"}, {0, 10}, -1));
  alike.terms.push_back(point({"top", "shank"}, {0, 10}, 1));
  Scene scene = bolt(pull, alike);
  EdgeLoad load = scene.bodies[0].loads.edges[0];
  load.traction = [](const Vector2d&) { return Vector2d(0, 1.5); };
  scene.bodies[0].loads.edges = {load};
  load.boundary = "bottom";
  load.traction = [](const Vector2d&) { return Vector2d(0, -1.5); };
  scene.bodies[1].loads.edges.push_back(load);
  const SolvedScene run = solved(scene, "the bolt");
  CHECK(support_forces(run.model, run.solution, 0).col(1).sum() == Approx(-3).epsilon(1e-11));
  CHECK(run.solution.contact.force.sum() == Approx(3 - pull).epsilon(1e-11));
  const NodeArray& nut = run.solution.displacements[1];
  const Index at_cut = boundary_nodes(run.model.bodies[1].mesh, "bottom").front();
  const double apart = nut(at_cut, 1) - top_of(run, 0);
  CHECK(apart == Approx(-(3 / 100.0 + (3 - pull) / 300)).epsilon(1e-11));
}

// What supports hold on all terms can neither open nor close: it is left out with a note, and refused where it passes the number.
TEST_CASE("relations up to a number that cannot be meant are refused", "[one_sided][errors]") {
  const auto refused = [](Scene scene, const std::string& words) {
    const std::string message = problem_message([&] { static_cast<void>(plan(scene)); });
    CAPTURE(message);
    return message.find(words) != std::string::npos;
  };
  const Relation stop = {{term({"top", "bar"})}, 0.008, {}, Holds::AtMost};
  CHECK(refused(one_bar(5, {stop.terms, 0.008, 20.0, Holds::AtMost}), "stiffness = 20 is of a spring that pulls and presses"));
  Scene moving = one_bar(5, stop);
  moving.moves = true;
  CHECK(refused(moving, "relation 1: at_most and at_least are made for small displacements"));
  Scene held = one_bar(5, {{term({"bottom", "bar"})}, -0.1, {}, Holds::AtMost});
  CHECK(refused(held, "relation 1: the pair at (0, 0) is held by supports, ties, relations or rigid sides and is beyond its number by 0.1"));
  const Plan given = plan(one_bar(5, {{term({"bottom", "bar"})}, 0.1, {}, Holds::AtMost}));
  REQUIRE(given.notes.size() == 1);
  CHECK(given.notes[0].find("relation 1: 3 pairs can neither open nor close") != std::string::npos);
}

// The proof weighs one pair of each relation, those of the same node.
TEST_CASE("bounds that leave nothing between them are named", "[relations]") {
  Relation most;
  most.terms = {term({"top", "bar"})};
  most.holds = Holds::AtMost;
  most.right = 0.002;
  Relation least = most;
  least.holds = Holds::AtLeast;
  least.right = 0.003;
  Scene scene = one_bar(5, most);
  scene.bodies[0].mesh = block("bar", {0, 0}, {2, 4}, 40, 3);
  bind(scene, {most, least});
  const Solution solution = solve(scene);
  CHECK(solution.contact.report.status == SolveStatus::Infeasible);
  const std::string why = why_unsolved(solution);
  CHECK(why.find("relation 1") != std::string::npos);
  CHECK(why.find("relation 2") != std::string::npos);
  CHECK(why.find("no displacement opens these pairs together") != std::string::npos);
  CHECK(why.find("more") == std::string::npos);
}
