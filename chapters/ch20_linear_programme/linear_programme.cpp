// Chapter 20 - Contact as a linear programme, at once and in increments of the load.
// Run:  make ch20     Reads: nothing     Writes: ch20.results, fig_20_1.csv, fig_20_1_increments.csv
#include "papers/linear_programme.hpp"

#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"

namespace {

using namespace signorini;
using Eigen::Index;

// 1. The cantilever of chapter 6, its load at once: what each pivot leaves.
ContactState at_once(const ProgramOptions& run, const ContactProblem& problem) {
  const ContactState once = linear_programme(problem);
  Table curve({"pivot", "overlaps", "closed"});
  double pivot = 0;
  curve.row({0, 1, 0});
  for (const Iteration& now : once.report.history)
    curve.row({++pivot, now.residual, static_cast<double>(now.active)});
  write_file(run.out / "fig_20_1.csv", curve.csv("rel 1e-6 abs 1e-9"));
  return once;
}

// \return after how many exchanges a second force joins: until then gaps do
double first_force_alone(const ContactState& once) {
  double exchanges = 0;
  for (const Iteration& now : once.report.history) {
    if (now.active > 1) break;
    ++exchanges;
  }
  return exchanges;
}

// 2. The same load in equal increments.
// [increments]
struct Path {
  ContactState end;
  Index pivots = 0;  // of all increments
};

Path in_increments(const SolvedScene& beam, Index increments) {
  const std::vector<ContactState> steps = incremental_linear_programme(
      beam.condensed.problem, beam.model.pairs.initial_gap, increments);
  Path path{steps.back()};
  for (const ContactState& step : steps) path.pivots += step.report.iterations;
  return path;
}
// [increments]

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch20");
  const SolvedScene beam =
      solved(signorini_test::cantilever("q4_incompatible", 100, 10), "the cantilever");
  const Eigen::VectorXd& force = beam.solution.contact.force;
  const auto apart = [&](const ContactState& state) {
    return (state.force - force).norm() / force.norm();
  };
  const ContactState once = at_once(run, beam.condensed.problem);
  results.add("lp_pivots_once", static_cast<double>(once.report.iterations), "-");
  results.add("lp_deviation", apart(once), "-", Repeats::No);
  const Eigen::Index overlaps = (beam.condensed.problem.free_gap.array() < 0).count();
  results.add("overlaps", static_cast<double>(overlaps), "-");
  const Eigen::VectorXd half = (beam.model.pairs.initial_gap + beam.condensed.problem.free_gap) / 2;
  results.add("overlaps_at_half", static_cast<double>((half.array() < 0).count()), "-");
  results.add("first_force_alone", first_force_alone(once), "-");
  SolverOptions one_exchange;
  one_exchange.iteration_limit = 1;
  Index first = 0;
  linear_programme(beam.condensed.problem, one_exchange).force.maxCoeff(&first);
  results.add("first_force_at", beam.model.pairs.position(first, 0), "cm");
  results.add("pairs", static_cast<double>(force.size()), "-");
  results.add("closed", static_cast<double>(beam.solution.contact.active().size()), "-");
  results.headline("lp_closed", static_cast<double>(beam.solution.contact.active().size()),
                   "the active set method");
  results.add("lp_closed", static_cast<double>(once.active().size()), "-");
  Table curve({"increments", "pivots"});
  for (const Index increments : {1, 2, 5, 10, 20, 50, 100, 200}) {
    const Path path = in_increments(beam, increments);
    curve.row({static_cast<double>(increments), static_cast<double>(path.pivots)});
    results.add("lp_pivots_" + number(static_cast<double>(increments)),
                static_cast<double>(path.pivots), "-");
    if (increments == 20)
      results.add("lp_increments_deviation", apart(path.end), "-", Repeats::No);
  }
  write_file(run.out / "fig_20_1_increments.csv", curve.csv());
  const Report& sets = beam.solution.contact.report;
  results.add("active_sets", static_cast<double>(sets.iterations), "-");
  results.add("coarse_sets", static_cast<double>(sets.factorisations - sets.iterations), "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch20", "A linear programme", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
