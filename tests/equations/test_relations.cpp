// Linear relations between displacements, and springs in the place of equations: periodic cells, skew lines, levers, layers.
#include <cmath>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
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

Body body_of(Mesh mesh, double poisson_ratio = 0.3) {
  Body body;
  body.mesh = std::move(mesh);
  body.material = {1000, poisson_ratio, PlaneState::Stress};
  return body;
}

EdgeLoad pulled(const std::string& boundary, const Vector2d& traction) {
  EdgeLoad load;
  load.boundary = boundary;
  load.traction = [traction](const Vector2d&) { return traction; };
  return load;
}

RelationTerm term(const Side& side, const Vector2d& along, double times = 1) {
  return {side, {}, along, times};
}

void bind(Scene& scene, const Bonds& bonds) { scene.bonds = std::make_shared<const Bonds>(bonds); }

/// A block 4 x 2 that repeats itself along x, stretched by 1 in 1000 there. \param right  number of cells of its other side
Scene cell(MeshOrder order) {
  Scene scene;
  scene.bodies = {body_of(block("cell", {1, 3}, {4, 2}, 5, 3, order))};
  scene.bodies[0].supports = {prescribed_at("bottom", {1, 3}, Axis::X),
                              prescribed_at("bottom", {1, 3}, Axis::Y)};
  Bonds bonds;
  for (const Vector2d& along : {Vector2d(1, 0), Vector2d(0, 1)})
    bonds.relations.push_back({{term({"right", "cell"}, along), term({"left", "cell"}, along, -1)},
                               along.x() * 0.004});
  bind(scene, bonds);
  return scene;
}

}  // namespace

// sigma = E e along x, and nothing across: the sides of the cell keep their form, and nothing turns it.
TEST_CASE("a periodic cell is stretched by what its sides are moved apart", "[relations]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    const SolvedScene run = solved(cell(order), "the cell");
    const BodyModel& body = run.model.bodies[0];
    const NodeArray& u = run.solution.displacements[0];
    const StressArray stress = cell_stress(body.mesh, body.element, body.material, u);
    CHECK((stress.col(0).array() - 1).abs().maxCoeff() <= 1e-11);
    CHECK(stress.middleCols(1, 2).cwiseAbs().maxCoeff() <= 1e-11);
    const std::vector<BondForces> sums = bond_forces(run.model, run.solution);
    REQUIRE(sums.size() == 2);
    CHECK(sums[0].name == "relation 1");
    CHECK(sums[0].force.x() == Approx(2).epsilon(1e-11));  // on the right side, 2 high
    CHECK(support_forces(run.model, run.solution, 0).cwiseAbs().maxCoeff() <= 1e-11);
  }
}

// The same with the stretch in the displacement of one node, which all rows share.
TEST_CASE("a term of one node stands in every row", "[relations]") {
  Scene scene = cell(MeshOrder::Linear);
  Bonds bonds = *scene.bonds;
  bonds.relations[0].right = 0;
  RelationTerm corner = term({"bottom", "cell"}, {1, 0}, -1);
  corner.only_at = Vector2d(5, 3);
  bonds.relations[0].terms.push_back(corner);
  bind(scene, bonds);
  scene.bodies[0].supports.push_back(prescribed_at("bottom", {5, 3}, Axis::X, 0.004));
  const SolvedScene run = solved(scene, "the cell");
  const NodeArray& u = run.solution.displacements[0];
  const NodeArray& x = run.model.bodies[0].mesh.nodes;
  CHECK((u.col(0) - 1e-3 * (x.col(0).array() - 1).matrix()).cwiseAbs().maxCoeff() <= 1e-14);
  CHECK(run.model.notes.empty());  // of the corners, whose equation says 0 = 0
}

