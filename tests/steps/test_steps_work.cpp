// Friction along a path: a slider by hand, and where the work goes.
#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "support/message.hpp"
#include "support/paths.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

TEST_CASE("a spring slider goes round its loop: force, slip and dissipation by hand",
          "[steps][friction][closed-form]") {
  const double bound = slider_friction * 1;
  const History pull{"pull", {0, 1, 3, 5}, {0, 2 * bound, -2 * bound, 2 * bound}};
  const Scene scene = slider(pull, equal_steps(40, 5));
  Ledger ledger;
  const Model model = build(scene, ledger);
  const double k = model.programme.stiffness.coeff(1, 1);  // of the tip along y
  REQUIRE(model.programme.stiffness.coeff(0, 1) == Approx(0).margin(1e-14 * k));
  double place = 0;  // of the tip
  double lost = 0;
  double area = 0;  // of pull over place
  double last_place = 0;
  double last_pull = 0;
  WorkMeter meter;
  double lost_before_loop = 0;
  double area_before_loop = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& at, const Step& step) {
    const double force = pull.at(step.state.time);
    // The tip moves no further than friction lets it: |force - k place| <= bound.
    const double before = place;
    place = std::min(std::max(place, (force - bound) / k), (force + bound) / k);
    lost += bound * std::abs(place - before);
    CAPTURE(step.state.time);
    CHECK(step.solution.displacements[0](1, 1) == Approx(place).margin(1e-14));
    CHECK(step.state.dissipation(0) == Approx(lost).margin(1e-14));
    CHECK(std::abs(step.state.slip(0)) == Approx(std::abs(place)).margin(1e-14));
    CHECK(step.state.solution.force(0) == Approx(1).epsilon(1e-13));
    const double now = step.solution.displacements[0](1, 1);
    area += 0.5 * (force + last_pull) * (now - last_place);
    last_place = now;
    last_pull = force;
    meter.add(at, step);
    const Work& work = meter.work();
    CHECK(work.put_in() == Approx(work.strain + work.dissipation).epsilon(1e-12).margin(1e-15));
    CHECK(std::abs(work.between) <= 1e-15);  // every kink is at the end of a step
    if (step.state.time == 1) {
      lost_before_loop = step.state.dissipation(0);
      area_before_loop = area;
    }
  });
  REQUIRE(end.status == SolveStatus::Solved);
  CHECK(end.state.steps == 40);
  const double loop = end.state.dissipation(0) - lost_before_loop;
  CHECK(loop == Approx(4 * bound * bound / k).epsilon(1e-12));
  CHECK(area - area_before_loop == Approx(loop).epsilon(1e-10));
}

TEST_CASE("work put in = strain energy + dissipation + what steps do not resolve, at every step",
          "[steps][friction]") {
  double between[2];
  int k = 0;
  for (const int steps : {8, 32}) {
    Scene scene = slab(steps, {1, -1, 1});
    scene.contacts[0].interference = 1e-3;
    WorkMeter meter;
    double most = 0;
    double worst = 0;
    const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
      meter.add(model, step);
      const Work& work = meter.work();
      worst =
          std::max(worst, std::abs(work.put_in() - work.strain - work.dissipation - work.between));
      most = std::max(most, work.put_in());
    });
    REQUIRE(end.status == SolveStatus::Solved);
    CHECK(worst <= 1e-12 * most);
    CHECK(meter.work().dissipation > 0.5 * most);
    CHECK(meter.work().supports > 0.1 * most);
    between[k++] = std::abs(meter.work().between) / most;
  }
  CHECK(between[0] > 1e-6);
  CHECK(between[1] < 0.5 * between[0]);
}

TEST_CASE("the work of a path is not added up from its middle on", "[steps]") {
  const Scene scene = slab(2, {1});
  const std::vector<Step> all = steps_of(scene);
  WorkMeter meter;
  const auto restarted = [&] {
    static_cast<void>(solve_steps(
        scene, [&](const Model& model, const Step& step) { meter.add(model, step); },
        all[1].state));
  };
  CHECK_THAT(problem_message(restarted),
             ContainsSubstring("step 1") && ContainsSubstring("got step 3"));
}

// The node that the support drags has no unknown along the ground: its slip is given, its friction acts on the support.
// While it stands that friction could be anything up to the bound, so it is none.
TEST_CASE("a node that a support drags over the ground rubs at its bound, and not while it stands",
          "[steps][friction]") {
  const std::vector<Step> steps = steps_of(slab(7, {1, 1, -1}));
  for (std::size_t k = 7; k < steps.size(); ++k) {
    const ContactState& contact = steps[k].solution.contact;
    const Index last = contact.slip.size() - 1;
    const double given = k < 14 ? 0.01 / 7 : k < 21 ? 0 : -0.02 / 7;
    CAPTURE(k);
    CHECK(contact.slip(last) == Approx(given).epsilon(1e-12).margin(0));
    const double bound = 0.4 * contact.force(last);
    const double shear = given > 0 ? -bound : given < 0 ? bound : 0;
    CHECK(contact.friction(last) == Approx(shear).epsilon(1e-13).margin(0));
    if (given != 0) continue;
    const Eigen::VectorXd& before = steps[13].solution.contact.friction;
    CHECK((contact.friction - before).head(last).norm() <= 1e-12 * before.norm());
  }
}

// A sum of rounded increments would differ from the way of the support, and let the node slip while that stands.
TEST_CASE("the slip in total that a support gives is its displacement, to the bit",
          "[steps][friction]") {
  for (const Step& step : steps_of(slab(7, {1, 1, -0.3, 0.0007, 0.0007}))) {
    const Eigen::Index last = step.state.slip.size() - 1;
    const double moved = step.solution.displacements[0](16, 0);  // the corner that is dragged
    CAPTURE(step.state.time);
    CHECK(step.state.slip(last) == moved);
    const double time = step.state.time;
    if ((time > 2 && time <= 3) || time > 5) CHECK(step.state.increment(last) == 0);
  }
}

// Rows of no pairs are as long as those of any: what supports do is read off forces of all nodes.
TEST_CASE("a path without contacts puts the work of its supports into strains", "[steps]") {
  Scene scene = slab(2, {1, 1, -1});
  scene.contacts.clear();
  const std::string& boundary = scene.bodies[0].mesh.boundaries.begin()->first;
  scene.bodies[0].supports = {fixed(boundary)};
  Ledger ledger;
  const Model model = build(scene, ledger);
  CHECK(model.pairs.opening.rows() == 0);
  CHECK(model.pairs.opening.cols() == 2 * scene.bodies[0].mesh.n_nodes());
  WorkMeter meter;
  const PathEnd end =
      solve_steps(scene, [&](const Model& at, const Step& step) { meter.add(at, step); });
  CHECK(end.status == SolveStatus::Solved);
  const Work& work = meter.work();
  CHECK(work.supports == 0);
  CHECK(work.strain == Approx(work.put_in()).epsilon(1e-12));
}
