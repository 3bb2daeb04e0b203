// Live figure of chapter 11: load, meshes, operator and element of Hertz's contact. One factor serves all loads.
#include "../hertz_run.hpp"
#include "live/figure.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/table.hpp"

namespace live {
namespace {

using namespace signorini;

const double heaviest = 59.16;  // load of the slider's end [N/mm]

HertzCase case_of(const Request& now) {
  const bool quadratic = now.chosen("element") == "q8";
  const Index cells = std::stol(now.chosen("cells")) / (quadratic ? 2 : 1);
  HertzCase out;  // the mesh of the chapter
  if (cells != 16) out = finer(cells, cells * 3 / 4, cells);
  if (!now.on("meet")) out.mesh.plate_cells = cells * 13 / 16;
  if (quadratic) out.mesh.order = MeshOrder::Quadratic;
  out.element = now.chosen("element");
  out.gap_operator = now.chosen("operator");
  if (out.gap_operator.rfind("gauss_points_", 0) == 0) {
    out.points = out.gap_operator.back() - '0';
    out.gap_operator = "gauss_points";
    out.solver = find_solver("quasi_active_set");  // takes gaps that depend on each other
  }
  out.load = now["load"];
  return out;
}

// The scene of the chapter, whose load grows until time 1.
Loaded loaded(HertzCase now) {
  now.load = heaviest;
  Scene scene = hertz_scene(now);
  scene.bodies[0].loads.edges[0].history = "load";
  scene.path = Path{{1}, {proportional("load")}};
  return Loaded(scene);
}

const double widest = 1.6;  // of the panels [mm]

// Pairs that the panels show.
std::vector<Index> shown_pairs(const Pairs& pairs) {
  std::vector<Index> near;
  for (Index i = 0; i < pairs.weight.size(); ++i)
    if (pairs.position(i, 0) < widest) near.push_back(i);
  return near;
}

Panel pressure_curves(const HertzRun& out) {
  const LineContact theory = out.now.theory();
  const Solution& solution = out.run.solution;
  const VectorXd fine = VectorXd::LinSpaced(201, 0, widest);
  const auto ellipse = [&theory](double at) { return hertz_pressure(theory, at); };
  const std::vector<Index> near = shown_pairs(out.run.model.pairs);
  const auto n =
      static_cast<Index>(std::lower_bound(out.x.begin(), out.x.end(), widest) - out.x.begin());
  Panel panel{"Contact pressure", "x [mm]", "pressure [MPa]"};
  panel.window = {0, widest, 0, 40};
  panel.clips = true;
  panel.curve("Hertz", Look::Dashed, fine, fine.unaryExpr(ellipse));
  panel.points("pairs", out.run.model.pairs.position.col(0)(near), solution.pressure(near),
               solution.contact.force(near));
  if (out.now.points > 0)
    panel.curve("the same, lumped to nodes", Look::Cross, VectorXd::Map(out.x.data(), n),
                VectorXd::Map(out.pressure.data(), n));
  return panel;
}

Panel widths(const Request& now, const HertzRun& out) {
  Panel panel{"Half-width over load", "load P [N/mm]", "half-width b [mm]"};
  panel.window = {0, heaviest + 1, 0, 1.4};
  const VectorXd fine = VectorXd::LinSpaced(121, 0.5, heaviest);
  panel.curve("Hertz", Look::Dashed, fine, fine.unaryExpr([&out](double load) {
    LineContact theory = out.now.theory();
    theory.force = load;
    return hertz_half_width(theory);
  }));
  panel.trail("loads so far",
              text(now.chosen("operator"), ", ", now.chosen("element"), ", ", now.chosen("cells"),
                   now.on("meet") ? "" : ", apart"),
              now["load"], out.half_width);
  return panel;
}

Answer compress(const Request& now) {
  const HertzCase wanted = case_of(now);
  Loaded& bodies = kept(now.key({"load"}), [&wanted] { return loaded(wanted); });
  const HertzRun out = read_hertz(wanted, bodies.scene_at(wanted.load / heaviest));
  const Solution& solution = out.run.solution;
  const std::vector<Index> near_pairs = shown_pairs(out.run.model.pairs);
  const double b = hertz_half_width(wanted.theory());

  Panel near{"Disc and plate near the contact, to scale", "x [mm]", "y [mm]", true};
  near.window = {0, 3, -1.5, 1.5};
  near.bodies(out.run.model, solution, 25);
  near.pressure(out.run.model, solution, 0.025);
  Panel gap{"Gap", "x [mm]", "gap [\u00b5m]"};
  const VectorXd micrometres = 1000 * solution.contact.gap;
  gap.window = {0, widest, -1, 15};
  gap.clips = true;
  gap.points("pairs", out.run.model.pairs.position.col(0)(near_pairs), micrometres(near_pairs),
             solution.contact.force(near_pairs));

  Answer answer;
  const double rms = pressure_error(out);
  answer.says = rms < 0.5  ? "The pressures of the nodes lie on Hertz's ellipse."
                : rms < 10 ? "The pressures scatter about Hertz's ellipse."
                           : "The pressures miss Hertz's ellipse.";
  const double most = solution.pressure.maxCoeff() / hertz_peak_pressure(wanted.theory());
  if (most > 1.2)
    answer.says += " One pair carries " + number(most, "%.1f") + " times Hertz's largest pressure.";
  answer.number("b", "half-width b", out.half_width, "mm");
  answer.number("b_error", "off by", out.b_error, "%", "%+.3f");
  answer.number("q0", "largest pressure q\u2080", out.fit.peak_pressure, "MPa");
  answer.number("q_error", "off by", out.q_error, "%", "%+.3f");
  answer.number("rms", "pressures off by, root mean square", rms, "%", "%.2f");
  answer.number("last", "last closed pair at", out.last_closed / b, "b", "%.3f");
  answer.solution(solution, out.now.points == 0);
  answer.panels = {near, pressure_curves(out), widths(now, out), gap};
  for (const std::size_t k : {0, 1, 3})  // pressures of points are not determined
    for (Layer& layer : answer.panels[k].layers)
      layer.varies = out.now.points > 0 && layer.corners == 0 && layer.look != Look::Dashed;
  return answer;
}

}  // namespace

Figure hertz() {
  return {
      "hertz",
      "A cylinder on a plate",
      {playing(slider("load", "load P [N/mm]", 41.76, 10.44, heaviest, 1.74)),
       toggle("meet", "nodes of disc and plate meet", true),
       choice("operator", "gaps by", "mortar",
              {"mortar", "node_to_segment", "gauss_points_1", "gauss_points_2"}),
       choice("element", "element", "q4_incompatible", {"q4", "q4_bbar", "q4_incompatible", "q8"}),
       choice("cells", "cells on the core, of q8 half as many", "16", {"12", "16", "32"})},
      compress};
}

}  // namespace live