TEST_CASE("one term is a line of symmetry in any direction", "[relations]") {
  const double angle = GENERATE(0.5, -1.2);
  const Vector2d along(std::cos(angle), std::sin(angle));
  const Vector2d up(-along.y(), along.x());
  Scene scene;
  scene.bodies = {body_of(mapped(block("block", {0, 0}, {3, 2}, 4, 3), [&](const Vector2d& x) {
    return (x.x() * along + x.y() * up).eval();
  }))};
  scene.bodies[0].loads.edges = {pulled("top", 2 * up)};
  Bonds bonds;
  bonds.relations = {{{term({"bottom", "block"}, up)}, 0}, {{term({"left", "block"}, along)}, 0}};
  bind(scene, bonds);
  const SolvedScene run = solved(scene, "the block");
  const Mesh& mesh = run.model.bodies[0].mesh;
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const Vector2d x = mesh.nodes.row(node).transpose();
    const Vector2d u = run.solution.displacements[0].row(node).transpose();
    CHECK(u.dot(up) == Approx(0.002 * x.dot(up)).margin(1e-14));
    CHECK(u.dot(along) == Approx(-0.3 * 0.002 * x.dot(along)).margin(1e-14));
  }
}

// Bars of stiffness E b / h = 1000 and 2000, the second one twice as far from the pivot: u2 = -2 u1. The work of 10 on the
// first one says u1 (k1 + 4 k2) = 10.
TEST_CASE("a lever shares a force between two bars", "[relations]") {
  Scene scene;
  scene.bodies = {body_of(block("one", {0, 0}, {2, 2}, 3, 2), 0),
                  body_of(block("two", {5, 0}, {4, 2}, 3, 2), 0)};
  for (Body& body : scene.bodies) body.supports = {symmetric("bottom"), symmetric("left")};
  scene.bodies[0].loads.edges = {pulled("top", {0, 5})};
  Bonds bonds;
  bonds.relations = {{{term({"top", "two"}, {0, 1}), term({"top", "one"}, {0, 1}, 2)}, 0}};
  // The two tops have nodes 2/3 and 4/3 apart, which no shift takes to each other.
  bind(scene, bonds);
  CHECK(problem_message([&] { static_cast<void>(plan(scene)); }).find("a shift must take") !=
        std::string::npos);
  scene.bodies[1] = body_of(block("two", {5, 0}, {2, 1}, 3, 2), 0);
  scene.bodies[1].supports = {symmetric("bottom"), symmetric("left")};
  const SolvedScene run = solved(scene, "the lever");
  const double moved = 10.0 / (1000 + 4 * 2000);
  for (const Index node : boundary_nodes(run.model.bodies[0].mesh, "top"))
    CHECK(run.solution.displacements[0](node, 1) == Approx(moved).epsilon(1e-12));
  for (const Index node : boundary_nodes(run.model.bodies[1].mesh, "top"))
    CHECK(run.solution.displacements[1](node, 1) == Approx(-2 * moved).epsilon(1e-12));
  const BondForces sum = bond_forces(run.model, run.solution).front();  // on the second bar
  CHECK(sum.force.y() == Approx(-2000 * 2 * moved).epsilon(1e-11));
}

// A cylinder of radius 2 and height 2, nu = 0, made shorter by 0.002 and wider by 0.001: sigma_yy = -1 on the top. What pushes
// along the radius all round is in balance, as the forces of ties and contacts have it.
TEST_CASE("in axial symmetry a relation has a force along the axis alone", "[relations]") {
  Scene scene;
  scene.bodies = {body_of(block("cylinder", {0, 0}, {2, 2}, 3, 4), 0)};
  scene.bodies[0].material.state = PlaneState::Axial;
  scene.bodies[0].supports = {symmetric("bottom")};
  Bonds bonds;
  bonds.relations = {{{term({"top", "cylinder"}, {0, 1})}, -0.002},
                     {{term({"right", "cylinder"}, {1, 0})}, 0.001}};
  bind(scene, bonds);
  const SolvedScene run = solved(scene, "the cylinder");
  const std::vector<BondForces> sums = bond_forces(run.model, run.solution);
  REQUIRE(sums.size() == 2);
  CHECK(sums[0].force.y() == Approx(-std::acos(-1.0) * 4).epsilon(1e-10));
  CHECK(sums[1].force.y() == 0);
  for (const BondForces& sum : sums) {
    CHECK(sum.force.x() == 0);
    CHECK(sum.moment == 0);
  }
  CHECK(run.solution.bond_forces[0].col(0).sum() > 1);  // which there are, all the same
}

