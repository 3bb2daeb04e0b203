// Bodies of revolution in contact: patch tests, press fits, friction, far from the axis, other units.
#include <cmath>

#include "addons/estimate/goal.hpp"
#include "catch_compat.hpp"
#include "closed_form/rings.hpp"
#include "signorini/contact/gap_operators.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

namespace {

Body block(const char* name, const Vector2d& corner, const Vector2d& size, Index cells_x,
           Index cells_y, const std::string& element, const Material& material) {
  BlockSpec spec;
  spec.name = name;
  spec.size = size;
  spec.cells_x = cells_x;
  spec.cells_y = cells_y;
  spec.order = element == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear;
  Body body;
  body.mesh = moved(make_block(spec), corner);
  body.element = element;
  body.material = material;
  return body;
}

const Material rubber{10, 0.3, PlaneState::Axial, 1};

double largest_deviation(const Eigen::VectorXd& values, double exact) {
  return (values.array() / exact - 1).abs().maxCoeff();
}

/// Forces of contact and supports on all bodies along the axis.
double sum_along_axis(const SolvedScene& run) {
  double sum = 0;
  for (std::size_t body = 0; body < run.model.bodies.size(); ++body)
    sum += support_forces(run.model, run.solution, body).col(1).sum();
  return sum;
}

}  // namespace

TEST_CASE("two discs under pressure: the contact patch test of bodies of revolution",
          "[axial][patch]") {
  for (const char* const element : {"q4", "q4_incompatible", "q8"})
    for (const double bore : {0.0, 0.5})
      for (const char* const name : {"mortar", "gauss_points", "node_to_segment"})
        for (const Index source_cells : {5, 8}) {
          CAPTURE(element, bore, name, source_cells);
          const bool passes = find_gap_operator(name).passes_patch_test;
          const Index target_cells = passes ? 7 : source_cells;
          Scene scene;
          scene.bodies = {block("lower", {bore, 0}, {2, 1}, target_cells, 3, element, rubber),
                          block("upper", {bore, 1}, {2, 1}, source_cells, 2, element, rubber)};
          scene.bodies[0].supports = {symmetric("bottom")};
          for (Body& body : scene.bodies) {
            body.loads.edges = {{"right", 0.7, {}}};
            if (bore > 0) body.loads.edges.push_back({"left", 0.7, {}});
          }
          scene.bodies[1].loads.edges.push_back({"top", 0.7, {}});
          scene.contacts = {{{"bottom", "upper"}, Side{"top", "lower"}, name}};
          const SolvedScene run = solved(scene, "the discs");
          if (std::string(name) !=
              "gauss_points")  // which has more forces than the nodes of an edge
            CHECK(largest_deviation(run.solution.pressure, 0.7) <= 1e-11);
          const double area = pi * ((bore + 2) * (bore + 2) - bore * bore);
          CHECK(run.model.pairs.weight.sum() == Approx(area).epsilon(1e-13));
          CHECK(run.solution.contact.force.sum() == Approx(0.7 * area).epsilon(1e-12));
          CHECK(sum_along_axis(run) == Approx(0.7 * area).epsilon(1e-12));
          CHECK(run.model.modes.size() == 1);
        }
}

TEST_CASE("a cone under pressure on all sides presses evenly on its conical seat",
          "[axial][patch]") {
  for (const char* const element : {"q4", "q4_incompatible", "q8"}) {
    CAPTURE(element);
    Scene scene;
    Body& body = scene.bodies[0] = block("cone", {0, 1}, {1, 1}, 4, 5, element, rubber);
    body.mesh = mapped(body.mesh, [](const Vector2d& x) {  // the apex would be the origin
      return Vector2d(0.75 * x.x() * x.y(), x.y());
    });
    body.loads.edges = {{"top", 3, {}}, {"bottom", 3, {}}};
    scene.contacts = {{{"right"}, half_plane({0, 0}, {-0.8, 0.6})}};
    const SolvedScene run = solved(scene, "the cone");
    CHECK(largest_deviation(run.solution.pressure, 3) <= 1e-11);
    CHECK(run.model.pairs.weight.sum() == Approx(pi * 0.75 * 1.25 * (4 - 1)).epsilon(1e-13));
  }
}

