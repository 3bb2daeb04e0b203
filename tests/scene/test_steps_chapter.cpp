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
    CHECK(-step.solution.contact.friction(0) == Approx(pull).margin(1e-12 * c));
    CHECK(step.state.slip(0) == Approx(tip.place).margin(1e-12 * U));
    CHECK(step.state.dissipation(0) == Approx(tip.lost).margin(1e-12 * c * U));
    meter.add(model, step);
    if (time == 1) first = meter.work();
  });
  const double exact = 4 * c * (U - c / k);
  CHECK(meter.work().supports - first.supports == Approx(exact).epsilon(1e-10));
  CHECK(meter.work().dissipation - first.dissipation == Approx(exact).epsilon(1e-10));
  forget(scene, [](const Model&, const Step& alone) {
    const double stuck = k * to_and_fro().at(alone.state.time);
    CHECK(-alone.solution.contact.friction(0) ==
          Approx(std::clamp(stuck, -c, c)).margin(1e-12 * c));
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
    CAPTURE(to_string(answer.motion));
    const QuadraticProgramme& programme = model.programme;
    const Eigen::Vector2d force(answer.force, answer.friction);
    const Eigen::Vector2d u = Eigen::Matrix2d(programme.stiffness).inverse() *
                              (programme.load - programme.A.transpose() * force);
    CHECK(u(1) == Approx(1e-3 * answer.slip).margin(1e-15));
    CHECK(certify(programme, {u, {}, force}, model.law).holds());
  }
  remember(scene, [&](const Model&, const Step& step) {
    const double time = step.state.time, push = scene.path->histories[1].at(time);
    CAPTURE(time, push);
    const Motion motion = step.state.motion[0];
    if (time <= 11) CHECK(motion == (push < 0.6 ? Motion::Stick : Motion::Open));
    if (time > 11) CHECK(motion == (push > 1. / 3 ? Motion::Open : Motion::Backward));
  });
}

TEST_CASE("an elastic block slides off where a rigid one does",
          "[friction][floating][closed-form]") {
  for (const Friction& law :
       {Friction{0.4, 0}, Friction{0.4, 0.1}, Friction{0, 0.2}, Friction{0.1, 0.05}}) {
    CAPTURE(law.coefficient, law.cohesion);
    CHECK(slip_angle(law) == Approx(slip_angle_exact(law)).epsilon(1e-10).margin(0));
  }
}
