// Live figure of chapter 7: load, clearance, gap and mesh of the pin in its plate.
#include "../pin.hpp"

#include "live/figure.hpp"
#include "signorini/core/table.hpp"

namespace live {
namespace {

using namespace ch07;

Bearing bearing_of(const Request& now) {
  const Pin pin{now.chosen("load") == "pulls" ? -now["q"] : now["q"], now["clearance"],
                !now.on("exact")};
  if (now.chosen("cells") == "paper's") return on_paper_mesh(pin);
  const Index cells = std::stol(now.chosen("cells"));
  return on_even_mesh(pin, cells, cells / 2);
}

Panel picture_of(const Request& now, const Bearing& found) {
  const SolvedScene& run = found.run;
  const BodyModel& body = run.model.bodies[0];
  const NodeArray& u = run.solution.displacements[0];
  const double side = now.chosen("load") == "pulls" ? -1 : 1;
  Panel picture{"Upper half of plate and pin, to scale", "x [cm]", "y [cm]", true};
  picture.window = {-11.5, 12.5, 0, 11};
  const VectorXd angle = VectorXd::LinSpaced(91, 0, pi);
  const double radius = hole_radius - now["clearance"];
  picture.curve("pin, rigid", Look::Solid, radius * angle.array().cos() + side * now["clearance"],
                radius * angle.array().sin());
  picture.body(body, u, body.mesh.nodes + u, 125);
  std::vector<Index> hole = boundary_nodes(body.mesh, "hole");  // from the left to the right
  if (side > 0) std::reverse(hole.begin(), hole.end());
  const NodeArray before = body.mesh.nodes(hole, Eigen::all);
  picture.arrows("pressure on the hole", before + u(hole, Eigen::all), before / hole_radius,
                 found.pressure, 0.04);
  return picture;
}

Answer bear(const Request& now) {
  const Bearing found = bearing_of(now);
  Panel pressure{"Pressure from the pole to the top", "angle from the pole \u03b8 [degrees]",
                 "pressure [kN/cm\u00b2]"};
  pressure.window = {0, 90, 0, 80};
  pressure.question =
      "The pin bears from its pole, at 0 degrees, towards the top of the hole, at 90. Draw the "
      "pressure over the angle before you see it.";
  pressure.curve("", Look::Line, found.theta, found.pressure);
  pressure.points("nodes", found.theta, found.pressure, found.pressure);
  Index most = 0;
  const double peak = found.pressure.maxCoeff(&most);
  const double end = found.theta((found.pressure.array() > 0).count() - 1);
  Panel trail{"Is twice the load twice the pressure?", "load [kN/cm\u00b2]",
              "largest pressure [kN/cm\u00b2]"};
  trail.window = {0, 25, 0, 80};
  trail.trail("loads so far",
              text(now.chosen("load"), ", ", now["clearance"], " cm, ", now.chosen("cells"),
                   now.on("exact") ? ", exact" : ""),
              now["q"], peak);

  Answer answer;
  answer.says = text("The pin bears most at ", number(found.theta(most), "%.0f"),
                     " degrees from the pole, and up to about ", number(end, "%.0f"), ".");
  answer.number("peak", "largest pressure", peak, "kN/cm\u00b2", "%.2f");
  answer.number("pole", "pressure at the pole", found.pressure(0), "kN/cm\u00b2", "%.2f");
  answer.number("resultant", "force on the whole hole", found.resultant, "kN/cm", "%.3f");
  answer.number("right", "right side moves by", found.right, "cm", "%.4f");
  answer.solution(found.run.solution);
  answer.panels = {picture_of(now, found), pressure, trail};
  return answer;
}

}  // namespace

Figure pin() {
  return {"pin",
          "A pin bears in its hole",
          {playing(slider("q", "load q [kN/cm\u00b2]", 25, 1, 25, 0.5)),
           choice("load", "the load", "pulls", {"pulls", "presses"}),
           slider("clearance", "clearance \u03b5 [cm]", 0.2, 0.05, 0.4, 0.05),
           choice("cells", "cells along the half hole", "paper's", {"paper's", "36", "72"}),
           toggle("exact", "exact gap, not the linear one", false)},
          bear};
}

}  // namespace live
