// Chapter 4 - The quasi-active-set iteration (Xuan & Li 2002, secs. 2.3 and 3, eqs. 30-39).
// Run:  make ch04     Reads: nothing     Writes: ch04.results, fig_4_1.csv, fig_4_2.csv, fig_4_3.csv, zigzag.md,
//                 two_steps.md, last_step.md, bodies.md, ends.md, ends_by_size.md, sizes.md
#include <algorithm>
#include <array>
#include <cmath>

#include "cases.hpp"
#include "readings.hpp"
#include "signorini/as_printed/quasi_active_set_literal.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/examples.hpp"
#include "signorini/report/program.hpp"
#include "sizes.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

void agree(const VectorXd& got, const VectorXd& expected, double accuracy, const char* what) {
  if ((got - expected).norm() > accuracy) throw NotSolved(text(what, ": not what it should be"));
}

// 1. The outer loop: (37) all violated rows, (38)-(39) their problem, (36) the minimum moved.
// [zigzag]
void zigzag(const ProgramOptions& run, Results& results) {
  Table table({"k", "u", "violated row", "η"});
  Table path({"x", "y"});
  exact::Rows way;
  exact::Vector u = corner.p;  // u^0
  for (Index k = 0; k <= 10; ++k) {
    path.row({u[0].value(), u[1].value()});
    const exact::Set violated = rows_with(corner, u, -1);       // VIO, all of it is QAS
    const exact::Rest next = closest(corner, violated, u);      // (38), with the minimum at u
    const exact::Fraction eta = next.force[0] + next.force[1];  // (39)
    if (k <= 6)
      table.row({std::to_string(k), text_of(u), std::to_string(violated.at(0) + 1), eta.text()});
    u = next.u;  // (36)
    way.push_back(u);
  }
  // [zigzag]
  const DenseProgramme q = floating(corner);
  for (Index k = 0; k <= 10; ++k) {
    SolverOptions stop;
    stop.iteration_limit = k + 1;
    const VectorXd end = displacement(q, quasi_active_set_literal(condensed(q), stop));
    agree(end, floating(way[static_cast<std::size_t>(k)]), 1e-15, "the zigzag");
  }
  write_file(run.out / "zigzag.md", table.markdown());
  write_file(run.out / "fig_4_2.csv", path.csv());
  results.add("zigzag_steps",
              static_cast<double>(run_quasi_active_set_literal(condensed(q)).outer_steps), "-");
}

// 2. The last step (33)-(35), which the paper calls optimal.
// [last]
struct LastStep {
  exact::Rest next;  // u^{k+1}
  exact::Fraction delta = 1;
  exact::Vector end;  // u*
};

LastStep last_step(const exact::Programme& q, const exact::Vector& u) {
  LastStep step;
  step.next = closest(q, rows_with(q, u, 0), q.p);  // (33)
  const exact::Vector way = exact::along(step.next.u, -1, u);
  for (const std::size_t i : rows_with(q, step.next.u, -1)) {
    const exact::Fraction ratio = gap(q, i, u) / dot(q.A[i], way);  // (34)
    step.delta = ratio < step.delta ? ratio : step.delta;
  }
  step.end = exact::along(u, step.delta, way);  // (35)
  return step;
}
// [last]

// 3. Three rows in a plane: loops that leave violated rows out end after two steps.
QuasiActiveRun two_steps(const ProgramOptions& run, Results& results) {
  Table table({"QAS", "its rows", "u¹", "its rows", "u²", "end of (35)"});
  QuasiActiveRun by_number;
  for (const Reading& reading : readings) {
    const QuasiActiveRun way =
        run_quasi_active_set_literal(condensed(floating(fan)), {}, reading.rows);
    std::vector<std::string> cells{reading.name};
    exact::Vector u = fan.p;
    for (const QuasiActiveStep& step : way.steps) {
      if (exact_set(step.violated) != rows_with(fan, u, -1))
        throw NotSolved("three rows: other rows are violated");
      u = closest(fan, exact_set(step.quasi_active), u).u;
      cells.push_back(text_of(exact_set(step.quasi_active)));
      cells.push_back(text_of(u));
    }
    cells.resize(5);
    const LastStep last = last_step(fan, u);
    cells.push_back(text_of(last.end));
    table.row(cells);
    agree(displacement(floating(fan), way.state), floating(last.end), 1e-15, "three rows");
    if (reading.rows == QuasiActiveRows::IndependentByIndex) {
      by_number = way;
      results.add("two_steps_excess", (energy(fan, u) - energy(fan, last.end)).value(), "-");
    }
  }
  write_file(run.out / "two_steps.md", table.markdown());
  return by_number;
}

