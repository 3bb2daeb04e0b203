// Chapter 5 - Random programmes (Xuan & Li 2002, sec. 4, example 1, table 1).
// Run:  make ch05     Reads: nothing     Writes: ch05.results, table.md, larger.md, growth.md, fathi.md,
//                                statuses.md, fig_5_1.csv, fig_5_2.csv, fig_5_2_punch.csv, fig_5_3.csv
#include <algorithm>
#include <cmath>
#include <iostream>

#include "../../tests/reference/rosen_suzuki_table_1.hpp"
#include "judge.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/examples.hpp"
#include "signorini/report/program.hpp"
#include "signorini/solvers/lemke.hpp"

namespace {

using namespace signorini;
using namespace ch05;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
const char* const ours = "quasi_active_set";

// 1. The construction: choose the solution first, then the load and the gaps that make it one.
// [backwards]
KnownProgramme backwards(const MatrixXd& K, const MatrixXd& A, const VectorXd& u,
                         const VectorXd& force, const VectorXd& gap) {
  const VectorXd p = K * u + A.transpose() * force;  // equilibrium
  const VectorXd g = A * u + gap;                    // gap = g - A u
  return {{K, p, A, g}, u, force, 0.5 * u.dot(K * u) - p.dot(u)};
}
// [backwards]

// 2. Table 1: every size with five seeds, medians.
// [table]
void table_1(const ProgramOptions& run, Results& results) {
  Table table({"$`n`$", "$`m`$", "closed", "Lemke: pivots", "Goldfarb-Idnani: steps", "ours: steps",
               "ours: factorisations", "paper: $`f_P/f_L - 1`$",
               "ours: $`\\lvert f/f^* - 1\\rvert`$", "certificate ≤ 1e-12"});
  Table deviations({"place", "n", "m", "paper", "ours"});
  Table times({"n", "m", "Lemke / ours", "in the paper"});
  int below_zero = 0;
  for (const reference::RandomProgramme& line : reference::table_1) {
    std::vector<Run> lemke, single, group;
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
      const KnownProgramme known = rosen_suzuki(line.n, line.m, seed);
      lemke.push_back(timed(known, "lemke"));
      single.push_back(judged(known, "goldfarb_idnani"));
      group.push_back(timed(known, ours));
      below_zero += known.energy < 0 ? 1 : 0;
    }
    // [table]
    const double worst = worst_deviation(group);
    const std::string n = std::to_string(line.n);
    const std::string m = std::to_string(line.m);
    table.row({n, m, number(median(group, &Run::closed)), number(median(lemke, &Run::steps)),
               number(median(single, &Run::steps)), number(median(group, &Run::steps)),
               number(median(group, &Run::factorisations)), number(line.ratio - 1, "%+.1e"),
               worst < 1e-13 ? "< 1e-13" : number(worst, "%.0e"), "yes"});
    deviations.row({number(static_cast<double>(&line - reference::table_1.data())), n, m,
                    number(std::abs(line.ratio - 1)), number(std::max(worst, 1e-16))});
    const double ratio = median(lemke, &Run::seconds) / median(group, &Run::seconds);
    times.row(
        {n, m, number(ratio, "%.2f"), number(line.lemke_seconds / line.paper_seconds, "%.2f")});
    results.add(text("lemke_over_ours_", n, '_', m), ratio, "-", Repeats::No);
  }
  write_file(run.out / "table.md", table.markdown());
  write_file(run.out / "fig_5_1.csv", deviations.csv("rel 1e-6 abs 1e-11"));
  std::cout << times.markdown();
  results.add("energies_below_zero", below_zero, "-");
}

// 3. The clock behind the paper's times: 1193182 / 65536 ticks a second.
// [clock]
void clock_of_the_paper(Results& results) {
  const double tick = 65536.0 / 1193182.0;  // [s]
  int times = 0;
  int near_ticks = 0;
  int in_256ths = 0;
  int slower = 0;
  for (const reference::RandomProgramme& line : reference::table_1) {
    slower += line.paper_seconds > line.lemke_seconds ? 1 : 0;
    for (const double t : {line.lemke_seconds, line.paper_seconds}) {
      ++times;
      near_ticks += std::abs(t / tick - std::round(t / tick)) < 0.15 ? 1 : 0;
      in_256ths += std::abs(t - std::round(256 * t) / 256) < 0.51e-4 ? 1 : 0;  // 4 decimals printed
    }
  }
  // [clock]
  results.add("clock_tick", 1000 * tick, "ms");
  results.add("printed_times", times, "-");
  results.add("times_near_ticks", near_ticks, "-");
  results.add("times_in_256ths", in_256ths, "-");
  results.add("paper_slower", slower, "-");
}

