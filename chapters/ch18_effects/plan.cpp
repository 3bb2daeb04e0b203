// Chapter 18 - What the plan says of the last rung before anything is computed.
// Run:  make ch18     Reads: nothing     Writes: plan.md, fig_18_1*.csv
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>

#include "addons/steps/histories.hpp"
#include "meshes/hertz_meshes.hpp"
#include "papers/field_csv.hpp"
#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

// Figure 18.1: the two meshes, coarser, and what the plan says where.
void draw(const std::filesystem::path& folder, const Plan& planned) {
  HertzMeshSpec spec;
  spec.disc_cells = spec.plate_cells = spec.disc_rows = spec.plate_rows = 5;
  spec.disc_layers = spec.plate_layers = 14;
  spec.core = 4;
  const HertzMeshes coarse = make_hertz_meshes(spec);
  const auto outlines = [](const Mesh& mesh) {
    return deformed_cells_csv(mesh, NodeArray::Zero(mesh.n_nodes(), 2),
                              Eigen::VectorXd::Zero(mesh.n_cells()), 0);
  };
  write_file(folder / "fig_18_1_disc.csv", outlines(coarse.disc));
  write_file(folder / "fig_18_1_plate.csv", outlines(coarse.plate));
  Table table({"y", "from_x", "from_y", "says"});
  const auto say = [&table](const char* y, const char* x, const char* at, const std::string& what) {
    table.row({y, x, at, what});
  };
  say("56", "46", "54", "load: numbers in p");
  say("44", "40", "40", text("cylinder: ", planned.bodies[0].unknowns.count, " unknowns"));
  say("32", "36", "28", "heat: numbers in p");
  say("20", "24", "12", text("held by contact alone: ", planned.modes.size(), " amplitude"));
  say("6", "2", "0.3", text("contact: ", planned.gaps.A.rows(), " gaps"));
  say("-6", "2", "-0.3", text("friction: ", planned.law.pair.size(), " slips"));
  say("-50", "80", "-50", text("plate: ", planned.bodies[1].unknowns.count, " unknowns"));
  write_file(folder / "fig_18_1.csv", table.csv());
}

// What the plan says of a scene: what is on and why, and what is off.
void show_plan(const ProgramOptions& run, const Scene& scene) {
  std::ostringstream said;
  const Plan planned = plan(scene);
  said << planned;
  write_file(run.out / "plan.md", "```text\n" + said.str() + "```\n");
  std::cout << said.str();
  draw(run.out, planned);
}

SolveStatus chapter(const ProgramOptions& run) {
  register_load_steps();  // one more effect, which the plan names as off
  show_plan(run, heated(with_friction(floating(with_plate(on_rock(0))))));
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch18_plan", "A scene and its plan", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
