// What chapter 15 says of friction that remembers, where its text quotes no digits for it.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "../chapters/ch15_friction_remembers/blocks.hpp"
#include "../chapters/ch15_friction_remembers/orders.hpp"
#include "../chapters/ch15_friction_remembers/wedge.hpp"
#include "catch_compat.hpp"

using namespace ch15;

TEST_CASE("a spring slider by hand and as a triangle; what forgets has no loop",
          "[steps][friction][closed-form]") {
  Tip tip;
  WorkMeter meter;
  Work first;
  const Scene scene = triangle(equal_steps(40, 5));
  remember(scene, [&](const Model& model, const Step& step) {
    const double time = step.state.time;
    CAPTURE(time);
    const double pull = drag(to_and_fro().at(time), tip);
    CHECK(-step.solution.contact.friction(0) == Approx(pull).margin(1e-12 * B));
    CHECK(step.state.slip(0) == Approx(tip.place).margin(1e-12 * U));
    CHECK(step.state.dissipation(0) == Approx(tip.lost).margin(1e-12 * B * U));
    meter.add(model, step);
    if (time == 1) first = meter.work();
  });
  const double exact = 4 * B * (U - B / k);
  CHECK(meter.work().supports - first.supports == Approx(exact).epsilon(1e-10));
  CHECK(meter.work().dissipation - first.dissipation == Approx(exact).epsilon(1e-10));
  WorkMeter coarse;  // steps that end beside the corners of the loop cut off k h^2 / 8 of each
  Work begun;
  remember(triangle(equal_steps(35, 5)), [&](const Model& model, const Step& step) {
    coarse.add(model, step);
    if (step.state.time == 1) begun = coarse.work();
  });
  const double cut = 2 * k * std::pow(1. / 7, 2) / 8;
  CHECK(coarse.work().supports - begun.supports == Approx(exact - cut).epsilon(1e-10));
  CHECK(coarse.work().dissipation - begun.dissipation == Approx(exact).epsilon(1e-10));
  CHECK(coarse.work().strain == Approx(begun.strain).epsilon(1e-12));
  forget(scene, [](const Model&, const Step& alone) {
    const double stuck = k * to_and_fro().at(alone.state.time);
    CHECK(-alone.solution.contact.friction(0) ==
          Approx(std::clamp(stuck, -B, B)).margin(1e-12 * B));
  });
}

TEST_CASE("one end in three orders: three answers with friction, one without",
          "[steps][friction]") {
  std::vector<double> push;
  std::vector<Eigen::VectorXd> smooth;
  for (const Order& order : orders()) {
    Scene scene = cylinder(equal_steps(8, 2), order.press, order.push);
    push.push_back(end_of(scene).push);
    scene.contacts[0].friction.reset();
    smooth.push_back(end_of(scene).force);
  }
  const Order aside = orders()[1];  // nothing turns, but slip in total ends where down first does
  double forgotten = 0;
  forget(by_hand(cylinder({2}, aside.press, aside.push)), [&](const Model&, const Step& step) {
    const ContactState& contact = step.solution.contact;
    forgotten = -contact.friction.sum() / (mu * contact.force.sum());
  });
  CHECK(forgotten == Approx(push[0]).epsilon(1e-6));
  CHECK(push[0] == Approx(0.609).epsilon(1e-3));
  CHECK(push[1] == Approx(0).margin(1e-12));
  CHECK(push[2] < 0.98 * push[0]);
  CHECK(push[2] > 0.9 * push[0]);
  for (const Eigen::VectorXd& force : smooth)
    CHECK((force - smooth[0]).norm() <= 1e-12 * smooth[0].norm());
}

