// Blocks on inclines: exact statics of whole blocks, whatever the mesh says inside.
#include <cmath>
#include <functional>

#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/readings.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;

namespace {

constexpr double length = 4;  // of the base
constexpr double height = 1;

/// A block that lies on y = 0 and is held by nothing else; `force` acts on all of it, evenly.
Scene block(const Vector2d& force, Friction law, const char* element = "q4") {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {length, height}, 8, 3,
                    element == std::string("q8") ? MeshOrder::Quadratic : MeshOrder::Linear);
  body.element = element;
  body.material = {1e4, 0.3, PlaneState::Strain, 1};
  body.loads.body_force = [force](const Vector2d&) { return Vector2d(force / (length * height)); };
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = law;
  return scene;
}

/// Weight 100 on a slope that rises to the right by `angle`, seen along the slope, and a push towards the hill.
Vector2d on_slope(double angle, double push = 0) {
  return {push * std::cos(angle) - 100 * std::sin(angle),
          -push * std::sin(angle) - 100 * std::cos(angle)};
}

bool holds(const Scene& scene) { return solve(scene).contact.report.status == SolveStatus::Solved; }

/// Where something that holds at `in` and not at `out` ceases to.
double limit(double in, double out, const std::function<Scene(double)>& scene) {
  REQUIRE(holds(scene(in)));
  REQUIRE_FALSE(holds(scene(out)));
  while (std::abs(out - in) > 2e-11 * std::abs(in)) {
    const double middle = 0.5 * (in + out);
    (holds(scene(middle)) ? in : out) = middle;
  }
  return 0.5 * (in + out);
}

}  // namespace

TEST_CASE("a block slides off when W sin t > c A + mu W cos t", "[friction][closed-form]") {
  for (const Friction& law : {Friction{0.3, 0}, Friction{0.3, 4}, Friction{0, 6}}) {
    CAPTURE(law.coefficient, law.cohesion);
    const double phi = std::atan(law.coefficient);
    const double exact = phi + std::asin(law.cohesion * length * std::cos(phi) / 100);
    const auto at = [&](double angle) { return block(on_slope(angle), law); };
    CHECK(limit(0.9 * exact, 1.1 * exact, at) == Approx(exact).epsilon(1e-10).margin(0));

    const Solution below = solve(at(0.8 * exact));
    const Vector2d force = on_slope(0.8 * exact);
    CHECK(below.contact.force.sum() == Approx(-force.y()).epsilon(1e-12));
    CHECK(below.contact.friction.sum() == Approx(-force.x()).epsilon(1e-12));
    Ledger ledger;
    const Model model = build(at(0.8 * exact), ledger);
    const double moment = below.contact.force.dot(model.pairs.position.col(0).matrix());
    const double offset = 0.5 * length - moment / below.contact.force.sum();
    CHECK(offset == Approx(0.5 * height * std::tan(0.8 * exact)).epsilon(1e-10));
  }
}

// NAFEMS CGS-4, and a block like that of ANSYS VM29, whose two limits were given as 74.50 and 5.77.
TEST_CASE("a push up a slope: the wedge and the support block",
          "[friction][closed-form][reference]") {
  const auto exact = [](double slope, double mu) { return 100 * (slope + mu) / (1 - mu * slope); };
  const auto pushed = [&](double angle, double mu) {
    return [=](double push) { return block(on_slope(angle, push), {mu, 0}); };
  };
  for (const double mu : {0.1, 0.2, 0.3}) {
    const double up = exact(0.1, mu);
    CHECK(limit(0.9 * up, 1.1 * up, pushed(std::atan(0.1), mu)) ==
          Approx(up).epsilon(1e-10).margin(0));
  }
  CHECK(exact(0.1, 0.3) == Approx(41.2371).epsilon(1e-6));
  const double angle = 20 * pi / 180;
  const double up = exact(std::tan(angle), 0.3);
  const double down = exact(std::tan(angle), -0.3);
  CHECK(up == Approx(74.50).epsilon(1e-3));
  CHECK(down == Approx(5.77).epsilon(1e-3));
  CHECK(limit(20, 90, pushed(angle, 0.3)) == Approx(up).epsilon(1e-10).margin(0));
  CHECK(limit(20, 2, pushed(angle, 0.3)) == Approx(down).epsilon(1e-10).margin(0));
}

