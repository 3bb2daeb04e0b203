// Resultants and pressures of contacts on sides that turn: they are those of the forces on the nodes.
#include <cmath>

#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "meshes/ring.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/balance.hpp"
#include "signorini/scene/readings.hpp"
#include "support/balance.hpp"
#include "support/two_bodies.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::unbalanced;

namespace {

const Material steel{1000, 0.3, PlaneState::Stress, 0.5};

Body disc_of(const DiscSpec& spec, const char* element) {
  Body body;
  body.mesh = make_disc(spec);
  body.element = element;
  body.material = steel;
  return body;
}

Support held_at(const char* boundary, const Vector2d& point, bool x, bool y) {
  Support support = fixed(boundary);
  support.holds_x = x;
  support.holds_y = y;
  support.only_at = point;
  return support;
}

}  // namespace

// Closed form: a disc in a hole that is too small shrinks evenly, whatever even polygon it is.
TEST_CASE("the pressure on a polygon in a round hole is that of even shrinking",
          "[resultants][closed-form]") {
  const double overlap = 0.01;
  const double pressure = steel.youngs_modulus * overlap / (1 - steel.poisson_ratio);
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible"}) {
    CAPTURE(element);
    DiscSpec spec;
    spec.core_cells = 1;
    spec.layers = 2;
    Scene scene;
    scene.bodies = {disc_of(spec, element)};
    scene.bodies[0].supports = {held_at("rim", {0, 1}, true, false)};
    scene.contacts = {{{"rim"}, hole({0, 0}, 1 - overlap)}};
    const SolvedScene run = solved(scene, "disc");
    for (const double p : run.solution.pressure) CHECK(p == Approx(pressure).epsilon(1e-10));
    const Resultants sum = resultants(run.model, run.solution);
    CHECK(sum.force.norm() <= 1e-10 * pressure);
    CHECK(std::abs(sum.moment) <= 1e-10 * pressure);
    CHECK(unbalanced(run.model, run.solution) <= 1e-10);
  }
}

// Statics: whatever presses, contact carries what lies on it; and so on both sides of it.
TEST_CASE("a disc on a disc presses with its weight, coarse as both may be",
          "[resultants][closed-form]") {
  for (const GapOperator& member : gap_operators())
    for (const double friction : {0.0, 0.3})
      for (const Index cells : {1, 2, 4}) {
        CAPTURE(member.name, friction, cells);
        Scene scene;
        scene.bodies.clear();
        for (const bool upper : {false, true}) {
          DiscSpec spec;
          spec.name = upper ? "upper" : "lower";
          spec.radius = upper ? 1 : 0.5;
          spec.centre = {0, upper ? 1 : -0.5};
          spec.core_cells = cells;
          spec.layers = 2;
          scene.bodies.push_back(disc_of(spec, "q4"));
        }
        Body& upper = scene.bodies[1];
        upper.loads.body_force = [](const Vector2d&) { return Vector2d(0, -1); };
        upper.supports = {held_at("rim", {0, 2}, true, false)};
        scene.bodies[0].supports = {held_at("rim", {0, -1}, true, true),
                                    held_at("rim", {0.5, -0.5}, true, false)};
        ContactSpec contact{{"rim", "lower"}, Side{"rim", "upper"}};
        contact.gap_operator = member.name;
        if (friction > 0) contact.friction = Friction{friction, 0};
        scene.contacts = {contact};
        const SolvedScene run = solved(scene, "discs");
        const NodeArray loads = nodal_loads(upper.mesh, find_element("q4"), {steel}, upper.loads);
        const Resultants sum = resultants(run.model, run.solution);
        CHECK(sum.force.y() == Approx(loads.col(1).sum()).epsilon(1e-10));
        CHECK(unbalanced(run.model, run.solution) <= 1e-10);
        CHECK(run.solution.certificate.holds());
      }
}

TEST_CASE("the certificate sees a resultant that is not that of the forces", "[resultants]") {
  DiscSpec spec;
  spec.core_cells = 1;
  Scene scene;
  scene.bodies = {disc_of(spec, "q4")};
  scene.bodies[0].supports = {held_at("rim", {0, 1}, true, false)};
  scene.contacts = {{{"rim"}, hole({0, 0}, 0.99)}};
  SolvedScene run = solved(scene, "disc");
  const Eigen::VectorXd& force = run.solution.refined.force;
  CHECK(imbalance(run.model, run.solution.contact, force) <= 1e-14);
  ContactState told = run.solution.contact;
  told.force(2) *= 1 + 1e-6;
  CHECK(imbalance(run.model, told, force) > 1e-8);
  run.model.pairs.normal.row(3) *= 0.99;
  CHECK(imbalance(run.model, run.solution.contact, force) > 1e-4);
}

TEST_CASE("the certificate sees a moment that is not that of the forces, on either body",
          "[resultants][closed-form]") {
  for (const double unit : {1e-3, 1.0, 1e3}) {
    Scene scene = signorini_test::two_blocks(
        signorini_test::named_block("lower", {0, 0}, {2 * unit, unit}, 4, 2),
        signorini_test::named_block("upper", {0, unit}, {2 * unit, 3 * unit}, 4, 6));
    scene.bodies[1].supports = {prescribed("top", Axis::Y, -0.01 * unit), symmetric("left")};
    const SolvedScene run = solved(scene, "blocks");
    const Eigen::VectorXd& force = run.solution.refined.force;
    CHECK(imbalance(run.model, run.solution.contact, force) <= 1e-14);
    const double arm = 1e-3 * unit;
    const double share = arm * force(2) / force.maxCoeff();
    Model model = run.model;
    model.pairs.target_moment(2, 0) += arm;  // on the lower body, by its farthest node
    CHECK(imbalance(model, run.solution.contact, force) ==
          Approx(share / std::hypot(unit, 0.5 * unit)).epsilon(1e-9));
    model = run.model;
    model.pairs.moment(2, 0) += arm;  // and on the upper
    CHECK(imbalance(model, run.solution.contact, force) ==
          Approx(share / std::hypot(unit, 1.5 * unit)).epsilon(1e-9));
  }
}