// Two bars of E = 1000 and length 2, and between them a layer of 400 per area, pulled by 3.
TEST_CASE("an elastic tie is a layer between bodies whose meshes do not match", "[relations]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    Scene scene;
    scene.bodies = {body_of(block("lower", {0, 0}, {6, 2}, 5, 2, order), 0),
                    body_of(block("upper", {0, 2.5}, {6, 2}, 3, 2, order), 0)};
    scene.bodies[0].supports = {fixed("bottom")};
    scene.bodies[1].loads.edges = {pulled("top", {0, 3})};
    Bonds bonds;
    Tie layer;
    layer.sides.source = {"bottom", "upper"};
    layer.sides.target = Side{"top", "lower"};
    layer.stiffness = Vector2d(400, 50);
    bonds.ties = {layer};
    bind(scene, bonds);
    const SolvedScene run = solved(scene, "the bars");
    const double top = 3 * (2.0 / 1000 + 1.0 / 400 + 2.0 / 1000);
    for (const Index node : boundary_nodes(run.model.bodies[1].mesh, "top"))
      CHECK(run.solution.displacements[1](node, 1) == Approx(top).epsilon(1e-10));
    const BondForces sum = bond_forces(run.model, run.solution).front();
    CHECK(sum.force.y() == Approx(-18).epsilon(1e-10));
    CHECK(sum.least_pressure == Approx(-3).epsilon(1e-9));
    CHECK(support_forces(run.model, run.solution, 1).cwiseAbs().maxCoeff() <= 1e-10);
  }
}

TEST_CASE("a spring between two points pulls both", "[relations]") {
  Scene scene;
  scene.bodies = {body_of(block("one", {0, 0}, {2, 2}, 2, 2)),
                  body_of(block("two", {3, 0}, {2, 2}, 2, 2))};
  scene.bodies[0].supports = {fixed("left")};
  scene.bodies[1].supports = {symmetric("bottom")};
  scene.bodies[1].loads.edges = {pulled("right", {0.5, 0})};
  RelationTerm a = term({"right", "one"}, {1, 0}, -1);
  a.only_at = Vector2d(2, 1);
  RelationTerm b = term({"left", "two"}, {1, 0});
  b.only_at = Vector2d(3, 1);
  Bonds bonds;
  bonds.relations = {{{b, a}, 0, 20.0}};
  bind(scene, bonds);
  const SolvedScene run = solved(scene, "the two");
  const auto at = [&](std::size_t body, const Vector2d& x) {
    const NodeArray& nodes = run.model.bodies[body].mesh.nodes;
    Index nearest = 0;
    (nodes.rowwise() - x.transpose()).rowwise().norm().minCoeff(&nearest);
    return run.solution.displacements[body](nearest, 0);
  };
  CHECK(20 * (at(1, {3, 1}) - at(0, {2, 1})) == Approx(1).epsilon(1e-11));
  CHECK(bond_forces(run.model, run.solution)[0].force.x() == Approx(-1).epsilon(1e-10));
  CHECK(support_forces(run.model, run.solution, 0).col(0).sum() == Approx(-1).epsilon(1e-10));
}

TEST_CASE("relations that cannot be meant are refused", "[relations][errors]") {
  const auto refused = [](const Relation& relation) {
    Scene scene = cell(MeshOrder::Linear);
    scene.bodies[0].supports.push_back(fixed("right"));
    Bonds bonds;
    bonds.relations = {relation};
    bind(scene, bonds);
    return problem_message([&] { static_cast<void>(plan(scene)); });
  };
  const auto has = [](const std::string& message, const std::string& words) {
    CAPTURE(message);
    return message.find(words) != std::string::npos;
  };
  CHECK(has(refused({{term({"right", "cell"}, {1, 0})}, 0.1}), "4 equations contradict others or supports"));
  CHECK(has(refused({{}, 0}), "one term or more"));
  CHECK(has(refused({{term({"right", "cell"}, {0, 0})}, 0}), "must have a direction"));
  CHECK(has(refused({{term({"right", "cell"}, {1, 0}), term({"top", "cell"}, {1, 0})}, 0}), "a [[tie]] takes any mesh"));
  CHECK(has(refused({{term({"right", "cell"}, {1, 0})}, 0, -1.0}), "a stiffness must be a number > 0"));
  CHECK(refused({{term({"right", "cell"}, {1, 0})}, 0}).empty());
}
