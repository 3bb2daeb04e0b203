// Chapter 15 - Friction remembers.
// Run:  make ch15     Reads: nothing     Writes: ch15.results, states.md, steps.md, square.md, fig_15_*.csv
#include "blocks.hpp"
#include "figures.hpp"
#include "orders.hpp"
#include "partial_slip.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "wedge.hpp"

namespace {

using namespace ch15;

// 1. A spring slider goes round its loop: by hand, by the library, and without memory.
void spring(const ProgramOptions& run, Results& results) {
  const Scene scene = triangle(equal_steps(20, 5));
  std::vector<double> forgets;
  forget(scene, [&](const Model&, const Step& alone) {
    forgets.push_back(-alone.solution.contact.friction(0));
  });
  Table table({"time", "hand", "pull", "slip", "by_hand", "forgets"});
  table.row({0., 0., 0., 0., 0., 0.});  // at rest
  // [loop]
  Tip tip;
  WorkMeter meter;
  Work first;  // until time 1, where the loop begins
  remember(scene, [&](const Model& model, const Step& step) {
    const double time = step.state.time, hand = to_and_fro().at(time);
    const double pull = -step.solution.contact.friction(0);
    meter.add(model, step);
    if (time == 1) first = meter.work();
    const auto row = static_cast<std::size_t>(step.state.steps - 1);
    table.row({time, hand, pull, step.state.slip(0), drag(hand, tip), forgets[row]});
  });
  const double area = meter.work().supports - first.supports;        // under the pull of the hand
  const double lost = meter.work().dissipation - first.dissipation;  // |friction| |slip|
  // [loop]
  results.add("loop_area", area, "Nmm");
  results.add("loop_lost", lost, "Nmm");
  results.add("loop_exact", 4 * B * (U - B / k), "Nmm");
  write_file(run.out / "fig_15_1.csv", table.csv());
}

// 2. Partial slip: the push grows to 0.6 mu P, turns, and turns again.
void partial_slip(const ProgramOptions& run, Results& results, const Pressed& known) {
  std::vector<double> forgot;
  forget(by_force(cylinder(shown, pressing, known.push())),
         [&](const Model& model, const Step& step) {
           forgot.push_back(100 * miss(known, step.state.time, model, step));
         });
  std::vector<double> times = {1};
  for (const double time : steps_between(1, 6, 6)) times.push_back(time);
  Table states(
      {"Q / μP", "shear misses by [% of μq₀]", "with slip in total", "the same in closed form"});
  StickMap map(known);
  std::size_t row = 0;
  remember(
      by_force(cylinder(times, pressing, known.push())), [&](const Model& model, const Step& step) {
        const double time = step.state.time;
        map.add(model, step);
        if (time == 2) results.add("stick", stuck_half_width(known, model, step), "mm");
        if (row == shown.size() || time != shown[row]) return;
        states.row({number(known.push().at(time) / (mu * known.P), "%.1f"),
                    number(100 * miss(known, time, model, step), "%.1f"),
                    number(forgot[row], "%.1f"), number(100 * forgotten(known, time), "%.1f")});
        results.add(text("forgot_", row), forgot[row], "%");
        ++row;
      });
  map.write(run.out);
  write_theory(run.out, known);
  write_file(run.out / "states.md", states.markdown());
  results.add("b", known.slip.half_width, "mm");
  results.add("stick_exact", stick_half_width(known.slip, known.Q), "mm");
  results.headline("stick", stick_half_width(known.slip, known.Q), "Cattaneo and Mindlin");
}

// 3. One end, three orders; and without friction.
void three_orders(const ProgramOptions& run, Results& results) {
  Table figure({"order", "x", "shear", "bound"});
  std::vector<End> smooth;
  for (const Order& order : orders()) {
    const int steps = smooth.size() == 2 ? 64 : 8;  // the straight way needs more, see below
    Scene scene = cylinder(equal_steps(steps, 2), order.press, order.push);
    const double push = end_of(scene, &figure, order.name).push;
    const bool none = order.push.times[0] < order.press.times[0];  // nothing but rounding
    results.add(text("push_", smooth.size()), push, "-", none ? Repeats::No : Repeats::Yes);
    scene.contacts[0].friction.reset();
    scene.path->times = equal_steps(4, 2);
    smooth.push_back(end_of(scene));
  }
  double differ = 0;
  for (const End& end : smooth)
    differ = std::max(differ, (end.force - smooth[0].force).norm() / smooth[0].force.norm());
  results.add("smooth_differ", differ, "-", Repeats::No);
  write_file(run.out / "fig_15_4.csv", figure.csv("rel 1e-5 abs 1e-5"));
}

// 4. More steps: what they change and what not.
// [steps]
void more_steps(const ProgramOptions& run, Results& results, const Pressed& known) {
  Table table({"steps", "shear on the way back at Q = 0 misses by [%]", "lost in a loop [μJ]",
               "work of the push [μJ]", "Q / μP, straight"});
  for (const int n : {1, 2, 4, 8, 16}) {
    std::vector<double> times = {1};  // pressed in one step
    for (const double time : steps_between(1, 6, n)) times.push_back(time);
    WorkMeter meter;
    Work first;
    double missed = 0;
    remember(by_force(cylinder(times, pressing, known.push())),
             [&](const Model& model, const Step& step) {
               meter.add(model, step);
               if (step.state.time == 2) first = meter.work();
               if (step.state.time == 3) missed = miss(known, 3, model, step);
             });
    const Order straight = orders()[2];
    const double push = end_of(cylinder(equal_steps(n, 2), straight.press, straight.push)).push;
    const double lost = meter.work().dissipation - first.dissipation;
    const double area = meter.work().put_in() - first.put_in();
    table.row({text(n), number(100 * missed, "%.3f"), number(1e3 * lost, "%.3f"),
               number(1e3 * area, "%.3f"), number(push, "%.4f")});
    results.add(text("lost_", n), 1e3 * lost, "uJ");
    results.add(text("straight_", n), push, "-");
  }
  write_file(run.out / "steps.md", table.markdown());
}
// [steps]

// 5. Several answers, and which one a step takes.
void fork(const ProgramOptions& run, Results& results) {
  Table all({"mu", "motion", "push", "slip"}), path({"mu", "time", "push", "slip"});
  for (const double coefficient : {1., 3.}) {
    for (const Motion motion : {Motion::Stick, Motion::Forward, Motion::Open}) {
      for (int i = 0; i <= 120; ++i)
        for (const Answer& answer : answers(coefficient, i / 150.))
          if (answer.motion == motion)
            all.row(
                {number(coefficient), to_string(motion), number(i / 150.), number(answer.slip)});
      all.blank_line();
    }
    const Scene scene = wedge(coefficient);
    remember(scene, [&](const Model&, const Step& step) {
      const double push = scene.path->histories[1].at(step.state.time);
      path.row({coefficient, step.state.time, push, 1e3 * step.solution.displacements[0](1, 1)});
    });
  }
  for (const Answer& answer : answers(3, 0.5))
    results.add(text("slip_", to_string(answer.motion)), answer.slip, "um");
  write_file(run.out / "fig_15_5.csv", all.csv());
  write_file(run.out / "fig_15_5_path.csv", path.csv());
}

// 6. A block on an incline, and the square that sticks, slips and opens.
void blocks(const ProgramOptions& run, Results& results) {
  const double degree = std::acos(-1) / 180;
  for (const Friction& law : {Friction{0.4, 0}, Friction{0.4, 0.1}}) {
    const std::string name = law.cohesion > 0 ? "cohesive" : "coulomb";
    const double angle = slip_angle(law);
    results.add("angle_" + name, angle / degree, "deg");
    results.add("error_" + name, std::abs(angle / slip_angle_exact(law) - 1), "-", Repeats::No);
  }
  const double published[] = {2.86, 2.72, 2.28, 1.98, 1.50};
  const double aster[] = {2.8722, 2.7355, 2.2996, 1.9943, 1.5569};  // one model of Code_Aster
  Table table({"x [mm]", "published", "ssnv128d", "one step", "five steps"});
  Table figure({"x", "moved", "motion"});
  std::vector<Eigen::VectorXd> moved;
  for (const int steps : {1, 5})
    remember(square(steps), [&](const Model& model, const Step& step) {
      if (step.state.time < 1) return;
      moved.push_back(1e5 * step.solution.displacements[0].col(0).head(33));
      for (Index i = 0; steps == 5 && i < 32; ++i)
        figure.row({number(1e3 * model.pairs.position(i, 0)), number(moved.back()(i)),
                    to_string(step.solution.contact.motion[static_cast<std::size_t>(i)])});
    });
  const Index node[] = {0, 1, 4, 6, 9};
  for (int i = 0; i < 5; ++i)
    table.row({number(1.25 * double(node[i])), number(published[i], "%.2f"),
               number(aster[i], "%.4f"), number(moved[0](node[i]), "%.4f"),
               number(moved[1](node[i]), "%.4f")});
  results.add("square_above", 100 * (moved[0](node[4]) / published[4] - 1), "%");
  write_file(run.out / "square.md", table.markdown());
  write_file(run.out / "fig_15_6.csv", figure.csv());
}

Status chapter(const ProgramOptions& run) {
  Results results("ch15");
  const Pressed known = pressed_cylinder();
  spring(run, results);
  partial_slip(run, results, known);
  three_orders(run, results);
  more_steps(run, results, known);
  fork(run, results);
  blocks(run, results);
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch15", "Friction remembers", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}
