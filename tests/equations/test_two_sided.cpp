// Contacts with friction whose pairs never lift off.
#include <cmath>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/readings.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

namespace {

EdgeLoad pulled(const std::string& boundary, const Vector2d& traction) {
  EdgeLoad load;
  load.boundary = boundary;
  load.traction = [traction](const Vector2d&) { return traction; };
  return load;
}

/// A block 4 x 2 on a rigid floor that it cannot leave, with the friction mu. \param held  or by its right side along x
Scene on_rail(double mu, bool held) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {4, 2}, 8, 4);
  body.material = {1000, 0.3, PlaneState::Strain};
  if (held) body.supports = {prescribed("right", Axis::X, 0)};
  ContactSpec rail;
  rail.source = {"bottom", "block"};
  rail.target = half_plane({0, 0}, {0, 1});
  rail.friction = Friction{mu, 0};
  scene.contacts = {rail};
  scene.bonds = std::make_shared<const Bonds>(Bonds{{}, {0}});
  return scene;
}

SolvedScene rail_solved(double mu, const Vector2d& traction, bool held) {
  Scene scene = on_rail(mu, held);
  scene.bodies[0].loads.edges = {pulled("top", traction)};
  return solved(scene, "the block");
}

}  // namespace

// Pulled up instead of pressed down, all is the same with the signs of the displacements turned round: the rail grips from
// the other side.
TEST_CASE("a rail rubs in tension as in compression", "[two-sided]") {
  const double mu = GENERATE(0.05, 0.3, 2.0);
  CAPTURE(mu);
  const SolvedScene down = rail_solved(mu, {1, -3}, true);
  const SolvedScene up = rail_solved(mu, {-1, 3}, true);
  const double size = down.solution.contact.force.cwiseAbs().maxCoeff();
  CHECK(down.solution.contact.force.minCoeff() > 0);
  CHECK((up.solution.contact.force + down.solution.contact.force).cwiseAbs().maxCoeff() <=
        1e-10 * size);
  CHECK((up.solution.contact.friction + down.solution.contact.friction).cwiseAbs().maxCoeff() <=
        1e-10 * size);
  CHECK(up.solution.certificate.holds());
  CHECK(resultants(up.model, up.solution).force.y() == Approx(-12).epsilon(1e-11));
  CHECK(up.solution.pressure.maxCoeff() < 0);
}

// Turned over by a couple: one end in tension, the other in compression, nothing lifts off, and friction is within mu |lambda|.
TEST_CASE("a rail holds a block that would tip over", "[two-sided]") {
  const double mu = GENERATE(0.1, 0.5);
  CAPTURE(mu);
  Scene scene = on_rail(mu, true);
  EdgeLoad couple;
  couple.boundary = "top";
  couple.traction = [](const Vector2d& x) { return Vector2d(0, 4 * (x.x() - 2)); };
  scene.bodies[0].loads.edges = {couple};
  const SolvedScene run = solved(scene, "the block");
  const ContactState& contact = run.solution.contact;
  CHECK(contact.force.minCoeff() < 0);
  CHECK(contact.force.maxCoeff() > 0);
  CHECK(contact.gap.cwiseAbs().maxCoeff() <=
        1e-12 * run.solution.displacements[0].cwiseAbs().maxCoeff());
  bool slides = false;
  for (Index k = 0; k < contact.friction.size(); ++k) {
    const double bound = mu * std::abs(contact.force(contact.frictional_pairs[std::size_t(k)]));
    CHECK(std::abs(contact.friction(k)) <= bound * (1 + 1e-10) + 1e-12);
    if (friction_sign(status_of_slip(contact, k)) == 0) continue;
    slides = true;
    CHECK(std::abs(contact.friction(k)) == Approx(bound).epsilon(1e-9).margin(1e-12));
    CHECK(contact.friction(k) * contact.slip(k) <= 0);
    CHECK((status_of_slip(contact, k) == ContactStatus::SlipForward) ==
          (contact.slip(k) > 0));
  }
  CHECK(slides);
}

// Nothing but the rail holds the block: 12 pull it up, so that friction holds .3 * 12 = 3.6, and 3.5 drag it.
TEST_CASE("a block that only a rail holds is held in tension, too", "[two-sided]") {
  const SolvedScene run = rail_solved(0.3, {0.875, 3}, false);
  const Resultants sum = resultants(run.model, run.solution);
  CHECK(sum.force.x() == Approx(-3.5).epsilon(1e-10));
  CHECK(sum.force.y() == Approx(-12).epsilon(1e-10));
  CHECK(run.solution.contact.gap.cwiseAbs().maxCoeff() <= 1e-15);
}

