// Chapter 14 - Pictures of the rings under load: mesh and fields on the deformed bodies.
// Run:  make ch14     Reads: nothing     Writes: ch14_pictures.results, fig_14_1*.csv, fig_14_3*.csv, fig_14_5.csv
#include <cmath>
#include <filesystem>
#include <vector>

#include "papers/field_csv.hpp"
#include "readings.hpp"
#include "rings.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch14;

const double gap = paper.radii[2] - paper.radii[1];

// Figure 14.1, below: both rings under load, and the pressure between them.
void pressed(const std::filesystem::path& out, const SolvedScene& now) {
  for (const std::size_t k : {0, 1}) {
    const Mesh mesh = drawn(now.model.bodies[k].mesh, gap);
    const NodeArray& u = now.solution.displacements[k];
    write_file(out / text("fig_14_1_loaded_", mesh.name, ".csv"),
               deformed_cells_csv(mesh, u, Eigen::VectorXd::Zero(mesh.n_cells()), magnified));
  }
  const Pairs& pairs = now.model.pairs;
  const NodeArray moved =
      pairs.position + magnified * now.solution.displacements[0](pairs.node, Eigen::all);
  write_file(out / "fig_14_1_arrows.csv",
             pressure_arrows_csv(moved, pairs.normal, now.solution.pressure));
}

// Figure 14.1: the rims of the sketch and the cells of the mesh, with the magnified gap.
void sketch(const std::filesystem::path& out, const SolvedScene& now) {
  Table rims({"x", "y"});
  for (const BodyModel& body : now.model.bodies) {
    const Mesh mesh = drawn(body.mesh, gap);
    for (const char* rim : {"inner", "outer"}) {
      const double radius = mesh.nodes.row(boundary_nodes(mesh, rim).front()).norm();
      for (int k = 0; k <= 45; ++k)
        rims.row(
            {radius * std::cos(k * quarter_turn / 45), radius * std::sin(k * quarter_turn / 45)});
      rims.blank_line();
    }
    write_file(out / text("fig_14_1_", mesh.name, ".csv"),
               deformed_cells_csv(mesh, 0 * mesh.nodes, Eigen::VectorXd::Zero(mesh.n_cells())));
  }
  write_file(out / "fig_14_1.csv", rims.csv());
  pressed(out, now);
}

// Levels at equal distances, `steps` bands between them.
std::vector<double> levels(double first, double last, int steps) {
  std::vector<double> all;
  for (int k = 0; k <= steps; ++k) all.push_back(first + (last - first) * k / steps);
  return all;
}

// Figure 14.3: |u|, u_x, u_y and sigma_xx on the deformed rings, in bands.
void fields(const std::filesystem::path& out, const SolvedScene& now) {
  for (const std::size_t k : {0, 1}) {
    const BodyModel& body = now.model.bodies[k];
    const NodeArray& u = now.solution.displacements[k];
    const Mesh mesh = drawn(body.mesh, gap);
    const auto write = [&](const char* name, const Eigen::VectorXd& value,
                           const std::vector<double>& between) {
      write_file(out / text("fig_14_3_", name, "_", mesh.name, ".csv"),
                 deformed_bands_csv(mesh, u, value, between, magnified));
    };
    write("u", u.rowwise().norm(), levels(0.1, 0.3, 10));
    write("ux", u.col(0), levels(0, 0.3, 10));
    write("uy", u.col(1), levels(0, 0.3, 10));
    write("sxx", nodal_stress(body.mesh, body.element, body.material, u).col(0),
          levels(-200, 1100, 13));
    write_file(out / text("fig_14_3_", mesh.name, ".csv"),
               deformed_cells_csv(mesh, u, Eigen::VectorXd::Zero(mesh.n_cells()), /*scale*/ 0));
  }
}

// Figure 14.5: where the rims are around 40 degrees, before and after.
void meeting_rims(const std::filesystem::path& out, const SolvedScene& now) {
  Table rims({"x", "y", "x_moved", "y_moved"});
  for (const std::size_t body : {0, 1}) {
    const Mesh& mesh = now.model.bodies[body].mesh;
    const NodeArray& u = now.solution.displacements[body];
    for (const int ray : {3, 4, 5}) {
      const Index k = nearest(mesh, body == 0 ? 68 : 68.15, ray * quarter_turn / 9);
      rims.row({mesh.nodes(k, 0), mesh.nodes(k, 1), mesh.nodes(k, 0) + u(k, 0),
                mesh.nodes(k, 1) + u(k, 1)});
    }
    rims.blank_line();
  }
  write_file(out / "fig_14_5.csv", rims.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch14_pictures");
  const SolvedScene now = run_of(paper);
  sketch(run.out, now);
  fields(run.out, now);
  meeting_rims(run.out, now);
  results.add("u_largest", now.solution.displacements[0].rowwise().norm().maxCoeff(), "cm");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch14_pictures", "Pictures of the rings", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