// 4. Four walls in space, where the last step does not end at the optimum.
void four_walls_in_space(const ProgramOptions& run, Results& results) {
  const exact::Programme& q = four_walls;
  const exact::Vector limit = exact::along({1, 1, 1}, {1, 50}, {6, 3, -1});  // on rows 3 and 4
  const auto [next, delta, end] = last_step(q, limit);
  const exact::Rest held = close(q, rows_with(q, end, 0), q.p);  // the rows that are tight there
  const exact::Rest best = closest(q, {0, 1, 2, 3}, q.p);
  const DenseProgramme floats = floating(q);
  const QuasiActiveRun way = run_quasi_active_set_literal(condensed(floats));
  const DenseSolution repaired = solve(floats, find_solver("quasi_active_set"));
  if (way.state.report.status != Status::Feasible || repaired.report.status != Status::Solved)
    throw NotSolved("four walls: the literal method should fail, the repaired one should not");
  agree(displacement(floats, way.state), floating(end), 1e-9, "the last step");
  agree(repaired.refined.displacement, floating(best.u), 1e-14, "the repaired method");
  Table table({"", "u", "energy", "forces of the rows"});
  table.row({"(33)", text_of(next.u), energy(q, next.u).text(), text_of(next.force)});
  table.row({"(35)", text_of(end), energy(q, end).text(), text_of(held.force)});
  table.row({"optimum", text_of(best.u), energy(q, best.u).text(), text_of(best.force)});
  write_file(run.out / "last_step.md", table.markdown());
  SolverOptions stop;
  stop.iteration_limit = way.outer_steps - 1;
  const VectorXd u = displacement(floats, quasi_active_set_literal(condensed(floats), stop));
  for (const Index i : {0, 1, 2}) results.add(text("limit_", i + 1), u(i), "-");
  results.add("last_step_energy", energy(q, end).value(), "-");
  results.add("last_step_excess", (energy(q, end) - energy(q, best.u)).value(), "-");
  results.add("last_step_bound", energy_gap(way.state), "-");
  const VectorXd& v = repaired.refined.displacement;
  results.add("repaired_energy", 0.5 * v.dot(v) - floats.load.dot(v), "-");
  results.add("repaired_steps", static_cast<double>(repaired.report.iterations), "-");
  results.headline("repaired_energy", energy(q, best.u).value(), "-395/98, exact fractions");
}

// 5. Contact of bodies: the block of chapter 1, the cantilever of chapter 6, a half-plane.
QuasiActiveRun bodies(const ProgramOptions& run) {
  Table table({"body", "pairs", "overlapping at u⁰", "closed", "k", "status", "smallest coupling",
               "k, one row at a time", "its status"});
  QuasiActiveRun block;
  const std::pair<const char*, ContactProblem> all[] = {
      {"block, chapter 1", block_on_obstacle()},
      {"cantilever, chapter 6", cantilever()},
      {"half-plane, round punch", half_plane_indentation(200).problem}};
  for (const auto& [name, problem] : all) {
    const auto runs = run_readings(problem);
    const QuasiActiveRun& way = runs[0];
    const VectorXd root = problem.compliance.diagonal().cwiseSqrt();
    const double coupling =
        (root.cwiseInverse().asDiagonal() * problem.compliance * root.cwiseInverse().asDiagonal())
            .minCoeff();
    table.row({name, std::to_string(problem.free_gap.size()),
               std::to_string(way.state.report.history.front().changes),
               std::to_string(way.state.active.size()), std::to_string(way.outer_steps),
               to_string(way.state.report.status), number(coupling, "%.1e"),
               std::to_string(runs[3].outer_steps), to_string(runs[3].state.report.status)});
    for (const std::size_t i : {0, 1, 2})
      if (runs[i].outer_steps != 1) throw NotSolved(text(name, ": one step is not enough"));
    if (block.outer_steps == 0) block = way;
  }
  write_file(run.out / "bodies.md", table.markdown());
  return block;
}

// 6. The flow chart, and how often three runs went along each of its arrows.
void flow_chart(const ProgramOptions& run, const QuasiActiveRun& block, const QuasiActiveRun& rows,
                Results& results) {
  const QuasiActiveRun walls = run_quasi_active_set_literal(condensed(floating(four_walls)));
  const auto steps = [](const QuasiActiveRun& way) {
    const double k = static_cast<double>(way.outer_steps);
    const double left = way.left_over.empty() ? 0 : 1;
    return std::array<double, 6>{1, k, k, 1, 1 - left, left};
  };
  Table table({"arrow", "walls", "rows", "block"});  // in the order of the arrows of fig_4_1.gp
  for (std::size_t i = 0; i < 6; ++i)
    table.row(
        {static_cast<double>(i + 1), steps(walls).at(i), steps(rows).at(i), steps(block).at(i)});
  write_file(run.out / "fig_4_1.csv", table.csv());
  results.add("walls_steps", static_cast<double>(walls.outer_steps), "-");
  results.add("walls_delta", walls.fraction, "-");
}

