// Live figure of chapter 13: thickness and modulus of the footing, cells and depth of the soil.
#include "../base.hpp"
#include "live/figure.hpp"
#include "signorini/core/table.hpp"

namespace live {
namespace {

using namespace ch13;
using Eigen::Vector2d;

const double times_as_large = 200;  // displacements in the picture, as in figure 13.1

EdgeBlockSpec soil_for(const Request& now) {
  const double far = std::stod(now.chosen("depth"));
  const std::string& under = now.chosen("cells");
  return under == "7"    ? soil_of(7, 9, 5, 4, far)
         : under == "16" ? soil_of(16, 20, 16, 16, far)
                         : soil_of(30, 40, 34, 64, far);
}

FootingSpec footing_for(const Request& now) {
  FootingSpec footing;
  footing.thickness = now["thickness"];
  footing.rows = now.chosen("cells") == "30" ? 12 : 4;
  footing.modulus = soil_modulus * std::pow(10, now["stiffer"]);
  return footing;
}

Panel picture_of(const SolvedScene& run, const Base& base) {
  Panel picture{"Near the footing, displacements 200 times as large", "x [m]", "y [m]", true};
  picture.window = {0, 4, -3, 2};
  picture.bodies(run.model, run.solution, 40, times_as_large);
  const NodeArray& u = run.solution.displacements[1];
  const Mesh& soil = run.model.bodies[1].mesh;
  std::vector<Index> nodes = boundary_nodes(soil, "loaded");  // from the edge to the axis
  std::reverse(nodes.begin(), nodes.end());
  NodeArray down(base.force.size(), 2);
  down.rowwise() = Eigen::RowVector2d(0, -1);
  picture.arrows("pressure on the soil",
                 soil.nodes(nodes, Eigen::all) + times_as_large * u(nodes, Eigen::all), down,
                 base.pressure(), 0.015);
  return picture;
}

Answer settle_down(const Request& now) {
  const SolvedScene run = settle(soil_for(now), footing_for(now));
  const Base base = base_of(run);
  const VectorXd off = base.deviation(), pressure = base.pressure() / q;
  Panel curve{"Pressure under half of the footing", "x [m]", "pressure / q"};
  curve.window = {0, 1.53, 0, 6.3};
  curve.clips = true;
  curve.question =
      "A stiff footing stands on soft soil and carries the load q everywhere. Draw the pressure on "
      "the soil, from the middle, x = 0, to the edge, x = 1.5 m, before you see it.";
  const VectorXd fine = VectorXd::LinSpaced(301, 0, 0.9999 * a);
  const auto rigid = [](double x) { return rigid_strip_pressure(strip, x) / q; };
  curve.curve("rigid footing, half-space", Look::Dashed, fine, fine.unaryExpr(rigid));
  curve.points("nodes", base.piece, pressure, base.force);
  Panel trail{"How thick must it be?", "thickness [m]", "pressure in the middle / q"};
  trail.window = {0, 2, 0.6, 1.4};
  trail.curve("rigid", Look::Dotted, Vector2d(0, 2), Vector2d::Constant(mean_pressure / q));
  trail.curve("limp", Look::Dotted, Vector2d(0, 2), Vector2d(1, 1));
  trail.trail("thicknesses so far",
              text(now.chosen("cells"), " cells, ", now.chosen("depth"), " m, 10^", now["stiffer"]),
              now["thickness"], pressure(0));

  Answer answer;
  const Index n = off.size();
  answer.says = text("The pressure in the middle is ", number(pressure(0), "%.3f"),
                     " q, that of the node at the edge ", number(pressure(n - 1), "%.2f"), " q.");
  answer.number("middle", "pressure in the middle", pressure(0), "q", "%.4f");
  answer.number("worst", "worst node with x \u2264 0.8 a off by", 100 * base.worst(), "%", "%.2f");
  answer.number("corner", "corner node off by", 100 * off(n - 1), "%", "%.2f");
  answer.number("settlement", "sinks by", 1000 * base.settlement, "mm", "%.3f");
  answer.solution(run.solution);
  answer.panels = {picture_of(run, base), curve, trail};
  return answer;
}

}  // namespace

Figure footing() {
  return {"footing",
          "A footing on soil",
          {playing(slider("thickness", "thickness of the footing [m]", 2, 0.1, 2, 0.05)),
           slider("stiffer", "stiffer than the soil by 10 to the", 3, 0, 5, 0.5),
           choice("cells", "cells under half of it", "7", {"7", "16", "30"}),
           choice("depth", "depth and width of the soil [m]", "15", {"15", "60"})},
          settle_down};
}

}  // namespace live