TEST_CASE("one node with three answers: each has its certificate, and a step keeps what it did",
          "[steps][friction]") {
  const double mu_strong = 3;
  const Scene scene = wedge(mu_strong);
  Ledger ledger;
  Model model = build(scene, ledger);
  set_time(7.25, model);
  REQUIRE(scene.path->histories[1].at(7.25) == Approx(0.5));
  const std::vector<Answer> all = answers(mu_strong, 0.5);
  CHECK(all.size() == 3);
  for (const Answer& answer : all) {
    CAPTURE(to_string(answer.contact_status));
    const QuadraticProgramme& programme = model.programme;
    const Eigen::Vector2d force(answer.force, answer.friction);
    const Eigen::Vector2d u = Eigen::Matrix2d(programme.stiffness).inverse() *
                              (programme.load - programme.A.transpose() * force);
    CHECK(u(1) == Approx(1e-3 * answer.slip).margin(1e-15));
    CHECK(certify(programme, {u, {}, force}, model.law).holds());
  }
  CHECK(plan(scene).notes.size() == 1);  // triangles of 3 nodes bend badly: the boundary is right
  PathState past;
  remember(scene, [&](const Model&, const Step& step) {
    if (step.state.time == 6) past = step.state;
    const double time = step.state.time, push = scene.path->histories[1].at(time);
    CAPTURE(time, push);
    const ContactStatus contact_status = step.state.contact_status[0];
    const std::string& note = step.solution.notes.back();
    if (contact_status == ContactStatus::Stick && answers(mu_strong, push).size() > 1)
      CHECK_THAT(note,
                 ContainsSubstring("there are other solutions of the same loads") &&
                     ContainsSubstring("the determinant of pair 0 of node 1 of body 'wedge'") &&
                     ContainsSubstring("is -0.8, and several solutions begin below 0, from a "
                                       "friction coefficient of 1.66667 on; there it is 3"));
    if (contact_status == ContactStatus::Stick && answers(mu_strong, push).size() == 1)
      CHECK(step.solution.notes.size() == 1);
    if (time <= 11)
      CHECK(contact_status == (push < 0.6 ? ContactStatus::Stick : ContactStatus::Open));
    if (time > 11)
      CHECK(contact_status == (push > 1. / 3 ? ContactStatus::Open : ContactStatus::SlipBackward));
  });
  REQUIRE(past.slip(0) == 0);
  CondensedPath condensed = condense_path(model, ledger);
  for (const ContactStatus contact_status :
       {ContactStatus::Open, ContactStatus::Stick, ContactStatus::SlipForward}) {
    CAPTURE(to_string(contact_status));
    past.contact_status[0] = contact_status;  // the same slip, and another answer
    CHECK(step(past, 7.25, model, condensed, {}).state.contact_status[0] == contact_status);
  }
}

TEST_CASE("an elastic block slides off where a rigid one does",
          "[friction][floating][closed-form]") {
  for (const Friction& law :
       {Friction{0.4, 0}, Friction{0.4, 0.1}, Friction{0, 0.2}, Friction{0.1, 0.05}}) {
    CAPTURE(law.coefficient, law.cohesion);
    CHECK(slip_angle(law) == Approx(slip_angle_exact(law)).epsilon(1e-10).margin(0));
  }
}

TEST_CASE("an elastic block slides at its corner first, and nearly everywhere before it goes",
          "[friction][floating]") {
  const Friction law{0.4, 0};
  const auto sliding = [&](double share) {
    const Solution held = solve(incline(share * slip_angle_exact(law), law));
    REQUIRE(held.contact.report.status == SolveStatus::Solved);
    const std::vector<ContactStatus>& contact_status = held.contact.contact_status;
    return std::count(contact_status.begin(), contact_status.end(), ContactStatus::SlipForward);
  };
  CHECK(sliding(0.3) == 0);
  CHECK(sliding(0.5) == 1);
  CHECK(sliding(0.8) == 1);
  CHECK(sliding(0.95) > 17 / 2);
}

// A load that only grows: the share that is reported is that of the formula, s (W sin t - mu W cos t) = c A.
TEST_CASE("a block that is too heavy for its cohesion is refused with the share that is held",
          "[friction][floating][closed-form]") {
  const double angle = 0.6;
  const Solution refused = solve(incline(angle, {0.4, 0.1}));
  CHECK(refused.contact.report.status != SolveStatus::Solved);
  REQUIRE(refused.limit.has_value());
  const double exact = 0.1 / (std::sin(angle) - 0.4 * std::cos(angle));
  CHECK(*refused.limit == Approx(exact).epsilon(1e-9));
}
