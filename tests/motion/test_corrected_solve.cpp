// Contact forces that turn as bodies go: against a turn of everything, and by what iterations it saves.
#include <cmath>
#include <memory>
#include <optional>

#include "addons/equations/bonds.hpp"
#include "addons/equations/take_equations.hpp"
#include "addons/motion/linearised_model.hpp"
#include "addons/motion/moved_pairs.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/scene/bodies.hpp"
#include "support/moving_blocks.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

struct Effort {
  double mean = 0;  ///< iterations of a step
  long long most = 0;
};

/// Of a soft block that is pressed on a base by a twentieth of its height and dragged over three cells.
Effort effort(double friction, const char* law) {
  MovingBlocks of;
  of.friction = friction;
  of.stiffness = 3000;
  of.press = 0.05;
  of.drag = 0.75;
  of.steps = 9;
  Scene scene = moving_blocks(of);
  for (Body& body : scene.bodies) {
    body.element = "q4";
    body.material.law = find_strain_law(law);
  }
  Effort all;
  int steps = 0;
  const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
    const long long iterations = step.solution.ledger.counted("pairs", "searches") - 1;
    all.mean += static_cast<double>(iterations);
    all.most = std::max(all.most, iterations);
    ++steps;
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  all.mean /= steps;
  return all;
}

/// \param scene  must outlive it
PlacePairs placing(const Scene& scene) {
  return [&scene](const Displaced& there, const Displaced& before, Model& model) {
    place_bodies(scene, there, before, model);
    if (model.equations) take_equations_of_rows(there, model);
  };
}

/// The way of all unknowns if everything turns about the origin by 1, to first order.
VectorXd turn_of_all(const Model& model) {
  NodeArray turn = NodeArray::Zero(count_nodes(model.bodies), 2);
  for (const BodyModel& body : model.bodies)
    for (Index k = 0; k < body.mesh.n_nodes(); ++k)
      turn.row(body.first_node + k) << -body.mesh.nodes(k, 1), body.mesh.nodes(k, 0);
  return restricted(model.unknowns, turn);
}

}  // namespace

// Nothing changes but directions: forces turn with the bodies. The difference looks 1e-8 ahead, where rounding of normals is 1e-8 of
// it; a base of eight cells has normals that are right to a few roundings more.
TEST_CASE("if everything turns, contact and friction forces turn with it", "[motion]") {
  MovingBlocks of;
  of.base_cells = 8;
  of.friction = GENERATE(0.3, 0.0);  // without it, rows of pairs have no entries along the base
  const Scene scene = moving_blocks(of);
  Ledger ledger;
  Model model = build(scene, ledger);
  const PlacePairs place = placing(scene);
  const NodeArray zero = NodeArray::Zero(count_nodes(model.bodies), 2);
  const Displaced rest{zero, zero};
  const LinearisedModel linear(place, rest, model);
  place(rest, rest, model);
  const Index rows = model.programme.A.rows();
  const VectorXd force = VectorXd::LinSpaced(rows, 1, 2).array().sin();
  const VectorXd way = turn_of_all(model);
  VectorXd expected = VectorXd::Zero(way.size());
  const VectorXd push = -model.programme.A.transpose() * force;
  for (const BodyModel& body : model.bodies)
    for (Index k = 0; k < body.mesh.n_nodes(); ++k) {
      const Index x = model.unknowns.number(body.first_node + k, 0);
      const Index y = model.unknowns.number(body.first_node + k, 1);
      if (x < 0 || y < 0) continue;
      expected(x) = -push(y);
      expected(y) = push(x);
    }
  const TurnedForces turned = linear.turned(1e-8);
  const VectorXd load = turned.along(way(turned.unknowns), force);
  CHECK((load - expected(turned.unknowns)).cwiseAbs().maxCoeff() <= 1e-6 * largest(push));
  CHECK(largest(push) == largest(push(turned.unknowns)));
  CHECK(largest(expected) == largest(expected(turned.unknowns)));
  CHECK(largest(turned.along(VectorXd::Ones(load.size()), force)) <= 1e-6 * largest(push));
}

