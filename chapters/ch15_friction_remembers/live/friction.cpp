// Live figure of chapter 15: a cylinder is pushed forth and back. Steps that were done are kept.
#include "../partial_slip.hpp"
#include "live/figure.hpp"
#include "signorini/core/table.hpp"

namespace live {
namespace {

using namespace ch15;
// Pressed in one step; the push turns after 6, 18 and 30 more.
const std::vector<double> times = push_times(6);

// A path as far as it was asked for.
struct Way {
  Loaded& scene;
  Pressed known = {};
  std::vector<Step> steps = {};
  void go_on(bool remembers) {
    const PathState past = remembers && !steps.empty() ? steps.back().state : PathState{};
    const Step next = step(past, times[steps.size()], scene.model, scene.path, {});
    require_solved(next.solution, "the step");
    steps.push_back(next);
  }
};

// The force that presses is known after the first step, and with it how far the push goes.
Way pressed_way(const Request& now) {
  const double coefficient = now["coefficient"];
  Way way{kept(number(coefficient), [coefficient] {
    Scene scene = by_force(cylinder(times, pressing, {"push", {1}, {0}}));
    scene.contacts[0].friction->coefficient = coefficient;
    return Loaded(scene);
  })};
  way.go_on(true);
  way.known = pressed_with(way.steps[0].solution.contact.force.sum(), coefficient, now["turn"]);
  way.scene.model.path.histories[1] = way.known.push();
  return way;
}

Panel shear(const Way& way, std::size_t last) {
  const PartialSlip& slip = way.known.slip;
  const double b = slip.half_width, most = slip.friction_coefficient * slip.peak_pressure;
  const VectorXd fine = VectorXd::LinSpaced(201, -b, b);
  const VectorXd bound = most * (1 - (fine / b).array().square()).max(0).sqrt();
  const auto exact = [&](double at) { return way.known.shear(times[last], at); };
  Panel panel{"Shear on the plate", "x [mm]", "shear [MPa]"};
  panel.window = {-1.05, 1.05, -15, 15};
  panel.curve("what friction bears", Look::Dotted, fine, bound);
  panel.curve("", Look::Dotted, fine, -bound);
  panel.curve("closed form", Look::Dashed, fine, fine.unaryExpr(exact));
  panel.motions(way.scene.model.pairs.position.col(0), shear_of(way.scene.model, way.steps[last]),
                way.steps[last].solution.contact);
  return panel;
}

// The push over what the contact has slipped since it was pressed, in the mean over its closed pairs.
Panel loop(const Way& way, std::size_t last) {
  const VectorXd& weight = way.scene.model.pairs.weight;
  VectorXd slip(Index(last) + 1), push(slip.size());
  for (Index k = 0; k < slip.size(); ++k) {
    const Step& then = way.steps[std::size_t(k)];
    const std::vector<Index>& closed = then.solution.contact.active();
    slip(k) = 1e6 * weight(closed).dot(then.state.slip(closed)) / weight(closed).sum();
    push(k) = way.known.push().at(then.state.time) / slip_limit(way.known.slip);
  }
  Panel panel{"The way so far", "slip, mean over the contact [nm]", "push / \u03bcP"};
  panel.window = {-500, 500, -1, 1};
  panel.clips = true;
  panel.curve("steps so far", Look::Line, slip, push);
  panel.curve("now", Look::Here, slip.tail(1), push.tail(1));
  return panel;
}

Panel stick_map(const Way& way, std::size_t last) {
  const VectorXd x = way.scene.model.pairs.position.col(0);
  const double h = 0.95 / 16;  // of the cells in the middle
  Panel panel{"Stick map, read from below", "x [mm]", "step"};
  panel.window = {-14 * h, 14 * h, 0, double(times.size())};
  panel.map(
      "slides", VectorXd::LinSpaced(28, -13.5 * h, 13.5 * h),
      VectorXd::LinSpaced(Index(last) + 2, 0, double(last) + 1),
      [&](double at, double row) {
        Index pair = 0;
        (x.array() - at).abs().minCoeff(&pair);
        const double slip = way.steps[std::size_t(row)].state.increment(pair);
        return slip > 0 ? 1. : slip < 0 ? -1. : 0.;
      },
      -1, 1);
  return panel;
}

Panel cylinder_of(const Way& way, std::size_t last) {
  Panel panel{"Cylinder and plate near the contact, to scale", "x [mm]", "y [mm]", true};
  panel.window = {-1.5, 1.5, -1.1, 1.1};
  panel.bodies(way.scene.model, way.steps[last].solution, 16);
  panel.pressure(way.scene.model, way.steps[last].solution, 0.035);
  return panel;
}

Answer push_and_turn(const Request& now) {
  Way& way = kept(now.key({"step"}), [&now] { return pressed_way(now); });
  const auto last = static_cast<std::size_t>(now.whole("step"));
  while (way.steps.size() <= last) way.go_on(now.on("memory"));
  const Step& step = way.steps[last];
  const std::vector<Index> stick = closed_pairs(step.solution.contact, false);
  const std::vector<Index> slide = closed_pairs(step.solution.contact, true);
  const double limit = slip_limit(way.known.slip), time = times[last];
  Answer answer;
  answer.says = slide.empty() ? "Everything sticks." : "The middle sticks, the edges slide.";
  answer.number("push", "push over \u03bcP", way.known.push().at(time) / limit, "", "%.2f");
  answer.number("stuck", "width that sticks", way.scene.model.pairs.weight(stick).sum(), "mm");
  answer.number("stuck_exact", "closed form", 2 * way.known.stuck(time), "mm");
  answer.number("miss", "shear misses the closed form by, of \u03bcq\u2080",
                100 * miss(way.known, time, way.scene.model, step), "%", "%.1f");
  if (now.on("memory"))
    answer.number("lost", "lost by sliding", 1e3 * step.state.dissipation.sum(), "\u00b5J");
  answer.solution(step.solution);
  answer.panels = {shear(way, last), loop(way, last), stick_map(way, last), cylinder_of(way, last)};
  return answer;
}

}  // namespace

Figure friction() {
  return {"friction",
          "A push forth and back",
          {playing(slider("step", "step, turns at 6 and 18", 6, 0, 30, 1)),
           slider("coefficient", "coefficient of friction \u03bc", 0.3, 0.1, 0.8, 0.1),
           slider("turn", "the push turns at, over \u03bcP", 0.6, 0.1, 0.95, 0.05),
           toggle("memory", "slip counts from the step before", true)},
          push_and_turn};
}

}  // namespace live
