// Live figure of chapter 1, and of the title page: a block is pressed onto an obstacle. One factor serves all depths.
#include "../block_on_obstacle.hpp"
#include "addons/frontal/frontal_factor.hpp"  // the factor of these scenes, linked with it
#include "live/figure.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/pressure_table.hpp"

namespace live {
namespace {

using namespace signorini;
using Eigen::Vector4d;

const double deepest = 2;  // end of the slider [mm]

// The scene of the chapter over an obstacle of another radius, beside the middle; its top comes down with time.
Loaded coming_down(const Request& now) {
  const double radius = now["radius"];
  Scene scene = ch01::block_on_obstacle(std::stol(now.chosen("cells")));
  scene.bodies[0].supports[1] = prescribed("top", Axis::Y, -deepest);
  for (Support& support : scene.bodies[0].supports) support.history = "down";
  scene.contacts[0].target = disc({now["shift"], -radius}, radius);
  scene.path = Path{{1}, {proportional("down")}};
  return Loaded(scene);
}

Panel picture_of(const Request& now, const Model& model, const Solution& solution) {
  const double top = 20 - now["depth"];
  Panel picture{"The block on the obstacle, to scale", "x [mm]", "y [mm]", true};
  picture.window = {-22, 22, -16, 21.6};
  const VectorXd angle = VectorXd::LinSpaced(121, 0, pi);
  picture.curve("obstacle, rigid", Look::Solid, now["radius"] * angle.array().cos() + now["shift"],
                now["radius"] * (angle.array().sin() - 1));
  picture.curve("plate, rigid", Look::Solid, Vector4d(-20, 20, 20, -20),
                Vector4d(top, top, top + 1.4, top + 1.4));
  picture.bodies(model, solution, 1.2);
  picture.pressure(model, solution, 6);
  picture.drag = {{"depth", 0, -1, 20}};
  picture.grab = true;
  return picture;
}

Answer go_down(const Request& now) {
  Loaded& block = kept(now.key({"depth"}), [&now] { return coming_down(now); });
  const Solution solution = block.at(now["depth"] / deepest);
  const Resultants sum = resultants(block.model, solution);
  const VectorXd x = block.model.pairs.position.col(0);
  Panel pressure{"Contact pressure along the base", "x [mm]", "pressure [N/mm\u00b2]"};
  pressure.window = {-20.5, 20.5, 0, 1.8};
  pressure.curve("", Look::Line, x, solution.pressure);
  pressure.points("pairs", x, solution.pressure, solution.contact.force);
  Panel force{"Twice as deep is not twice the force", "depth [mm]", "contact force [N]"};
  force.window = {0, deepest, 0, 30};
  force.trail("depths so far", text(now["radius"], " mm, ", now["shift"], " mm"), now["depth"],
              sum.force.y());

  Answer answer;
  const std::vector<Index>& closed = solution.contact.active();
  const double width = x(closed.back()) - x(closed.front());
  answer.says = text("The base touches along ", number(width, "%.1f"),
                     " mm, and the obstacle presses with ", number(sum.force.y(), "%.2f"), " N.");
  answer.number("force", "contact force", sum.force.y(), "N", "%.3f");
  answer.number("peak", "largest pressure", sum.peak_pressure, "N/mm\u00b2", "%.3f");
  answer.number("width", "touches along", width, "mm", "%.2f");
  answer.solution(solution);
  answer.panels = {picture_of(now, block.model, solution), pressure, force};
  return answer;
}

}  // namespace

Figure press() {
  return {"press",
          "A block is pressed onto an obstacle",
          {playing(slider("depth", "top comes down by [mm]", 1, 0.05, deepest, 0.05)),
           slider("radius", "radius of the obstacle [mm]", 60, 20, 200, 5),
           slider("shift", "obstacle stands at x [mm]", 0, -12, 12, 0.5),
           choice("cells", "cells along the base", "32", {"8", "32", "64"})},
          go_down};
}

}  // namespace live
