// Live figure of chapter 18: switch effects on and off, see what the plan says and what the contact does.
#include "../scenes.hpp"
#include "closed_form/hertz.hpp"
#include "live/figure.hpp"
#include "signorini/report/pressure_table.hpp"

namespace live {
namespace {

using namespace signorini;

// The rungs of the chapter, each by itself; coarser, so that an answer comes at once.
Scene scene_of(const Request& now) {
  Scene scene = on_rock(0.025);
  if (now.on("plate")) scene = with_plate(scene);
  if (now.on("load")) scene = floating(scene);
  if (now.on("friction")) scene = with_friction(scene);
  if (now.on("heat")) scene = heated(scene);
  if (now.on("weight")) scene = with_weight(scene);
  if (now.chosen("cells") == "40") return scene;
  HertzMeshSpec coarse;
  coarse.radius = signorini::R;
  coarse.disc_cells = coarse.plate_cells = 20;
  coarse.disc_rows = coarse.plate_rows = 10;
  coarse.disc_layers = coarse.plate_layers = 14;
  const HertzMeshes meshes = make_hertz_meshes(coarse);
  scene.bodies[0].mesh = meshes.disc;
  if (now.on("plate")) scene.bodies[1].mesh = meshes.plate;
  return scene;
}

// A pressure of Hertz with the force that the contact bears.
VectorXd theory(const Request& now, double half_force, const VectorXd& x) {
  const LineContact contact{signorini::R, now.on("plate") ? contact_modulus(stiff, stiff) : stiff,
                            2 * half_force};
  return x.unaryExpr([&contact](double at) { return hertz_pressure(contact, at); });
}

Answer switched(const Request& now) {
  const Scene scene = scene_of(now);
  const Plan planned = plan(scene);
  const SolvedScene run = solved(scene, "the scene");
  const Resultants sum = resultants(run.model, run.solution);

  Panel pressure{"Contact pressure", "x [mm]", "pressure [MPa]"};
  const VectorXd x = run.model.pairs.position.col(0);
  const VectorXd fine = VectorXd::LinSpaced(161, 0, 1.6);
  pressure.window = {0, 1.6, 0, 40};
  pressure.clips = true;
  pressure.curve("Hertz, for the same force", Look::Dashed, fine,
                 theory(now, std::abs(sum.force.y()), fine));
  pressure.points("pairs", x, run.solution.pressure, run.solution.contact.force);
  Panel bodies{"Where they touch, displacements to scale", "x [mm]", "y [mm]", true};
  bodies.window = {0, 3, -1.2, 1.2};
  bodies.bodies(run.model, run.solution, 25);
  bodies.pressure(run.model, run.solution, 0.02);

  Answer answer;
  answer.says = text(planned.on.size(), " lines of the plan are on, ", planned.off.size(),
                     " effects are off and cost nothing.");
  answer.number("unknowns", "unknowns", static_cast<double>(run.model.unknowns.count), "", "%.0f");
  answer.number("gaps", "gaps", static_cast<double>(run.condensed.problem.free_gap.size()), "",
                "%.0f");
  answer.number("slips", "slips", static_cast<double>(run.condensed.problem.free_slip.size()), "",
                "%.0f");
  answer.number("amplitudes", "amplitudes",
                static_cast<double>(run.condensed.problem.resultant.size()), "", "%.0f");
  answer.number("peak", "largest pressure of the fitted ellipse", peak_pressure(run), "MPa",
                "%.3f");
  answer.number("force", "force on the half", std::abs(sum.force.y()), "N/mm", "%.3f");
  answer.solution(run.solution);
  answer.panels = {pressure, bodies};
  answer.table = {{"plan", "what it says"}};
  for (const std::string& line : planned.on) answer.table.push_back({"on", line});
  for (const std::string& name : planned.off) answer.table.push_back({"off", name});
  return answer;
}

}  // namespace

Figure effects() {
  return {"effects",
          "Only what the scene calls for",
          {toggle("plate", "a plate in the place of the rock", true),
           toggle("load", "pressed by a load, held by contact alone", true),
           toggle("friction", "friction", false), toggle("heat", "a warm cylinder", false),
           toggle("weight", "its own weight", false),
           choice("cells", "cells where they touch", "20", {"20", "40"})},
          switched};
}

}  // namespace live
