// Chapter 7 - A rigid pin in an elastic plate (Xuan & Li 2002, sec. 4, example 3).
// Run:  make ch07     Reads: nothing     Writes: ch07.results, nodes.md, fig_7_1_*.csv, fig_7_2_paper.csv,
//                                                fig_7_3_*.csv, ch07.vtu
#include <iostream>

#include "addons/vtu/vtu.hpp"
#include "papers/field_csv.hpp"
#include "papers/zero_line_csv.hpp"
#include "pin.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch07;

// 1. Forces and pressures at the paper's candidates.
void pressures(const ProgramOptions& run, const Bearing& t, const Bearing& c) {
  const auto first = Eigen::seqN(0, 12);
  const Table nodes = table_of({{"θ [deg]", t.theta(first), "%.2f"},
                                {"force (T) [kN]", t.force(first), "%.3f"},
                                {"pressure (T) [kN/cm²]", t.pressure(first), "%.2f"},
                                {"force (C) [kN]", c.force(first), "%.3f"},
                                {"pressure (C) [kN/cm²]", c.pressure(first), "%.2f"}});
  const Table curve =
      table_of({{"theta", t.theta(first)}, {"t", t.pressure(first)}, {"c", c.pressure(first)}});
  std::cout << nodes.markdown();
  write_file(run.out / "nodes.md", nodes.markdown());
  write_file(run.out / "fig_7_2_paper.csv", curve.csv("rel 1e-6 abs 1e-8"));
}

// 2. The plate before and after loading, and the stress along x.
void draw(const std::filesystem::path& folder, const std::string& name, const Bearing& bearing) {
  const SolvedScene& run = bearing.run;
  const BodyModel& body = run.model.bodies[0];
  const NodeArray& u = run.solution.displacements[0];
  const VectorXd stress = cell_stress(body.mesh, body.element, body.material, u).col(0);
  const VectorXd at_nodes = nodal_stress(body.mesh, body.element, body.material, u).col(0);
  const auto write = [&](const char* figure, const char* end, const std::string& csv) {
    write_file(folder / text("fig_7_", figure, name, end), csv);
  };
  write("1_", ".csv", deformed_cells_csv(body.mesh, u, stress, 0));
  write("3_", ".csv", deformed_cells_csv(body.mesh, u, stress));
  write("3_", "_zero.csv", deformed_zero_line_csv(body.mesh, u, at_nodes));
  std::vector<Index> hole = boundary_nodes(body.mesh, "hole");  // from the left to the right
  if (name == "c") std::reverse(hole.begin(), hole.end());
  const NodeArray before = body.mesh.nodes(hole, Eigen::all);
  write("3_", "_arrows.csv",
        pressure_arrows_csv(before + u(hole, Eigen::all), before / hole_radius, bearing.pressure));
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch07");
  const Bearing t = on_paper_mesh(tension), c = on_paper_mesh(compression);
  pressures(run, t, c);
  write_vtu(run.out / "ch07.vtu", t.run.model, t.run.solution);
  for (const auto& [name, now] : {std::pair("t", &t), std::pair("c", &c)}) {
    draw(run.out, name, *now);
    results.add(text("resultant_", name), now->resultant, "kN/cm");
    results.add(text("right_", name), now->right, "cm");
  }
  const Mesh& mesh = t.run.model.bodies[0].mesh;
  results.add("mesh_cells", static_cast<double>(mesh.n_cells()), "-");
  results.add("mesh_nodes", static_cast<double>(mesh.n_nodes()), "-");
  results.headline("resultant_t", -tension.q * plate_size, "balance: the load of the right side");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch07", "A rigid pin in an elastic plate", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