TEST_CASE("the pressure of a press fit is that of Lame to 0.1 %", "[axial][closed-form]") {
  for (const char* const name : {"mortar", "node_to_segment"})
    for (const char* const element : {"q4_incompatible", "q8"}) {
      CAPTURE(name, element);
      const bool quadratic = std::string(element) == "q8";
      const double overlap = 1e-4;
      const Index n = quadratic ? 4 : 12;
      const Index rows = find_gap_operator(name).passes_patch_test ? n + 1 : n;
      const Material inner{200e3, 0.3, PlaneState::Axial, 1};
      const Material outer{70e3, 0.33, PlaneState::Axial, 1};
      Scene scene;
      scene.bodies = {
          block("shaft", {1, 0}, {1 + overlap / 2, 1}, n, n, element, inner),
          block("hub", {2 - overlap / 2, 0}, {2 + overlap / 2, 1}, 2 * n, rows, element, outer)};
      for (Body& body : scene.bodies) body.supports = {symmetric("bottom"), symmetric("top")};
      scene.contacts = {{{"right", "shaft"}, Side{"left", "hub"}, name}};
      const SolvedScene run = solved(scene, "the press fit");
      const auto ring = [](double a, double b, const Material& m) {
        const double nu = m.poisson_ratio;
        return Ring{a, b, m.youngs_modulus / (1 - nu * nu), nu / (1 - nu)};
      };
      const NestedPressure exact =
          nested_pressure({ring(1, 2 + overlap / 2, inner), ring(2 - overlap / 2, 4, outer), 0, 0,
                           Meeting::EqualForce});
      CHECK(largest_deviation(run.solution.pressure, exact.inner.outside) < 1e-3);
      CHECK(sum_along_axis(run) == Approx(0).margin(1e-10 * run.solution.contact.force.sum()));
      const StressArray stress = nodal_stress(scene.bodies[1].mesh, run.model.bodies[1].element,
                                              outer, run.solution.displacements[1]);
      const RingStress at_bore =
          ring_stress(ring(2 - overlap / 2, 4, outer), {exact.outer.inside, 0}, 2);
      for (const Index node : boundary_nodes(scene.bodies[1].mesh, "left"))
        CHECK(stress(node, 3) == Approx(at_bore.hoop).epsilon(quadratic ? 0.005 : 0.02));
    }
}

TEST_CASE("what pushes a shaft out of its hub is friction times the normal force",
          "[axial][friction]") {
  // Without Poisson's ratio the push does not change the pressure.
  for (const double mu : {0.1, 0.3}) {
    Scene scene;
    const Material steel{200e3, 0, PlaneState::Axial, 1};
    scene.bodies = {block("shaft", {0, 0}, {1, 2}, 6, 12, "q4_incompatible", steel),
                    block("hub", {1 - 1e-3, 0}, {1, 2}, 6, 12, "q4_incompatible", steel)};
    scene.bodies[0].supports = {prescribed("bottom", Axis::Y, 0.05)};
    scene.bodies[1].supports = {symmetric("top")};
    scene.contacts = {{{"right", "shaft"}, Side{"left", "hub"}}};
    scene.contacts[0].friction = Friction{mu, 0};
    const SolvedScene run = solved(scene, "the push");
    const ContactState& contact = run.solution.contact;
    for (const ContactStatus contact_status : contact.contact_status)
      CHECK(friction_sign(contact_status) != 0);
    const double push = support_forces(run.model, run.solution, 0).col(1).sum();
    CAPTURE(mu);
    CHECK(push == Approx(mu * contact.force.sum()).epsilon(1e-11));
    CHECK(sum_along_axis(run) == Approx(0).margin(1e-10 * push));
    CHECK(contact.frictional_pairs.size() == 13);
    // All round the axis, what presses sideways and turns cancels.
    const Resultants sum = resultants(run.model, run.solution);
    CHECK(sum.force.x() == 0);
    CHECK(sum.force.y() == Approx(-push).epsilon(1e-11));
    CHECK(sum.moment == 0);
    CHECK(sum.target_moment == 0);
    CHECK(value(run.model, run.solution, {"push", ContactForce{}}) == Approx(push).epsilon(1e-11));
  }
}