// 4. Larger programmes.
void larger(const ProgramOptions& run, Results& results) {
  Table table({"$`n`$", "$`m`$", "closed", "steps", "factorisations", "certificate ≤ 1e-12"});
  for (const auto& [n, m] : {std::pair(200, 200), std::pair(200, 800), std::pair(500, 500)}) {
    const Run one = judged(rosen_suzuki(n, m, 1), ours);
    table.row({std::to_string(n), std::to_string(m), number(one.closed), number(one.steps),
               number(one.factorisations), "yes"});
  }
  write_file(run.out / "larger.md", table.markdown());
  if (!run.full) return;
  const Run one = timed(rosen_suzuki(1000, 4000, 1), ours);
  results.add("steps_1000_4000", one.steps, "-", Repeats::No);
  results.add("factorisations_1000_4000", one.factorisations, "-", Repeats::No);
  results.add("seconds_1000_4000", one.seconds, "s", Repeats::No);
}

// 5. Cost against the number of candidates: y ~ x^exponent, least squares in the logarithms.
// [growth]
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const auto size = static_cast<Index>(x.size());
  Eigen::ArrayXd a = Eigen::Map<const Eigen::ArrayXd>(x.data(), size).log();
  Eigen::ArrayXd b = Eigen::Map<const Eigen::ArrayXd>(y.data(), size).log();
  a -= a.mean();
  b -= b(0);  // exactly zero if y does not change
  return (a * b).sum() / a.square().sum();
}
// [growth]

template <typename Make>
std::vector<std::string> growth(const ProgramOptions& run, const std::string& family,
                                const Make& make, Results& results) {
  const std::vector<double> sizes = {25, 50, 100, 200, 400};
  const std::string names[] = {"lemke", "goldfarb_idnani", "steps", "factorisations"};
  Table curve({"pairs", names[0], names[1], names[2], names[3]});
  std::vector<double> y[6];
  for (const double size : sizes) {
    const auto problem = make(static_cast<Index>(size));
    const Run pivoting = timed(problem, "lemke");
    const Run grouping = timed(problem, ours);
    const double values[] = {pivoting.steps,   judged(problem, "goldfarb_idnani").steps,
                             grouping.steps,   grouping.factorisations,
                             pivoting.seconds, grouping.seconds};
    for (int k = 0; k < 6; ++k) y[k].push_back(values[k]);
    curve.row({size, values[0], values[1], values[2], values[3]});
  }
  write_file(run.out / (family == "random" ? "fig_5_2.csv" : "fig_5_2_punch.csv"), curve.csv());
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

// 6. The problems that make complementary pivoting take every basis.
// [fathi]
void all_bases(const ProgramOptions& run, Results& results) {
  Table table({"$`n`$", "bases", "Lemke: pivots", "rows scaled first", "Goldfarb-Idnani: steps",
               "ours: steps"});
  Table curve({"n", "lemke", "scaled", "steps"});
  for (Index n = 2; n <= 10; ++n) {
    const ContactProblem problem = fathi(n);
    const ContactState found = lemke(problem, VectorXd::Ones(n));
    const double pivots = certified(found, certify(problem, found), 0).steps;
    if (pivots != std::ldexp(1, static_cast<int>(n))) throw NotSolved("not 2^n pivots");
    const double scaled = judged(problem, "lemke").steps;
    const double steps = judged(problem, ours).steps;
    // [fathi]
    table.row({static_cast<double>(n), std::ldexp(1, static_cast<int>(n)), pivots, scaled,
               judged(problem, "goldfarb_idnani").steps, steps});
    curve.row({static_cast<double>(n), pivots, scaled, steps});
    if (n == 10) results.add("fathi_10_pivots", pivots, "-");
  }
  write_file(run.out / "fathi.md", table.markdown());
  write_file(run.out / "fig_5_3.csv", curve.csv());
  const ContactState asymmetric = lemke(murty(10));
  results.add("murty_10_pivots", certified(asymmetric, {}, 0).steps, "-");
}

// 7. Harder programmes, and what each solver says of them.
// [hard]
void statuses(const ProgramOptions& run, Results& results) {
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
  // [hard]
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
}

Status chapter(const ProgramOptions& run) {
  Results results("ch05");
  table_1(run, results);
  clock_of_the_paper(results);
  larger(run, results);
  Table table(
      {"family", "Lemke: pivots", "Goldfarb-Idnani: steps", "ours: steps", "ours: factorisations"});
  table.row(growth(
      run, "random", [](Index m) { return rosen_suzuki(50, m, 1); }, results));
  table.row(growth(run, "punch", punch, results));
  write_file(run.out / "growth.md", table.markdown());
  all_bases(run, results);
  statuses(run, results);
  results.headline("fathi_10_pivots", 1024, "2^10 bases");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch05", "Random programmes", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}
