// Live figure of chapter 6: load, mesh, element and solver of the beam. One factor serves all loads.
#include "../scene.hpp"
#include "live/figure.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/table.hpp"

namespace live {
namespace {

using namespace signorini;

// The scene of the chapter, whose load grows with the time: 1 is the load of the paper.
Loaded loaded(const Request& now) {
  Scene scene =
      ch06::cantilever(ch06::paper, now.chosen("element"), std::stol(now.chosen("cells")));
  scene.bodies[0].loads.edges[0].history = "load";
  scene.path = Path{{1}, {proportional("load")}};
  scene.solver = find_solver(now.chosen("solver"));
  return Loaded(scene);
}

Answer lie_down(const Request& now) {
  Loaded& beam = kept(now.key({"load"}), [&now] { return loaded(now); });
  BeamOnFoundation theory = ch06::paper;
  theory.pressure = now["load"];
  const Solution solution = beam.at(theory.pressure / ch06::paper.pressure);
  const Resultants sum = resultants(beam.model, solution);
  const VectorXd x = beam.model.pairs.position.col(0);

  Panel body{"The beam after loading, displacements to scale", "x [cm]", "y [cm]", true};
  body.window = {-1, 51, -5, 5.7};
  body.curve("foundation, rigid", Look::Solid, Eigen::Vector4d(-1, 51, 51, -1),
             Eigen::Vector4d(-1, -1, -5, -5));
  body.bodies(beam.model, solution, 300);
  body.pressure(beam.model, solution, 0.25);
  Panel largest{"Largest contact pressure over the load", "load q [kN/cm\u00b2]",
                "largest pressure [kN/cm\u00b2]"};
  largest.window = {0, 3.6, 0, 130};
  largest.clips = true;
  largest.question =
      "The beam hangs free, then stands on its tip, then lies down. Draw how its largest contact "
      "pressure goes with the load, before you see it.";
  largest.trail("loads so far", text(now.chosen("element"), ", ", now.chosen("cells"), " cells"),
                theory.pressure, sum.peak_pressure);
  Panel pressure{"Contact pressure near the tip", "x [cm]", "pressure [kN/cm\u00b2]"};
  pressure.window = {39.9, 50.1, 0, 30};
  pressure.clips = true;
  const VectorXd fine = VectorXd::LinSpaced(201, 40, 50);
  const auto on_beam = [&theory](double at) { return timoshenko_pressure(theory, at); };
  pressure.curve("Timoshenko beam", Look::Dashed, fine, fine.unaryExpr(on_beam));
  pressure.points("pairs", x, solution.pressure, solution.contact.force);
  Panel gap{"Gap under the beam", "x [cm]", "gap [cm]"};
  gap.window = {-0.5, 50.5, -0.02, 1.02};
  gap.points("pairs", x, solution.contact.gap, solution.contact.force);

  Answer answer;
  const BeamContact beams = timoshenko(theory);
  answer.says = sum.closed == 0                    ? "The beam hangs free."
                : sum.closed == 1                  ? "The beam stands on its tip."
                : beams.touchdown == theory.length ? "The beam stands on its tip, which is dented."
                                                   : "The beam lies on its end.";
  answer.number("force", "contact force", sum.force.y(), "kN", "%.3f");
  answer.number("theory", "Timoshenko beam", beams.total_force, "kN", "%.3f");
  answer.number("peak", "largest pressure", sum.peak_pressure, "kN/cm\u00b2", "%.3f");
  answer.solution(solution);
  answer.panels = {body, largest, pressure, gap};
  return answer;
}

}  // namespace

Figure cantilever() {
  return {
      "cantilever",
      "A beam that lies down",
      {playing(slider("load", "load q [kN/cm\u00b2]", 3.6, 0.05, 3.6, 0.05)),
       choice("cells", "cells along the beam", "100", {"50", "100", "200"}),
       choice("element", "element", "q4_incompatible", {"q4", "q4_bbar", "q4_incompatible", "q8"}),
       choice(
           "solver", "solver", "primal_dual_active_set",
           {"primal_dual_active_set", "quasi_active_set", "lemke", "goldfarb_idnani",
            "projected_gauss_seidel", "fischer_burmeister", "linear_programme", "surrogate_dual"})},
      lie_down};
}

}  // namespace live
