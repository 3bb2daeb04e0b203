// Chapter 5 - How the counts grow with the number of pairs, and what they cost.
// Run:  make ch05     Reads: nothing     Writes: ch05_counts.results, growth.md, larger.md, fig_5_2.csv, fig_5_2_punch.csv
// --full: a programme of 1000 unknowns with 4000 rows, seconds.
#include <utility>

#include "judge.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch05;
using Eigen::Index;

// 1. Cost against the number of candidates: y ~ x^exponent, least squares in the logarithms.
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const auto size = static_cast<Index>(x.size());
  Eigen::ArrayXd a = Eigen::Map<const Eigen::ArrayXd>(x.data(), size).log();
  Eigen::ArrayXd b = Eigen::Map<const Eigen::ArrayXd>(y.data(), size).log();
  a -= a.mean();
  b -= b(0);  // exactly zero if y does not change
  return (a * b).sum() / a.square().sum();
}

template <typename Make>
std::vector<std::string> growth(const ProgramOptions& run, const std::string& family,
                                const Make& make, Results& results) {
  const std::vector<double> sizes = {25, 50, 100, 200, 400};
  const std::string names[] = {"lemke", "goldfarb_idnani", "steps", "factorisations"};
  Table curve({"pairs", names[0], names[1], names[2], names[3]});
  std::vector<double> y[6];
  int right = 0;
  for (const double size : sizes) {
    const auto problem = make(static_cast<Index>(size));
    const Run pivoting = timed(problem, "lemke");
    const Run grouping = timed(problem, ours);
    const Run single = judged(problem, "goldfarb_idnani");
    for (const Run& one : {pivoting, grouping, single}) right += one.right ? 1 : 0;
    const double values[] = {pivoting.steps,          single.steps,     grouping.steps,
                             grouping.factorisations, pivoting.seconds, grouping.seconds};
    for (int k = 0; k < 6; ++k) y[k].push_back(values[k]);
    curve.row({size, values[0], values[1], values[2], values[3]});
  }
  write_file(run.out / (family == "random" ? "fig_5_2.csv" : "fig_5_2_punch.csv"), curve.csv());
  results.add(family + "_right_runs", right, "-");
  std::vector<std::string> cells = {family};
  for (int k = 0; k < 4; ++k) {
    const double power = exponent(sizes, y[k]);
    results.add(text(family, "_exponent_", names[k]), power, "-");
    cells.push_back(text(y[k].front(), " → ", y[k].back(), ", ", number(power, "%.2f")));
  }
  results.add(family + "_exponent_lemke_seconds", exponent(sizes, y[4]), "-", Repeats::No);
  results.add(family + "_exponent_seconds", exponent(sizes, y[5]), "-", Repeats::No);
  results.add(family + "_lemke_over_ours_400", y[4].back() / y[5].back(), "-", Repeats::No);
  return cells;
}

ContactProblem punch(Index pairs) {  // a little off the middle, so that no two pairs are alike
  Indentation made = half_plane_indentation(pairs);
  made.problem.free_gap -= 0.05 * made.position;
  return made.problem;
}

// 2. Larger programmes.
void larger(const ProgramOptions& run, Results& results) {
  Table table({"$`n`$", "$`m`$", "closed", "steps", "factorisations", "certificate ≤ 1e-12"});
  for (const auto& [n, m] : {std::pair(200, 200), std::pair(200, 800), std::pair(500, 500)}) {
    const Run one = judged(rosen_suzuki(n, m, 1), ours);
    table.row({std::to_string(n), std::to_string(m), number(one.closed), number(one.steps),
               number(one.factorisations), one.right ? "yes" : "no"});
    results.add(text("steps_", n, '_', m), one.steps, "-");
  }
  write_file(run.out / "larger.md", table.markdown());
  if (!run.full) return;
  const Run one = timed(rosen_suzuki(1000, 4000, 1), ours);
  results.add("steps_1000_4000", one.steps, "-", Repeats::No);
  results.add("factorisations_1000_4000", one.factorisations, "-", Repeats::No);
  results.add("seconds_1000_4000", one.seconds, "s", Repeats::No);
}

// 3. Two families: random programmes of 50 unknowns, and the punch.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch05_counts");
  Table table(
      {"family", "Lemke: pivots", "Goldfarb-Idnani: steps", "ours: steps", "ours: factorisations"});
  table.row(growth(
      run, "random", [](Index m) { return rosen_suzuki(50, m, 1); }, results));
  table.row(growth(run, "punch", punch, results));
  write_file(run.out / "growth.md", table.markdown());
  larger(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch05_counts", "Counts and their price", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