// Without friction a rail is a tie that slides, which leaves no rows.
TEST_CASE("a rail with hardly any friction is a tie that slides", "[two-sided]") {
  const SolvedScene rubs = rail_solved(1e-9, {1, 3}, true);
  Scene smooth = on_rail(0, true);
  smooth.bodies[0].loads.edges = {pulled("top", {1, 3})};
  Tie tie;
  tie.sides.source = smooth.contacts[0].source;
  tie.sides.target = smooth.contacts[0].target;
  tie.slides = true;
  smooth.contacts.clear();
  smooth.bonds = std::make_shared<const Bonds>(Bonds{{tie}, {}});
  const SolvedScene slides = solved(smooth, "the smooth one");
  const NodeArray& u = slides.solution.displacements[0];
  CHECK((rubs.solution.displacements[0] - u).cwiseAbs().maxCoeff() <=
        1e-7 * u.cwiseAbs().maxCoeff());
}

// Dragged to and fro under a pull: the loop of the force over the way is that of the block that is pressed.
TEST_CASE("load steps of a rail remember slips in tension", "[two-sided][steps]") {
  const auto forces = [](double vertical) {
    Scene scene = on_rail(0.3, false);
    scene.bodies[0].supports = {prescribed("top", Axis::X, vertical < 0 ? 0.02 : -0.02)};
    scene.bodies[0].supports[0].history = "drag";
    scene.bodies[0].loads.edges = {pulled("top", {0, vertical})};
    scene.path = Path{{1, 2, 3, 4}, {{"drag", {0, 1, 3, 4}, {0, 1, -1, 0}}}};
    std::vector<double> all;
    static_cast<void>(solve_steps(scene, [&](const Model& model, const Step& step) {
      all.push_back(resultants(model, step.solution).force.x());
      all.push_back(step.state.dissipation.sum());
    }));
    return all;
  };
  const std::vector<double> pressed = forces(-3);
  const std::vector<double> pulled_up = forces(3);
  REQUIRE(pressed.size() == 8);
  REQUIRE(pulled_up.size() == 8);
  for (std::size_t k = 0; k < 8; ++k)
    CHECK(pulled_up[k] == Approx(k % 2 == 0 ? -pressed[k] : pressed[k]).epsilon(1e-9).margin(1e-11));
  CHECK(pressed.back() > 0);
}

// Of two blocks on a bed nothing presses: they follow its bulge without forces, and the upper one may slide for ever. Pairs that
// never lift off stay closed all the same, beside the strain of the bodies and not beside how far one slides.
TEST_CASE("sliding ties that carry nothing stay closed", "[two-sided]") {
  Scene scene;
  scene.bodies.resize(3);
  const std::vector<std::string> names = {"bed", "middle", "upper"};
  for (std::size_t b = 0; b < 3; ++b) {
    const int cells = std::vector<int>{4, 2, 3}[b];
    scene.bodies[b].mesh = block(names[b], {0, static_cast<double>(b)}, {4, 1}, cells, 2);
    scene.bodies[b].material = {1000, 0, PlaneState::Stress};
  }
  scene.bodies[0].supports = {fixed("bottom")};
  scene.bodies[0].loads.edges = {pulled("right", {1, 0})};
  for (std::size_t b = 1; b < 3; ++b) {
    ContactSpec tie;
    tie.source = {"bottom", names[b]};
    tie.target = Side{"top", names[b - 1]};
    tie.friction = Friction{0.3, 0};
    scene.contacts.push_back(tie);
  }
  scene.bonds = std::make_shared<const Bonds>(Bonds{{}, {0, 1}});
  const SolvedScene run = solved(scene, "three blocks");
  const double moves = run.solution.displacements[0].cwiseAbs().maxCoeff();
  CHECK(run.solution.certificate.holds());
  CHECK(run.solution.contact.gap.cwiseAbs().maxCoeff() <= 1e-10 * moves);
  for (const NodeArray& u : run.solution.displacements) CHECK(u.cwiseAbs().maxCoeff() <= 2 * moves);
}
