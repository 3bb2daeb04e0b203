// Chapter 22 - A steel roller on a block of aluminium, a benchmark of NAFEMS, with four answers to strain.
// Takes longer than 5 s: ./run.sh shows its committed results.
// Run:  make ch22     Reads: nothing     Writes: ch22_roller.results, roller.md, fig_22_6.csv, fig_22_6_pressure.csv
#include <array>
#include <iostream>

#include "addons/motion/register.hpp"
#include "addons/steps/steps.hpp"
#include "closed_form/hertz.hpp"
#include "closed_form/moduli.hpp"
#include "meshes/hertz_meshes.hpp"
#include "reference/published.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/pairing/interface.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

const double load = 35000;  // of the whole roller [N/mm]

struct Answer {
  const char* key;
  const char* name;
  const char* law;
  bool moves;
};

const std::array<Answer, 4> answers = {
    Answer{"linear", "small strain, linear gap", "small", false},
    {"moving", "small strain, bodies move", "small", true},
    {"st_venant", "St Venant-Kirchhoff", "st_venant_kirchhoff", true},
    {"neo_hooke", "neo-Hooke", "neo_hooke", true}};

// Half of both bodies, on one of four meshes.
Scene roller(const Answer& answer, Index fine) {
  HertzMeshSpec spec;
  spec.plate = {100, 200};
  spec.core = 8;
  spec.disc_cells = spec.plate_cells = 16 * fine;
  spec.disc_rows = spec.plate_rows = 10 * fine;
  spec.disc_layers = spec.plate_layers = 14 * fine;
  spec.layer_grading = 2;
  const HertzMeshes meshes = make_hertz_meshes(spec);
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = meshes.disc;
  scene.bodies[1].mesh = meshes.plate;
  for (Body& body : scene.bodies) {
    body.element = "q4";
    body.material = {70e3, 0.3, PlaneState::Strain, 1};
    body.material.law = find_strain_law(answer.law);
    body.supports = {symmetric("axis")};
  }
  scene.bodies[0].material.youngs_modulus = 210e3;
  scene.bodies[0].loads.edges = {{"middle", load / 2 / 50, {}, "press"}};
  scene.bodies[1].supports.push_back(fixed("base"));
  scene.contacts = {{{"rim", meshes.disc.name}, Side{"surface", meshes.plate.name}}};
  scene.path = Path{equal_steps(answer.moves ? 5 : 1), {proportional("press")}};
  scene.moves = answer.moves;
  return scene;
}

struct Reading {
  double under = 0;  // displacement under the roller [mm]
  double peak = 0;   // largest pressure [MPa]
};

// The last step; the pressures of the finest mesh go into the picture.
Reading read(const Answer& answer, Index fine, Table* pressures) {
  Reading reading;
  const PathEnd end = solve_steps(roller(answer, fine), [&](const Model& model, const Step& step) {
    if (step.state.time < 1) return;
    const Mesh& plate = model.bodies[1].mesh;
    reading.under = step.solution.displacements[1](boundary_nodes(plate, "surface").back(), 1);
    reading.peak = step.solution.pressure.maxCoeff();
    for (Index pair = 0; pressures != nullptr && pair < model.pairs.weight.size(); ++pair)
      if (model.pairs.position(pair, 0) < 8)
        pressures->row({answer.key, number(model.pairs.position(pair, 0)),
                        number(step.solution.pressure(pair))});
  });
  if (end.status != SolveStatus::Solved) throw NotSolved(end.reason);
  if (pressures != nullptr) pressures->blank_line();
  return reading;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22_roller");
  const LineContact theory{
      50, contact_modulus(plane_strain_modulus(210e3, 0.3), plane_strain_modulus(70e3, 0.3)), load};
  Table meshes({"answer", "cells", "under"}), pressures({"answer", "x", "pressure"});
  Table table({"strain", "under the roller [mm]", "largest pressure [MPa]"});
  for (const Answer& answer : answers) {
    Reading coarse, finest;
    for (Index fine = 1; fine <= 4; ++fine) {
      coarse = finest;
      finest = read(answer, fine, fine == 4 ? &pressures : nullptr);
      meshes.row({answer.key, number(16.0 * double(fine)), number(finest.under)});
    }
    meshes.blank_line();
    // The error falls with the square of the size of the cells.
    const double limit = finest.under + (finest.under - coarse.under) * 9 / 7;
    table.row({answer.name, number(limit, "%.4f"), number(finest.peak, "%.0f")});
    results.add(text("under_", answer.key), limit, "mm");
    results.add(text("peak_", answer.key), finest.peak, "MPa");
  }
  results.add("published", reference::roller_displacement, "mm");
  results.add("hertz", hertz_peak_pressure(theory), "MPa");
  std::cout << table.markdown();
  write_file(run.out / "roller.md", table.markdown());
  write_file(run.out / "fig_22_6.csv", meshes.csv("rel 1e-6 abs 1e-6"));
  write_file(run.out / "fig_22_6_pressure.csv", pressures.csv("rel 1e-4 abs 1e-2"));
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch22_roller", "A roller by four laws", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