// 7. Random programmes: how the method ends, by the rows that make up QAS.
Tally whole_numbers(std::uint64_t runs, Results& results) {
  Tally tally;
  Random random(1);
  for (std::uint64_t k = 0; k < runs; ++k) {
    const auto ways = run_readings(whole_numbers(random));
    for (std::size_t i = 0; i < 4; ++i) tally[i].count(ways[i]);
  }
  Ends all;
  for (const Ends& e : tally) {
    all.two += e.two + e.more;
    all.optimal += e.optimal;
    all.corrected += e.corrected;
  }
  results.add("whole_numbers", static_cast<double>(runs), "-");
  results.add("ended_later", all.two, "-");
  results.add("optimal_before", 100 * all.optimal / all.two, "%");
  results.add("optimal_after", 100 * (all.optimal + all.corrected) / all.two, "%");
  return tally;
}

void random_programmes(const ProgramOptions& run, Results& results) {
  const std::uint64_t runs = run.full ? 1000 : 100;
  const Tally whole = whole_numbers(10 * runs, results);
  Table text_table = table_of_ends();
  Table ends = table_of_ends();
  add_rows(text_table, "whole numbers", whole);
  add_rows(ends, "whole numbers", whole);
  Table table({"n, m", "one step", "limit, optimal", "limit, feasible", "steps to the limit",
               "gap %, median", "gap %, worst", "repaired: solved", "its steps"});
  Table shares({"n", "m", "one", "limit", "feasible", "violated", "fresh"});
  double worst_gap = 0, repaired = 0, total = 0, independence = 0;
  Tally all;
  for (const Index n : {10, 20, 50})
    for (const Index m : {n / 2, n, 2 * n, 4 * n}) {
      const Share s = try_size(n, m, runs);
      const double percent = 100 / static_cast<double>(runs);
      const Ends& e = s.ends[0];
      const double feasible = e.limit - e.limit_optimal;
      const double worst = s.gap.empty() ? 0 : *std::max_element(s.gap.begin(), s.gap.end());
      table.row({text(n, ", ", m), number(percent * e.one, "%.0f %%"),
                 number(percent * e.limit_optimal, "%.0f %%"),
                 number(percent * feasible, "%.0f %%"), number(median(s.steps), "%.0f"),
                 number(100 * median(s.gap), "%.1f"), number(100 * worst, "%.1f"),
                 number(percent * s.repaired, "%.0f %%"),
                 number(median(s.repaired_steps), "%.0f")});
      shares.row({static_cast<double>(n), static_cast<double>(m), percent * e.one,
                  percent * e.limit_optimal, percent * feasible, s.violated, s.fresh});
      add_rows(ends, text(n, ", ", m), s.ends);
      for (std::size_t i = 0; i < 4; ++i) all[i].add(s.ends[i]);
      results.add(text("violated_", n, '_', m), s.violated, "-");
      results.add(text("fresh_", n, '_', m), s.fresh, "-");
      results.add(text("crowded_", n, '_', m), s.crowded, "-");
      results.add(text("one_step_", n, '_', m), percent * e.one, "%");
      results.add(text("lost_", n, '_', m), 100 * median(s.lost), "%");
      results.add(text("lost_whole_", n, '_', m), 100 * median(s.lost_whole), "%");
      independence = std::max(independence, std::abs(percent * e.one - 100 * std::exp(-s.fresh)));
      worst_gap = std::max(worst_gap, 100 * worst);
      repaired += s.repaired;
      total += static_cast<double>(runs);
    }
  add_rows(text_table, "sizes of table 1", all);
  if (whole[0].two + whole[0].more + all[0].two + all[0].more > 0)
    throw NotSolved("all violated rows: a loop has ended after two or more steps");
  write_file(run.out / "ends.md", text_table.markdown());
  write_file(run.out / "ends_by_size.md", ends.markdown());
  write_file(run.out / "sizes.md", table.markdown());
  write_file(run.out / "fig_4_3.csv", shares.csv());
  results.add("runs_of_a_size", static_cast<double>(runs), "-");
  results.add("runs", total, "-");
  results.add("independence_error", independence, "%");
  results.add("worst_gap", worst_gap, "%");
  results.add("repaired_solved", repaired, "-");
}

Status chapter(const ProgramOptions& run) {
  Results results("ch04");
  zigzag(run, results);
  const QuasiActiveRun rows = two_steps(run, results);
  four_walls_in_space(run, results);
  flow_chart(run, bodies(run), rows, results);
  random_programmes(run, results);
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch04", "The quasi-active-set iteration", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}
