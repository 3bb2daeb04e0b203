// Chapter 5 - The problems on which Lemke's method visits every basis there is.
// Run:  make ch05     Reads: nothing     Writes: ch05_every_basis.results, fathi.md, fig_5_3.csv
#include "judge.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/lemke.hpp"

namespace {

using namespace ch05;
using Eigen::Index;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch05_every_basis");
  Table table({"pairs", "bases", "Lemke: pivots", "rows scaled first", "Goldfarb-Idnani: steps",
               "ours: steps"});
  Table curve({"n", "lemke", "scaled", "steps"});
  int right = 0;
  for (Index n = 2; n <= 10; ++n) {
    const ContactProblem problem = fathi(n);
    const ContactState found = lemke(problem, VectorXd::Ones(n));
    const Run unscaled = counted(found.report, found.active().size(), certify(problem, found), 0);
    const Run scaled = judged(problem, "lemke");
    const Run single = judged(problem, "goldfarb_idnani");
    const Run group = judged(problem, ours);
    for (const Run& one : {unscaled, scaled, single, group}) right += one.right ? 1 : 0;
    table.row({static_cast<double>(n), std::ldexp(1, static_cast<int>(n)), unscaled.steps,
               scaled.steps, single.steps, group.steps});
    curve.row({static_cast<double>(n), unscaled.steps, scaled.steps, group.steps});
    if (n == 10) results.add("fathi_10_pivots", unscaled.steps, "-");
  }
  results.add("fathi_right_runs", right, "-");
  write_file(run.out / "fathi.md", table.markdown());
  write_file(run.out / "fig_5_3.csv", curve.csv());
  const ContactState asymmetric = lemke(murty(10));
  results.add("murty_10_pivots", static_cast<double>(asymmetric.report.iterations), "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch05_every_basis", "Every basis there is", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