TEST_CASE("a disc between rough plates slips outside of a circle that sticks",
          "[axial][friction]") {
  Scene scene;
  scene.bodies = {block("disc", {0, 0}, {1, 0.5}, 20, 10, "q4_incompatible", rubber)};
  scene.bodies[0].supports = {prescribed("top", Axis::Y, -0.01)};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  const auto bulge = [&scene](std::optional<Friction> friction) {
    scene.contacts[0].friction = friction;
    const SolvedScene run = solved(scene, "the disc");
    if (friction) {
      const ContactState& contact = run.solution.contact;
      bool slips = false;
      for (Index k = 0; k < contact.slip.size(); ++k) {
        const double x = run.model.pairs.position(contact.frictional_pairs[std::size_t(k)], 0);
        if (friction_sign(status_of_slip(contact, k)) == 0) {
          CHECK((!slips || x == 0));
        } else {
          slips = true;
        }
      }
      CHECK(slips == (friction->coefficient < 1));
    }
    const Index corner = boundary_nodes(scene.bodies[0].mesh, "bottom").back();
    return run.solution.displacements[0](corner, 0);
  };
  const double free = bulge({});
  CHECK(free == Approx(0.3 * 0.01 / 0.5).epsilon(1e-11));  // even barrels: no shear at all
  const double rough = bulge(Friction{0.05, 0});
  CHECK(rough > 0);
  CHECK(rough < 0.9 * free);
  CHECK(std::abs(bulge(Friction{1e4, 0})) < 1e-3 * free);
}

TEST_CASE("far from the axis bodies of revolution in contact are in plane strain", "[axial]") {
  for (const char* const element : {"q4_incompatible", "q4_bbar", "q8"})
    for (const bool rough : {false, true}) {
      CAPTURE(element, rough);
      const auto scene_at = [&](double radius, PlaneState state) {
        const Material material{10, 0.3, state, 1};
        Scene scene;
        scene.bodies = {block("lower", {radius, 0}, {3, 1}, 6, 2, element, material),
                        block("upper", {radius + 0.5, 1}, {1.5, 0.5}, 4, 2, element, material)};
        scene.bodies[0].supports = {fixed("bottom")};
        // Held at the top: a slender ring turns its cross-section over next to nothing.
        scene.bodies[1].supports = {prescribed("top", Axis::X, 0.004),
                                    prescribed("top", Axis::Y, -0.03)};
        scene.bodies[1].loads.edges = {{"left", 0.2, {}}};
        scene.contacts = {{{"bottom", "upper"}, Side{"top", "lower"}}};
        if (rough) scene.contacts[0].friction = Friction{0.2, 0};
        return scene;
      };
      const SolvedScene plane = solved(scene_at(0, PlaneState::Strain), "plane");
      const double radius = 0x1p22;
      const SolvedScene ring = solved(scene_at(radius, PlaneState::Axial), "ring");
      const auto difference = [](const auto& a, const auto& b) {
        return (a - b).norm() / b.norm();
      };
      CHECK(difference(ring.solution.pressure, plane.solution.pressure) < 1e-6);
      for (const std::size_t body : {0, 1}) {
        CHECK(difference(ring.solution.displacements[body], plane.solution.displacements[body]) <
              1e-6);
        const auto stress = [body](const SolvedScene& run) {
          const BodyModel& own = run.model.bodies[body];
          return nodal_stress(own.mesh, own.element, own.material,
                              run.solution.displacements[body]);
        };
        CHECK(difference(stress(ring), stress(plane)) < 1e-6);
      }
      CHECK(ring.solution.contact.contact_status == plane.solution.contact.contact_status);
    }
}

