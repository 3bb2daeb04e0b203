// Chapter 4 - How the printed method ends on random problems, by the rows that make up QAS.
// Run:  make ch04     Reads: nothing     Writes: ch04_ends.results, ends.md, ends_by_size.md
// --full: ten times as many problems, a minute.
#include <algorithm>

#include "addons/programme/dense_programme.hpp"
#include "papers/examples.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "support/closest_point.hpp"
#include "which_rows.hpp"

namespace {

using namespace signorini;
using namespace ch04;

// 1. Only the tolerance, 1e-12, ends a loop at a limit; one that ends at a point comes from larger overlaps.
bool went_to_limit(const QuasiActiveRun& run) {
  const auto& history = run.state.report.history;
  const auto last = static_cast<std::size_t>(run.outer_steps) - 1;
  return run.outer_steps > 1 && history[last].penetration < 1e-6 * history[0].penetration;
}

// 2. How many runs ended how, in the order of the columns.
enum Column { One, Two, More, Optimal, AfterLastStep, Limit, LimitOptimal, Stopped };
using Ends = std::array<double, 8>;
using Tally = std::array<Ends, 4>;  // of the four choices

void count(Ends& ends, const QuasiActiveRun& run) {
  const SolveStatus status = run.state.report.status;
  if (status != SolveStatus::Solved && status != SolveStatus::Feasible) {
    ++ends[Stopped];
  } else if (went_to_limit(run)) {
    ++ends[Limit];
    ends[LimitOptimal] += status == SolveStatus::Solved ? 1 : 0;
  } else {
    ++ends[run.outer_steps <= 1 ? One : run.outer_steps == 2 ? Two : More];
    if (run.outer_steps <= 1) return;
    ends[Optimal] += run.optimal ? 1 : 0;
    ends[AfterLastStep] += status == SolveStatus::Solved ? 1 : 0;
  }
}

void count(Tally& tally, const ContactProblem& problem) {
  const auto run_with = [&](const Choice& choice) {
    return run_quasi_active_set_literal(problem, {}, choice.rows);
  };
  const QuasiActiveRun by_number = run_with(choices[1]);
  const bool one_method = std::all_of(  // all violated rows are independent: three choices are one
      by_number.steps.begin(), by_number.steps.end(),
      [](const QuasiActiveStep& step) { return step.quasi_active == step.violated; });
  for (const std::size_t i : {0, 2}) count(tally[i], one_method ? by_number : run_with(choices[i]));
  count(tally[1], by_number);
  count(tally[3], run_with(choices[3]));
}

void add_rows(Table& table, const std::string& problems, const Tally& tally) {
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<std::string> cells = {problems, choices[i].name};
    for (const double runs : tally[i]) cells.push_back(number(runs, "%.0f"));
    table.row(cells);
  }
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch04_ends");
  const std::uint64_t runs = run.full ? 1000 : 100;  // of a size
  Table table({"problems", "QAS", "one step", "two", "more", "of these optimal", "after (35)",
               "limit", "of these optimal", "stopped"});
  Table by_size = table;
  // 3. Eight half-spaces in small whole numbers, and the sizes of table 1.
  Tally whole{}, sizes{};
  Random random(1);
  for (std::uint64_t k = 0; k < 10 * runs; ++k)
    count(whole, signorini_test::eight_half_spaces(random).problem());
  add_rows(table, "whole numbers", whole);
  add_rows(by_size, "whole numbers", whole);
  for (const Eigen::Index n : {10, 20, 50})
    for (const Eigen::Index m : {n / 2, n, 2 * n, 4 * n}) {
      Tally size{};
      for (std::uint64_t seed = 1; seed <= runs; ++seed)
        count(size, condense(rosen_suzuki(n, m, seed).programme).problem);
      add_rows(by_size, text(n, ", ", m), size);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 8; ++k) sizes[i][k] += size[i][k];
    }
  add_rows(table, "sizes of table 1", sizes);
  write_file(run.out / "ends.md", table.markdown());
  write_file(run.out / "ends_by_size.md", by_size.markdown());

  double later = 0, optimal = 0, after = 0;
  for (const Ends& ends : whole) {
    later += ends[Two] + ends[More];
    optimal += ends[Optimal];
    after += ends[AfterLastStep];
  }
  results.add("whole_numbers", 10.0 * static_cast<double>(runs), "-");
  results.add("ended_later", later, "-");
  results.add("optimal_before", 100 * optimal / later, "%");
  results.add("optimal_after", 100 * after / later, "%");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch04_ends", "How loops end", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
