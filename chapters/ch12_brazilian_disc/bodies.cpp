// Chapter 12 - Meshes, stress and displacements drawn.
// Run:  make ch12     Reads: nothing     Writes: fig_12_1*.csv, fig_12_2*.csv, fig_12_3*.csv

#include "papers/field_csv.hpp"
#include "scene.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch12;

// A file per body and field, of the first mesh in the table of meshes.
void draw(const std::filesystem::path& folder) {
  const double times = 50;  // displacements of figure 12.3
  const std::vector<double> stresses = {-12, -6, -3, -1, -0.3, -0.1, 0, 0.1, 0.2};     // [MPa]
  const std::vector<double> across = {-0.002, -0.001, 0, 0.001, 0.002, 0.003, 0.004};  // [mm]
  const std::vector<double> along = {-0.08,  -0.065, -0.06, -0.055, -0.05,
                                     -0.045, -0.04,  -0.03, -0.01};
  const SolvedScene run = solve_disc(for_middle, 0.5);
  const char* parts[] = {".csv", "_lower.csv", "_upper.csv"};
  for (std::size_t k = 0; k < 3; ++k) {
    const BodyModel& body = run.model.bodies[k];
    const Mesh& mesh = body.mesh;
    const NodeArray& u = run.solution.displacements[k];
    const StressArray stress = nodal_stress(mesh, body.element, body.material, u);
    const auto write = [&](const char* name, const std::string& csv) {
      write_file(folder / text("fig_12_", name, parts[k]), csv);
    };
    const std::string undeformed =
        deformed_cells_csv(mesh, u, Eigen::VectorXd::Zero(mesh.n_cells()), 0);
    write("1", undeformed);
    write("2", deformed_bands_csv(mesh, u, stress.col(0), stresses));
    write("2_mesh", undeformed);
    write("3_x", deformed_bands_csv(mesh, u, u.col(0), across, times));
    write("3_y", deformed_bands_csv(mesh, u, u.col(1), along, times));
    write("3_mesh", undeformed);
  }
}

SolveStatus chapter(const ProgramOptions& run) {
  draw(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch12_bodies", "The bodies drawn", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
