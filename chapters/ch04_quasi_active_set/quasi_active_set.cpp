// Chapter 4 - The quasi-active-set iteration (Xuan & Li 2002, secs. 2.3 and 3, eqs. 30-39).
// Run:  make ch04     Reads: nothing     Writes: ch04.results, zigzag.md, last_step.md, bodies.md,
//                                                sizes.md, fig_4_1.csv, fig_4_2.csv, fig_4_3.csv
#include <algorithm>
#include <array>
#include <cmath>

#include "cases.hpp"
#include "signorini/complementarity/examples.hpp"
#include "signorini/complementarity/quasi_active_set_literal.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"

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
  exact::Vector u = corner.p;  // u^0
  for (Index k = 0; k <= 10; ++k) {
    path.row({u[0].value(), u[1].value()});
    const exact::Set violated = rows_with(corner, u, -1);       // VIO, all of it is QAS
    const exact::Rest next = closest(corner, violated, u);      // (38), with the minimum at u
    const exact::Fraction eta = next.force[0] + next.force[1];  // (39)
    if (k <= 6)
      table.row({std::to_string(k), text_of(u), std::to_string(violated.at(0) + 1), eta.text()});
    u = next.u;  // (36)
    SolverOptions stop;
    stop.iteration_limit = k + 1;
    const DenseProgramme q = floating(corner);
    agree(displacement(q, quasi_active_set_literal(condensed(q), stop)), floating(u), 1e-15,
          "the zigzag");
  }
  // [zigzag]
  write_file(run.out / "zigzag.md", table.markdown());
  write_file(run.out / "fig_4_2.csv", path.csv());
  const QuasiActiveRun way = run_quasi_active_set_literal(condensed(floating(corner)));
  results.add("zigzag_steps", static_cast<double>(way.outer_steps), "-");
}