// The nodes of a rigid side follow three unknowns. These alone have entries in rows, but the nodes move.
TEST_CASE("forces turn with nodes that equations hold", "[motion]") {
  MovingBlocks of;
  of.base_cells = 8;
  of.friction = GENERATE(0.3, 0.0);
  Scene scene = moving_blocks(of);
  Bonds bonds;
  bonds.rigid = {RigidSide{{"bottom", "block"}, {1.5, 1}}};
  scene.bonds = std::make_shared<Bonds>(bonds);
  Ledger ledger;
  Model model = build(scene, ledger);
  const PlacePairs place = placing(scene);
  const NodeArray zero = NodeArray::Zero(count_nodes(model.bodies), 2);
  const Displaced rest{zero, zero};
  const LinearisedModel linear(place, rest, model);
  place(rest, rest, model);
  const VectorXd way = turn_of_all(model);
  const VectorXd force = VectorXd::LinSpaced(model.programme.A.rows(), 1, 2).array().sin();
  const TurnedForces turned = linear.turned(1e-8);
  const double share = 1e-8 / largest(way);
  Model there = model;
  place(linear.ahead({way, {}, {}}, share), rest, there);
  VectorXd left = (model.programme.A - there.programme.A).transpose() * force / share;
  CHECK(largest(left) >= 1);
  left(turned.unknowns) -= turned.along(way(turned.unknowns), force);
  CHECK(largest(left) <= 1e-6);
}

// Off the solution by e, an iteration of Newton's method is off by e^2. Rows are the gradients of weighted gaps to some 1e-4 only, since
// weights are those of the place. With contact forces frozen an iteration leaves a fortieth of e.
TEST_CASE("an iteration leaves the square of what was left, as far as rows are gradients", "[motion]") {
  MovingBlocks of;
  of.friction = 0;
  of.press = 0.03;
  of.drag = 0.3;
  of.steps = 1;
  const Scene scene = moving_blocks(of);
  const PlacePairs place = placing(scene);
  std::optional<Model> placed;
  std::optional<Displaced> solved;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    placed = model;
    solved = displaced(model.unknowns, step.solution.refined);
  });
  REQUIRE(end.status == SolveStatus::Solved);
  Random random(7);
  NodeArray off = NodeArray::Zero(solved->high.rows(), 2);
  for (Index k = 0; k < off.rows(); ++k)
    for (const Index axis : {0, 1})
      if (placed->unknowns.number(k, axis) >= 0) off(k, axis) = random.uniform(-1, 1);
  for (const double e : {1e-3, 1e-4, 1e-5, 1e-6}) {
    CAPTURE(e);
    Model model = *placed;
    Ledger ledger;
    LinearisedModel linear(place, *solved, model);
    linear.move(Displaced{solved->high + e * off, solved->low}, ledger);
    Condensed condensed = condense(model, ledger);
    const Corrected corrected =
        corrected_solve(model, linear.turned(1e-8), {}, condensed, std::move(ledger));
    CHECK(corrected.closer);
    const Displaced there = linear.ahead(corrected.solution.refined, 1);
    CHECK((there.high - solved->high).cwiseAbs().maxCoeff() <= 10 * e * e + 1e-3 * e);
  }
}

// Without corrections friction of one half makes nine iterations of five.
TEST_CASE("friction that turns with the surface hardly costs iterations", "[motion]") {
  for (const char* law : {"neo_hooke", "st_venant_kirchhoff"}) {
    CAPTURE(law);
    const Effort smooth = effort(0, law);
    const Effort rough = effort(0.5, law);
    CHECK(rough.mean <= smooth.mean + 1);
    CHECK(rough.most <= 6);
  }
}
