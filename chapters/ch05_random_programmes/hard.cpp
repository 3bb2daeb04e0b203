// Chapter 5 - Harder programmes, and what each solver says of them.
// Run:  make ch05     Reads: nothing     Writes: ch05_hard.results, statuses.md
#include <utility>

#include "judge.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch05;
using Eigen::Index;
using Eigen::MatrixXd;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch05_hard");
  const KnownProgramme base = rosen_suzuki(10, 20, 1);
  const auto& [K, p, A, g, equations] = base.programme;
  const VectorXd gap = g - A * base.displacement;
  MatrixXd twice(40, 10);
  VectorXd force(40), gaps(40);
  twice << A, A;
  force << base.force, base.force;
  gaps << gap, gap;
  VectorXd stretch(10);
  for (Index i = 0; i < 10; ++i) stretch(i) = std::pow(10, static_cast<double>(i) - 4.5);
  const MatrixXd uneven = stretch.asDiagonal() * K * stretch.asDiagonal();
  DenseProgramme contradicting = base.programme;  // row 1 also with its sign and its gap turned
  contradicting.A.row(1) = -A.row(0);
  contradicting.initial_gap(1) = -g(0) - 1;
  const KnownProgramme many = rosen_suzuki(10, 200, 1);
  const std::pair<const char*, DenseProgramme> hard[] = {
      {"every row twice", backwards(K, twice, base.displacement, force, gaps).programme},
      {"200 rows, 10 unknowns", many.programme},
      {"entries of $`K`$ from 1e-9 to 1e9",
       backwards(uneven, A, base.displacement, base.force, gap).programme},
      {"two rows that contradict each other", contradicting}};
  Table table({"solver", hard[0].first, hard[1].first, hard[2].first, hard[3].first});
  for (const char* name :
       {ours, "goldfarb_idnani", "lemke", "primal_dual_active_set", "projected_gauss_seidel"}) {
    std::vector<std::string> row = {text('`', name, '`')};
    for (const auto& [title, programme] : hard)
      row.push_back(to_string(solve(programme, find_solver(name)).report.status));
    table.row(row);
  }
  write_file(run.out / "statuses.md", table.markdown());
  const VectorXd free_gap = condense(many.programme).problem.free_gap;
  results.add("violated_10_200", static_cast<double>((free_gap.array() < 0).count()), "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch05_hard", "Harder programmes", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