// 2. The last step (33)-(35), which the paper calls optimal.
// [last]
void last_step(const ProgramOptions& run, Results& results) {
  const exact::Programme& q = four_walls;
  const exact::Vector limit = exact::along({1, 1, 1}, {1, 50}, {6, 3, -1});  // on rows 3 and 4
  const exact::Rest next = closest(q, rows_with(q, limit, 0), q.p);          // (33)
  exact::Fraction delta = 1;
  for (const std::size_t i : rows_with(q, next.u, -1)) {
    const exact::Fraction ratio =
        gap(q, i, limit) / dot(q.A[i], exact::along(next.u, -1, limit));  // (34)
    delta = ratio < delta ? ratio : delta;
  }
  const exact::Vector end = exact::along(limit, delta, exact::along(next.u, -1, limit));  // (35)
  const exact::Rest held = close(q, rows_with(q, end, 0), q.p);  // the rows that are tight there
  const exact::Rest best = closest(q, {0, 1, 2, 3}, q.p);
  // [last]
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

// 3. Contact of bodies: the block of chapter 1, the cantilever of chapter 6, a half-plane.
QuasiActiveRun bodies(const ProgramOptions& run) {
  Table table({"body", "pairs", "overlapping at u⁰", "closed", "k", "status", "smallest coupling"});
  QuasiActiveRun block;
  const std::pair<const char*, ContactProblem> all[] = {
      {"block, chapter 1", block_on_obstacle()},
      {"cantilever, chapter 6", cantilever()},
      {"half-plane, round punch", half_plane_indentation(200).problem}};
  for (const auto& [name, problem] : all) {
    const QuasiActiveRun way = run_quasi_active_set_literal(problem);
    const VectorXd root = problem.compliance.diagonal().cwiseSqrt();
    const double coupling =
        (root.cwiseInverse().asDiagonal() * problem.compliance * root.cwiseInverse().asDiagonal())
            .minCoeff();
    table.row({name, std::to_string(problem.free_gap.size()),
               std::to_string(way.state.report.history.front().changes),
               std::to_string(way.state.active.size()), std::to_string(way.outer_steps),
               to_string(way.state.report.status), number(coupling, "%.1e")});
    if (way.outer_steps != 1) throw NotSolved(text(name, ": one step is not enough"));
    if (block.outer_steps == 0) block = way;
  }
  write_file(run.out / "bodies.md", table.markdown());
  return block;
}

// 4. The flow chart, and how often two runs went along each of its arrows.
void flow_chart(const ProgramOptions& run, const QuasiActiveRun& block, Results& results) {
  const QuasiActiveRun walls = run_quasi_active_set_literal(condensed(floating(four_walls)));
  const auto steps = [](const QuasiActiveRun& way) {
    const double k = static_cast<double>(way.outer_steps);
    const double left = way.left_over.empty() ? 0 : 1;
    return std::array<double, 6>{1, k, k, 1, 1 - left, left};
  };
  Table table({"arrow", "walls", "block"});  // in the order of the arrows of fig_4_1.gp
  for (std::size_t i = 0; i < 6; ++i)
    table.row({static_cast<double>(i + 1), steps(walls).at(i), steps(block).at(i)});
  write_file(run.out / "fig_4_1.csv", table.csv());
  results.add("walls_steps", static_cast<double>(walls.outer_steps), "-");
  results.add("walls_delta", walls.fraction, "-");
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// 5. Random programmes of the sizes of Table 1: how the two methods end.
// [sizes]
struct Share {
  double one = 0, limit = 0, feasible = 0, stopped = 0, repaired = 0;  // runs
  double violated = 0, fresh = 0;  // mean number of pairs that overlap at u^0 and at u^1
  double crowded = 0;              // runs in which the former outnumber the unknowns
  std::vector<double> steps, repaired_steps;
  std::vector<double> gap, lost, lost_whole;  // over the energy that contact adds, or all energy
};

Share try_size(Index n, Index m, std::uint64_t runs) {
  Share share;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const KnownProgramme known = rosen_suzuki(n, m, seed);
    const ContactProblem problem = condensed(known.programme);
    const QuasiActiveRun way = run_quasi_active_set_literal(problem);
    const ContactState repaired = find_solver("quasi_active_set").solve(problem, {});
    const Report& report = way.state.report;
    const bool solved = report.status == Status::Solved;
    (solved ? (way.outer_steps <= 1 ? share.one : share.limit)
            : (report.status == Status::Feasible ? share.feasible : share.stopped)) += 1;
    share.repaired += repaired.report.status == Status::Solved ? 1 : 0;
    share.violated += static_cast<double>(report.history[0].changes) / static_cast<double>(runs);
    share.fresh += static_cast<double>(report.history[1].changes) / static_cast<double>(runs);
    share.crowded += report.history[0].changes > n ? 1 : 0;
    if (way.outer_steps > 1) share.steps.push_back(static_cast<double>(way.outer_steps));
    share.repaired_steps.push_back(static_cast<double>(repaired.report.iterations));
    const double added = -0.5 * repaired.force.dot(problem.free_gap + repaired.gap);
    if (solved) continue;
    const double excess = report.history.back().dual_energy + energy_gap(way.state) - added;
    share.gap.push_back(energy_gap(way.state) / added);
    share.lost.push_back(excess / added);
    share.lost_whole.push_back(excess / std::abs(known.energy));
  }
  return share;
}
// [sizes]

void sizes(const ProgramOptions& run, Results& results) {
  const std::uint64_t runs = run.full ? 1000 : 100;
  Table table({"n, m", "one step", "limit, optimal", "limit, feasible", "steps to the limit",
               "gap %, median", "gap %, worst", "repaired: solved", "its steps"});
  Table shares({"n", "m", "one", "limit", "feasible", "violated", "fresh"});
  double shortest = 1e9, stopped = 0, repaired = 0, total = 0, independence = 0;
  for (const Index n : {10, 20, 50})
    for (const Index m : {n / 2, n, 2 * n, 4 * n}) {
      const Share s = try_size(n, m, runs);
      const double percent = 100 / static_cast<double>(runs);
      const double worst = s.gap.empty() ? 0 : *std::max_element(s.gap.begin(), s.gap.end());
      table.row({text(n, ", ", m), number(percent * s.one, "%.0f %%"),
                 number(percent * s.limit, "%.0f %%"), number(percent * s.feasible, "%.0f %%"),
                 number(median(s.steps), "%.0f"), number(100 * median(s.gap), "%.1f"),
                 number(100 * worst, "%.1f"), number(percent * s.repaired, "%.0f %%"),
                 number(median(s.repaired_steps), "%.0f")});
      shares.row({static_cast<double>(n), static_cast<double>(m), percent * s.one,
                  percent * s.limit, percent * s.feasible, s.violated, s.fresh});
      results.add(text("violated_", n, '_', m), s.violated, "-");
      results.add(text("fresh_", n, '_', m), s.fresh, "-");
      results.add(text("crowded_", n, '_', m), s.crowded, "-");
      results.add(text("one_step_", n, '_', m), percent * s.one, "%");
      results.add(text("lost_", n, '_', m), 100 * median(s.lost), "%");
      results.add(text("lost_whole_", n, '_', m), 100 * median(s.lost_whole), "%");
      independence = std::max(independence, std::abs(percent * s.one - 100 * std::exp(-s.fresh)));
      for (const double k : s.steps) shortest = std::min(shortest, k);
      stopped += s.stopped;
      repaired += s.repaired;
      total += static_cast<double>(runs);
    }
  write_file(run.out / "sizes.md", table.markdown());
  write_file(run.out / "fig_4_3.csv", shares.csv());
  results.add("runs_of_a_size", static_cast<double>(runs), "-");
  results.add("runs", total, "-");
  results.add("shortest_way_to_the_limit", shortest, "-");
  results.add("independence_error", independence, "%");
  results.add("stopped", stopped, "-");
  results.add("repaired_solved", repaired, "-");
}

Status chapter(const ProgramOptions& run) {
  Results results("ch04");
  zigzag(run, results);
  last_step(run, results);
  flow_chart(run, bodies(run), results);
  sizes(run, results);
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch04", "The quasi-active-set iteration", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}
