// Live figure of chapter 22: a die irons a soft slab, down first, then along. Steps that were done are kept.
#include <cmath>

#include "live/figure.hpp"
#include "signorini/core/table.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/strain_laws.hpp"

namespace live {
namespace {

using namespace signorini;
using Eigen::Vector2d;

const double down = 0.05, along = 0.1;  // of a step
const int most_along = 40;

Body of_law(Mesh mesh, double youngs_modulus, const std::string& law) {
  Body body;
  body.mesh = std::move(mesh);
  body.element = "q4";
  body.material = {youngs_modulus, 0.32, PlaneState::Strain, 1};
  body.material.law = find_strain_law(law);
  return body;
}

int steps_down(const Request& now) { return int(std::lround(now["depth"] / down)); }

// As in the chapter, with cells twice as large: a die of radius 1, ten times as stiff as the slab.
Scene ironing(const Request& now) {
  const double half = std::acos(0.5);  // of the arc
  const Mesh die = mapped(block("die", {-1, 0}, {2, 1}, 12, 5), [=](const Vector2d& x) -> Vector2d {
    const Vector2d arc(std::sin(half * x.x()), -std::cos(half * x.x()));
    const Vector2d top(std::sin(half) * x.x(), 0.3);
    return Vector2d(2, 3) + (1 - x.y()) * arc + x.y() * top;
  });
  Scene scene;
  scene.bodies = {of_law(block("slab", {0, 0}, {8, 2}, 40, 8), 1, now.chosen("law")),
                  of_law(die, 10, now.chosen("law"))};
  scene.bodies[0].supports = {fixed("bottom")};
  scene.bodies[1].supports = {prescribed("top", Axis::X, along * double(most_along)),
                              prescribed("top", Axis::Y, -now["depth"])};
  scene.bodies[1].supports[0].history = "drag";
  scene.bodies[1].supports[1].history = "press";
  scene.contacts = {{{"bottom", "die"}, Side{"top", "slab"}}};
  if (now["coefficient"] > 0) scene.contacts[0].friction = Friction{now["coefficient"]};
  std::vector<double> times = equal_steps(steps_down(now));
  for (const double time : equal_steps(most_along)) times.push_back(1 + time);
  scene.path = Path{times, {{"press", {0, 1}, {0, 1}}, {"drag", {1, 2}, {0, 1}}}};
  return scene;
}

// A step, and the pairs where the bodies stood, which those of the next step are not.
struct Frame {
  Step step;
  Vector2d force;  // on the die
  NodeArray place, normal;
  VectorXd weight;
};

struct Way {
  Loaded scene;
  std::vector<Frame> frames = {};
  void go_on() {
    const PathState past = frames.empty() ? PathState{} : frames.back().step.state;
    Model& model = scene.model;
    const Step next = step(past, model.path.times[frames.size()], model, scene.path, {});
    require_solved(next.solution, "the step");
    const Vector2d force = contact_forces(model, next.solution, 1).colwise().sum().transpose();
    const Pairs& pairs = model.pairs;
    frames.push_back({next, force, pairs.position, pairs.normal, pairs.weight});
  }
};

Panel picture(const Way& way, const Frame& now) {
  Panel panel{"Die and slab, to scale: drag the die", "x / R", "y / R", true};
  panel.window = {-0.3, 8.3, -0.2, 3.9};
  panel.drag = {{"way", 1, 0}, {"depth", 0, -1}};
  panel.grab = true;
  panel.bodies(way.scene.model, now.step.solution, 0.6);
  panel.arrows("contact pressure", now.place, now.normal, now.step.solution.pressure, 0.8);
  return panel;
}

Panel forces(const Way& way, Index first, std::size_t last) {
  const Index n = Index(last) + 2 - first;
  VectorXd gone(n), press(n), drag(n);
  for (Index k = 0; k < n; ++k) {
    gone(k) = along * double(k);
    press(k) = way.frames[std::size_t(first - 1 + k)].force.y();
    drag(k) = -way.frames[std::size_t(first - 1 + k)].force.x();
  }
  Panel panel{"Forces on the die", "way along / R", "force / ER"};
  panel.window = {0, along * double(most_along), -0.05, 0.45};
  panel.clips = true;
  panel.curve("presses", Look::Line, gone, press);
  panel.curve("drags", Look::Dashed, gone, drag);
  panel.curve("now", Look::Here, gone.tail(1), press.tail(1));
  panel.curve("", Look::Here, gone.tail(1), drag.tail(1));
  return panel;
}

Panel pressures(const Request& request, const Frame& now) {
  const ContactState& contact = now.step.solution.contact;
  const VectorXd x = now.place.col(0);
  Panel panel{"On the face of the die", "x / R", "pressure and shear / E"};
  panel.window = {0, 8, -0.35, 0.65};
  panel.curve("pressure", Look::Line, x, now.step.solution.pressure);
  if (request["coefficient"] == 0) return panel;
  panel.curve("what friction bears", Look::Dotted, x,
              -request["coefficient"] * now.step.solution.pressure);
  panel.motions(x, contact.friction.cwiseQuotient(now.weight), contact);
  return panel;
}

Answer iron(const Request& now) {
  Way& way = kept(now.key({"way"}), [&now] { return Way{Loaded(ironing(now))}; });
  const Index first = steps_down(now);
  const auto last = std::size_t(first - 1 + std::lround(now["way"] / along));
  while (way.frames.size() <= last) way.go_on();
  const Frame& here = way.frames[last];
  Answer answer;
  const bool rubs = now["coefficient"] > 0;
  const ContactState& contact = here.step.solution.contact;
  answer.says = !rubs ? "Without friction hardly anything holds the die back."
                : closed_pairs(contact, false).empty()
                    ? "All of the contact slides."
                    : "Some of the contact sticks, and goes with the die.";
  answer.number("press", "presses", here.force.y(), "ER");
  answer.number("drag", "drags", -here.force.x(), "ER");
  answer.number("ratio", "drags over presses", -here.force.x() / here.force.y());
  answer.solution(here.step.solution);
  answer.panels = {picture(way, here), forces(way, first, last), pressures(now, here)};
  return answer;
}

}  // namespace

Figure die() {
  return {"die",
          "A die that irons",
          {playing(slider("way", "way along / R", 1, 0, along * double(most_along), along)),
           slider("depth", "depth / R", 0.3, down, 0.4, down),
           slider("coefficient", "coefficient of friction \u03bc", 0.3, 0, 0.6, 0.1),
           choice("law", "law", "neo_hooke", {"neo_hooke", "st_venant_kirchhoff"})},
          iron};
}

}  // namespace live