TEST_CASE("a spring along the slope carries what friction and cohesion do not",
          "[friction][closed-form]") {
  const Friction law{0.2, 3};
  const Vector2d force = on_slope(0.6);
  Scene scene = block(force, law);
  scene.bodies[0].springs = {{"left", {10, 0}}};
  const SolvedScene run = solved(scene, "the block");
  const ContactState& contact = run.solution.contact;
  CHECK(contact.active().size() == static_cast<std::size_t>(contact.force.size()));
  for (const ContactStatus contact_status : contact.contact_status)
    CHECK(contact_status == ContactStatus::SlipBackward);
  const double resists = 3 * length - 0.2 * force.y();
  CHECK(contact.friction.sum() == Approx(resists).epsilon(1e-12));
  const NodeArray& u = run.solution.displacements[0];
  const Eigen::Map<const Eigen::VectorXd> moved(u.data(), u.size());
  CHECK((run.model.bodies[0].springs * moved).sum() == Approx(force.x() + resists).epsilon(1e-10));
}

// The sides carry what the rest of the slope would do to them; elements of second order contain the stress.
TEST_CASE("an infinite slope: an even base stress, and it slides all at once",
          "[friction][closed-form][patch]") {
  const double weight = 25;  // per volume
  const auto slope = [&](double angle, Friction law) {
    Scene scene = block(on_slope(angle), law, "q8");
    Body& body = scene.bodies[0];
    body.material.poisson_ratio = 0;
    for (const double side : {-1.0, 1.0}) {
      const auto shear = [=](const Vector2d& x) {
        return Vector2d(0, -side * weight * (height - x.y()) * std::sin(angle));
      };
      body.loads.edges.push_back({side < 0 ? "left" : "right", 0, shear});
    }
    return scene;
  };
  for (const Friction& law : {Friction{0.5, 0}, Friction{0.3, 5}}) {
    const double phi = std::atan(law.coefficient);
    const double exact = phi + std::asin(law.cohesion * std::cos(phi) / (weight * height));
    const SolvedScene run = solved(slope(0.9 * exact, law), "the slope");
    const Eigen::VectorXd& share = run.model.pairs.weight;
    for (Index k = 0; k < share.size(); ++k) {
      CHECK(run.solution.pressure(k) ==
            Approx(weight * height * std::cos(0.9 * exact)).epsilon(1e-10));
      CHECK(run.solution.contact.friction(k) / share(k) ==
            Approx(weight * height * std::sin(0.9 * exact)).epsilon(1e-10));
    }
    const auto at = [&](double angle) { return slope(angle, law); };
    CHECK(limit(0.9 * exact, 1.1 * exact, at) == Approx(exact).epsilon(1e-10).margin(0));
  }
}

TEST_CASE("a block that friction alone holds: pushed to and fro, and on until it slides off",
          "[friction][steps][floating]") {
  Scene scene = block({0, -100}, {0.3, 0});
  scene.bodies[0].loads.edges = {
      {"top", 0, [](const Vector2d&) { return Vector2d(30 / length, 0); }, "push"}};
  scene.path = Path{equal_steps(15, 5), {{"push", {0, 1, 3, 5}, {0, 0.9, -0.9, 0.9}}}};
  const History& push = scene.path->histories[0];
  WorkMeter meter;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    const ContactState& contact = step.solution.contact;
    CHECK(contact.force.sum() == Approx(100).epsilon(1e-12));
    CHECK(contact.friction.sum() ==
          Approx(-30 * push.at(step.state.time)).epsilon(1e-11).margin(1e-11));
    meter.add(model, step);
    const Work& work = meter.work();
    CHECK(std::abs(work.put_in() - work.strain - work.dissipation - work.between) <=
          1e-10 * work.strain);
  });
  CHECK(end.status == SolveStatus::Solved);
  CHECK(end.halvings == 0);
  CHECK(meter.work().dissipation > 0);

  scene.path = Path{{1, 2}, {{"push", {0, 2}, {0, 1.9}}}, 20};
  const PathEnd off = solve_steps(scene);
  CHECK(off.status != SolveStatus::Solved);
  const double slides = 2 / 1.9;
  REQUIRE(off.limit.has_value());
  CHECK(*off.limit == Approx(slides).epsilon(1e-12).margin(0));
  CHECK(off.state.time <= *off.limit);
  CHECK(off.state.time >= slides - 1e-9);
}
