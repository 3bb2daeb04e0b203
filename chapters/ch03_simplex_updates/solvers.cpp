// Chapter 3 - The rules as solvers: a guess of the closed pairs is confirmed exactly, or dropped.
// Run:  make ch03     Reads: nothing     Writes: solvers.md, solvers_random.md
#include <iostream>

#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "three_problems.hpp"

namespace {

using namespace ch03;

SolveStatus chapter(const ProgramOptions& run) {
  const std::vector<Named> problems = three_problems();
  Table half_plane({"rule", "ends as", "iterations", "factorisations", "closed"});
  Table random({"problem", "rule", "ends as", "iterations", "factorisations", "closed"});
  for (const auto& [name, problem] : problems)
    for (const Rule& rule : rules) {
      const ContactState state = surrogate_dual(problem, rule.rule);
      const bool solved = state.report.status == SolveStatus::Solved;
      std::vector<std::string> row = {rule.name, to_string(state.report.status),
                                      std::to_string(state.report.iterations),
                                      std::to_string(state.report.factorisations),
                                      solved ? std::to_string(state.active().size()) : "–"};
      if (&problem == &problems.front().problem) {
        half_plane.row(row);
      } else {
        row.insert(row.begin(), name);
        random.row(row);
      }
    }
  write_file(run.out / "solvers.md", half_plane.markdown());
  write_file(run.out / "solvers_random.md", random.markdown());
  std::cout << half_plane.markdown();
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch03_solvers", "The rules as solvers", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