TEST_CASE("bodies of revolution in other units: the same numbers in those units", "[axial]") {
  const auto run_in = [](double length, double force) {
    const Material material{10 * force / (length * length), 0.4, PlaneState::Axial, 1};
    Scene scene;
    scene.bodies = {
        block("lower", {0, 0}, length * Vector2d(3, 1), 9, 3, "q4_incompatible", material),
        block("upper", {0, length}, length * Vector2d(1, 1), 5, 4, "q4_incompatible", material)};
    scene.bodies[0].supports = {fixed("bottom")};
    scene.bodies[1].loads.edges = {{"top", 0.1 * force / (length * length), {}}};
    scene.contacts = {{{"bottom", "upper"}, Side{"top", "lower"}}};
    scene.contacts[0].friction = Friction{0.2, 0};
    return solved(scene, "units");
  };
  const SolvedScene mm = run_in(1, 1);
  for (const double length : {1e-3, 39.37})
    for (const double force : {1e3, 0.2248}) {
      const SolvedScene other = run_in(length, force);
      CAPTURE(length, force);
      CHECK((other.solution.contact.force / force - mm.solution.contact.force).norm() <
            1e-11 * mm.solution.contact.force.norm());
      CHECK((other.solution.displacements[1] / length - mm.solution.displacements[1]).norm() <
            1e-11 * mm.solution.displacements[1].norm());
    }
}

TEST_CASE("what makes no body of revolution is said", "[axial]") {
  Scene scene;
  scene.bodies = {block("a", {0, 0}, {1, 1}, 2, 2, "q4", rubber),
                  block("b", {0, 1}, {1, 1}, 2, 2, "q4", rubber)};
  scene.bodies[0].supports = {fixed("bottom")};
  scene.contacts = {{{"bottom", "b"}, Side{"top", "a"}}};
  CHECK_NOTHROW(plan(scene));
  const auto complaint = [&scene](void (*spoil)(Scene&)) {
    Scene wrong = scene;
    spoil(wrong);
    return signorini_test::problem_message([&] { static_cast<void>(plan(wrong)); });
  };
  CHECK_THAT(complaint([](Scene& s) { s.bodies[1].material.state = PlaneState::Strain; }),
             ContainsSubstring("'b' is plane"));
  CHECK_THAT(complaint([](Scene& s) { s.bodies[0].material.thickness = 2; }),
             ContainsSubstring("no thickness") && ContainsSubstring("got 2"));
  CHECK_THAT(complaint([](Scene& s) {
               s.bodies[0].mesh = moved(s.bodies[0].mesh, {-0.5, 0});
             }),
             ContainsSubstring("mesh 'a': node 0 lies at (-0.5, 0)") &&
                 ContainsSubstring("x is the radius"));
  CHECK_THAT(
      complaint([](Scene& s) { s.bodies[0].supports.push_back(prescribed("left", Axis::X, 0.1)); }),
      ContainsSubstring("the axis"));
  CHECK_THAT(complaint([](Scene& s) { s.contacts[0].source.boundary = "left"; }),
             ContainsSubstring("lies on the axis"));
  CHECK_THAT(complaint([](Scene& s) { s.contacts.clear(); }),
             ContainsSubstring("can move freely in direction y"));
}

TEST_CASE("a node that rounding keeps off the axis is on it", "[axial]") {
  Scene scene;
  scene.bodies = {block("a", {0, 0}, {3, 1}, 3, 2, "q4", rubber)};
  scene.bodies[0].supports = {symmetric("bottom")};
  for (const Index node : boundary_nodes(scene.bodies[0].mesh, "left"))
    scene.bodies[0].mesh.nodes(node, 0) = node % 2 == 0 ? 2e-16 : -2e-16;
  const Plan planned = plan(scene);
  CHECK(axis_nodes(scene.bodies[0].mesh).size() == 3);
  for (const Index node : axis_nodes(scene.bodies[0].mesh))
    CHECK(planned.unknowns.number(node, 0) < 0);
}
