// Chapter 11 - The bodies drawn: meshes, the surfaces at the contact, displacements, shear.
// Run:  make ch11     Reads: nothing     Writes: fig_11_1_*.csv, fig_11_5.csv, fig_11_6*.csv, fig_11_7*.csv

#include "hertz_run.hpp"
#include "papers/field_csv.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

// 1. Deformed cells with a corner nearer than `extent` [mm], with their largest shear stress.
std::string shear_near_contact(const SolvedScene& run, std::size_t body, double extent) {
  const BodyModel& model = run.model.bodies[body];
  const NodeArray& u = run.solution.displacements[body];
  const StressArray stress = cell_stress(model.mesh, model.element, model.material, u);
  const Eigen::VectorXd shear =
      (((stress.col(0) - stress.col(1)) / 2).array().square() + stress.col(2).array().square())
          .sqrt();
  std::vector<Eigen::Index> near;
  for (Eigen::Index cell = 0; cell < model.mesh.n_cells(); ++cell)
    for (Eigen::Index corner = 0; corner < 4; ++corner)
      if (model.mesh.nodes.row(model.mesh.cells(cell, corner)).cwiseAbs().maxCoeff() < extent) {
        near.push_back(cell);
        break;
      }
  Mesh part = model.mesh;
  part.boundaries.clear();
  part.cells = CellArray(model.mesh.cells(near, Eigen::all));
  return deformed_cells_csv(part, u, shear(near));
}

// 2. Both meshes before loading, and both bodies deformed with bands of their displacements.
void draw_bodies(const std::filesystem::path& folder, const SolvedScene& run) {
  for (const std::size_t body : {0, 1}) {
    const Mesh& mesh = run.model.bodies[body].mesh;
    const NodeArray& u = run.solution.displacements[body];
    const std::string end = body == 0 ? "_disc.csv" : "_plate.csv";
    write_file(folder / ("fig_11_1" + end),
               deformed_cells_csv(mesh, u, Eigen::VectorXd::Zero(mesh.n_cells()), 0));
    const auto bands = [&](const char* name, const Eigen::VectorXd& value,
                           const std::vector<double>& levels) {  // [mm], as in fig_11_6.gp
      write_file(folder / text("fig_11_6_", name, end),
                 deformed_bands_csv(mesh, u, value, levels, 40));
    };
    const std::vector<double> sizes = {.002, .005, .01, .02, .03, .04, .045, .05, .055, .06};
    bands("x", u.col(0), {-.0015, -.001, -.0005, 0, .0005, .001, .002, .003, .005, .007});
    bands("y", u.col(1), {-.06, -.055, -.05, -.045, -.04, -.03, -.02, -.01, -.005, -.002});
    bands("size", u.rowwise().norm(), sizes);
  }
  Table outline({"x", "y"});
  for (const auto& [x, y] : {std::pair(0, 0), {95, 0}, {95, -95}, {0, -95}, {0, 50}, {50, 50}})
    outline.row({static_cast<double>(x), static_cast<double>(y)});
  for (int k = 30; k >= 0; --k) {
    const double angle = k * std::acos(0.0) / 30;
    outline.row({50 * std::sin(angle), 50 - 50 * std::cos(angle)});
  }
  write_file(folder / "fig_11_6.csv", outline.csv());
}

// 3. The two surfaces next to the contact, before and after loading; heights in micrometres.
void draw_surfaces(const std::filesystem::path& folder, const SolvedScene& run) {
  Table table({"x", "y", "x_moved", "y_moved"});
  for (const std::size_t body : {0, 1}) {
    const Mesh& mesh = run.model.bodies[body].mesh;
    const NodeArray moved = mesh.nodes + run.solution.displacements[body];
    for (const Eigen::Index node : boundary_nodes(mesh, body == 0 ? "rim" : "surface"))
      if (mesh.nodes(node, 0) < 2)
        table.row(
            {mesh.nodes(node, 0), 1e3 * mesh.nodes(node, 1), moved(node, 0), 1e3 * moved(node, 1)});
    table.blank_line();
  }
  write_file(folder / "fig_11_5.csv", table.csv("rel 1e-6 abs 1e-6"));
}

SolveStatus chapter(const ProgramOptions& run) {
  const SolvedScene ours = solve_hertz({}).run;
  draw_bodies(run.out, ours);
  draw_surfaces(run.out, ours);
  write_file(run.out / "fig_11_7.csv", shear_near_contact(ours, 0, 2.5));
  write_file(run.out / "fig_11_7_plate.csv", shear_near_contact(ours, 1, 2.5));
  const Pairs& pairs = ours.model.pairs;
  const NodeArray moved = pairs.position + ours.solution.displacements[0](pairs.node, Eigen::all);
  write_file(run.out / "fig_11_7_arrows.csv",
             pressure_arrows_csv(moved, pairs.normal, ours.solution.pressure));
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11_bodies", "The bodies drawn", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
