// Chapter 13 - Stress and displacements below the footing.
// Run:  make ch13     Reads: nothing     Writes: ch13_fields.results, fig_13_1*.csv, fig_13_3*.csv
#include <algorithm>
#include <cmath>

#include "footing.hpp"
#include "papers/field_csv.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch13;

std::string undeformed(const Mesh& mesh) {
  return deformed_cells_csv(mesh, NodeArray::Zero(mesh.n_nodes(), 2),
                            VectorXd::Zero(mesh.n_cells()));
}

// The cells of a mesh with their middles at x < 6.5 and y > -8.5.
Mesh near_the_footing(const Mesh& mesh) {
  std::vector<Index> cells;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const Eigen::RowVector2d middle = cell_nodes(mesh, cell).colwise().mean();
    if (middle(0) < 6.5 && middle(1) > -8.5) cells.push_back(cell);
  }
  Mesh part = mesh;
  part.cells = mesh.cells(cells, Eigen::all).eval();
  return part;
}

// A file per body: the mesh of 142 nodes; and per field, on a finer one.
void draw(const std::filesystem::path& folder, const SolvedScene& run, const SolvedScene& finer) {
  const double times = 200;                                                        // displacements
  const std::vector<double> stresses = {-24, -18, -15, -12, -10, -8, -6, -4, -2};  // [kPa]
  const std::vector<double> across = {-3e-4, -2e-4, -1e-4, -5e-5, -1e-5, 1e-5, 5e-5, 1e-4};  // [m]
  const std::vector<double> down = {-3e-3, -2.5e-3, -2e-3, -1.5e-3, -1e-3, -5e-4};
  const char* parts[] = {"_footing.csv", ".csv"};
  const std::vector<Index> under =
      boundary_nodes(run.model.bodies[1].mesh, "loaded");  // as the pairs
  const NodeArray moved =
      run.model.pairs.position + times * run.solution.displacements[1](under, Eigen::all);
  write_file(folder / "fig_13_1_arrows.csv",
             pressure_arrows_csv(moved, run.model.pairs.normal, run.solution.pressure));
  for (std::size_t k = 0; k < 2; ++k) {
    const BodyModel& body = finer.model.bodies[k];
    const NodeArray& u = finer.solution.displacements[k];
    const StressArray stress = nodal_stress(body.mesh, body.element, body.material, u);
    const Mesh part = near_the_footing(body.mesh);
    const auto write = [&](const char* name, const std::string& csv) {
      write_file(folder / text("fig_13_", name, parts[k]), csv);
    };
    const Mesh& coarse_mesh = run.model.bodies[k].mesh;
    write("1", deformed_cells_csv(coarse_mesh, run.solution.displacements[k],
                                  VectorXd::Zero(coarse_mesh.n_cells()), times));
    write("3_mesh", undeformed(part));
    write("3", deformed_bands_csv(part, u, stress.col(1), stresses, times));
    write("3_x", deformed_bands_csv(part, u, u.col(0), across, times));
    write("3_y", deformed_bands_csv(part, u, u.col(1), down, times));
  }
}

// The vertical stress on the axis, where it is largest.
void stress(Results& results) {
  const SolvedScene now = settle(fine, {2, 16});
  const BodyModel& soil = now.model.bodies[1];
  const StressArray nodes =
      nodal_stress(soil.mesh, soil.element, soil.material, now.solution.displacements[1]);
  const std::vector<Index> axis = boundary_nodes(soil.mesh, "axis");
  const double deepest = a / std::sqrt(2);  // where the closed form is largest
  const auto nearer = [&](Index one, Index other) {
    return std::abs(soil.mesh.nodes(one, 1) + deepest) <
           std::abs(soil.mesh.nodes(other, 1) + deepest);
  };
  const Index at = *std::min_element(axis.begin(), axis.end(), nearer);
  const double depth = -soil.mesh.nodes(at, 1);
  results.add("axis_depth", depth, "m");
  results.add("axis_stress", -nodes(at, 1), "kPa");
  results.add("axis_stress_closed_form", -rigid_strip_stress(strip, 0, depth)(1), "kPa");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch13_fields");
  stress(results);
  draw(run.out, settle(coarse, {}), settle(soil_of(10, 14, 14, 4, 15), {2, 6}));
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch13_fields", "Below the surface", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
