// Chapter 13 - The rigid strip footing (Lin et al., sec. 3.3): forces of the nodes against (46).
// Run:  make ch13     Reads: nothing     Writes: ch13.results, nodes.md, meshes.md, fig_13_2*.csv
#include <iostream>

#include "base.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch13;

// Forces of the nodes against (46), node by node.
void nodal_forces(const ProgramOptions& run, Results& results) {
  Table nodes({"x [m]", "force [kN/m]", "(46) [kN/m]", "deviation [%]"});
  Table meshes({"nodes", "W = H [m]", "elastic footing [%]", "rigid footing [%]", "corner node [%]",
                "next to it [%]"});
  for (const auto& [soil, rows] : {std::pair(coarse, 4), {medium, 12}, {fine, 16}}) {
    const SolvedScene now = settle(soil, {2, rows});
    const Base base = base_of(now);
    const VectorXd off = base.deviation();
    const Index n = off.size(), all = soil.n_nodes() + n * (rows + 1);
    const Base never_bends = rigid_base(soil);
    const double rigid = never_bends.worst();
    meshes.row({std::to_string(all), number(soil.depth), percent(base.worst()), percent(rigid),
                percent(off(n - 1)), percent(off(n - 2))});
    const std::string name = text("fig_13_2", soil.depth == coarse.depth ? "_142" : "", ".csv");
    write_file(run.out / name, table_of({{"x", base.position},
                                         {"pressure", base.pressure() / q},
                                         {"from_edge", a - base.piece.array()},
                                         {"deviation", 100 * off}})
                                   .csv("rel 1e-6 abs 1e-6"));
    results.add(text("worst_", all), 100 * base.worst(), "%");
    results.add(text("worst_rigid_", all), 100 * rigid, "%");
    results.add(text("corner_", all), 100 * off(n - 1), "%");
    results.add(text("middle_", all), 1 + never_bends.deviation()(0), "-");
    if (soil.depth != coarse.depth) continue;
    for (Index k = 0; k < n; ++k)
      nodes.row({number(base.position(k), "%.3f"), number(base.force(k), "%.4f"),
                 number(base.share(k), "%.4f"), percent(off(k))});
    results.add("corner_pressure", now.solution.pressure.maxCoeff() / q, "q");
    results.add("settlement", 1000 * base.settlement, "mm");
  }
  std::cout << meshes.markdown();
  write_file(run.out / "nodes.md", nodes.markdown());
  write_file(run.out / "meshes.md", meshes.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch13");
  nodal_forces(run, results);
  results.add("mean_pressure", mean_pressure, "kPa");
  results.headline("middle_9948", 1, "(46)");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch13", "The rigid strip footing", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
