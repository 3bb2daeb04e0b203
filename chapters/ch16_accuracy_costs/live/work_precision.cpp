// Live figure of chapter 16: where an element, a mesh, an operator and a solver lie between error and price.
#include "../ways.hpp"
#include "live/figure.hpp"

namespace live {
namespace {

using namespace signorini;
using namespace ch16;

const std::vector<std::string> elements = {"q4_incompatible", "q4", "q8"};
const std::vector<Look> looks = {Look::Line, Look::Dashed, Look::Dotted};

// The way of the chapter with another element and solver.
ch16::Way way_of(const std::string& gaps, const std::string& element, const std::string& solver) {
  ch16::Way way{"", element, gaps, solver};
  way.meet = gaps == "mortar_nodes_meet";
  if (way.meet) way.gap_operator = "mortar";
  if (gaps == "two_gauss_points") way.gap_operator = "gauss_points", way.points = 2;
  return way;
}

// Cells with eight nodes are half as many.
SolvedScene run_of(const ch16::Way& way, Index cells) {
  Ledger ledger;
  Model model = build(scene_of(way, way.element == "q8" ? cells / 2 : cells), ledger);
  Condensed condensed = condense(model, ledger);
  Solution solution = solve(model, condensed, ledger);
  return {std::move(model), std::move(condensed), std::move(solution)};
}

// A line for each element, by the solver that takes gaps which depend on each other.
std::vector<std::vector<Point>> lines_of(const std::string& gaps) {
  std::vector<std::vector<Point>> lines;
  for (const std::string& element : elements) {
    lines.emplace_back();
    for (const Index cells : {4, 8, 16})
      lines.back().push_back(point_of(run_of(way_of(gaps, element, "quasi_active_set"), cells)));
  }
  return lines;
}

VectorXd column(const std::vector<Point>& line, double Point::*value) {
  VectorXd out(static_cast<Index>(line.size()));
  for (Index k = 0; k < out.size(); ++k) out(k) = line[static_cast<std::size_t>(k)].*value;
  return out;
}

Panel pressure_of(const SolvedScene& run) {
  const VectorXd fine = VectorXd::LinSpaced(201, 0, 1.4);
  const auto ellipse = [](double at) { return hertz_pressure(HertzProblem().theory(), at); };
  const Pressures at = pressures(run);
  const Index n = std::lower_bound(at.x.begin(), at.x.end(), 1.4) - at.x.begin();
  Panel panel{"What such an error looks like", "x [mm]", "pressure [MPa]"};
  panel.window = {0, 1.4, 0, 32};
  panel.clips = true;
  panel.curve("Hertz", Look::Dashed, fine, fine.unaryExpr(ellipse));
  panel.curve("nodes", Look::Closed, VectorXd::Map(at.x.data(), n),
              VectorXd::Map(at.pressure.data(), n));
  return panel;
}

Answer pay(const Request& now) {
  const std::string gaps = now.chosen("gaps"), element = now.chosen("element");
  const auto& lines = kept(gaps, [&gaps] { return lines_of(gaps); });
  const Index cells = std::stol(now.chosen("cells"));
  const bool counted = now.chosen("price") == "unknowns";
  double Point::*cost = counted ? &Point::unknowns : &Point::operations;
  const SolvedScene run = run_of(way_of(gaps, element, now.chosen("solver")), cells);
  const Point here = point_of(run);
  Answer answer;
  Panel curves{"Error and price", counted ? "unknowns" : "operations",
               "error of the pressure [% of q\u2080]"};
  curves.log_x = curves.log_y = true;
  curves.window = {counted ? 80. : 5e4, counted ? 2e4 : 2e8, 0.02, 100};
  for (std::size_t k = 0; k < elements.size(); ++k) {
    curves.curve(elements[k], looks[k], column(lines[k], cost), column(lines[k], &Point::error));
    const double one = price(lines[k], 1, cost);
    const std::string label = curves.x_label + " for 1 % with " + elements[k];
    if (one > 0) answer.number("one_" + elements[k], label, one);
  }
  answer.panels = {curves};
  if (!here.solved) {
    answer.says = text("No solution: ", to_string(run.solution.contact.report.status), '.');
    return answer;
  }
  answer.panels[0].curve("this mesh", Look::Here, VectorXd::Constant(1, here.*cost),
                         VectorXd::Constant(1, here.error));
  Panel mesh{"Disc and plate near the contact", "x [mm]", "y [mm]", true};
  mesh.window = {0, 3, -1.5, 1.5};
  mesh.bodies(run.model, run.solution, 25);
  mesh.pressure(run.model, run.solution, 0.025);
  answer.panels.push_back(pressure_of(run));
  answer.panels.push_back(mesh);
  answer.says = here.error <= 1 ? "One percent is reached." : "One percent is not reached.";
  answer.number("error", "error of the pressure", here.error, "% of q\u2080", "%.3f");
  answer.number("unknowns", "unknowns", here.unknowns, "", "%.0f");
  answer.number("operations", "operations", here.operations, "", "%.3g");
  std::vector<Point> further = lines[std::size_t(now.whole("element"))];
  if (cells > 16) further.push_back(here);
  const double tenth = price(further, 0.1, &Point::operations);
  if (tenth > 0) answer.number("tenth", "operations for 0.1 %", tenth, "", "%.3g");
  answer.solution(run.solution);
  return answer;
}

}  // namespace

Figure work_precision() {
  return {"work_precision",
          "What an accuracy costs",
          {choice("element", "element", "q4_incompatible", elements),
           choice("cells", "cells, of q8 half as many", "8", {"4", "8", "16", "32"}),
           choice("gaps", "gaps by", "mortar",
                  {"mortar", "mortar_nodes_meet", "node_to_segment", "two_gauss_points"}),
           choice("solver", "solver", "primal_dual_active_set",
                  {"primal_dual_active_set", "quasi_active_set", "projected_gauss_seidel"}),
           with_own_axes(choice("price", "price in", "unknowns", {"unknowns", "operations"}))},
          pay};
}

}  // namespace live
