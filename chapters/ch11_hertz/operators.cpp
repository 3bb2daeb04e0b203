// Chapter 11 - Three operators, the forces of Gauss points lumped to nodes: where meshes match and where not.
// Run:  make ch11     Reads: nothing     Writes: ch11_operators.results, operators.md, fig_11_2_nts.csv
#include <iostream>

#include "hertz_run.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace {

using namespace signorini;

struct Operator {
  const char* name;
  int points;
};

HertzRun solve_with(const Operator& one, bool match) {
  HertzCase now = match ? HertzCase{} : not_matching();
  now.gap_operator = one.name;
  now.points = one.points;
  now.solver = quasi_active_set();  // takes gaps that depend on each other
  return solve_hertz(now);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch11_operators");
  Table table({"operator", "meshes", "pairs", "q0 [%]", "b [%]", "rms p [%]"});
  for (const bool match : {true, false})
    for (const Operator& one : {Operator{"mortar", 0},
                                {"node_to_segment", 0},
                                {"gauss_points", 1},
                                {"gauss_points", 2}}) {
      const HertzRun out = solve_with(one, match);
      if (!match)
        results.add(text("rms_", one.name, "_", one.points), pressure_error(out), "%");
      table.row({one.points > 0 ? text(one.name, ", ", one.points) : one.name,
                 match ? "match" : "do not", std::to_string(out.run.model.pairs.weight.size()),
                 percent(out.q_error), percent(out.b_error), number(pressure_error(out), "%.2f")});
    }
  std::cout << table.markdown();
  write_file(run.out / "operators.md", table.markdown());
  HertzCase bumpy = not_matching();
  bumpy.gap_operator = "node_to_segment";
  write_file(run.out / "fig_11_2_nts.csv", nodal_pressures(solve_hertz(bumpy)));
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11_operators", "Three operators", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
