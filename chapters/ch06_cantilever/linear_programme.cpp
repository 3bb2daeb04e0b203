// Chapter 6 - Contact as a linear programme, at once and in increments of the load.
// Run:  make ch06     Reads: nothing     Writes: ch06_linear_programme.results
#include "papers/linear_programme.hpp"

#include "scene.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch06;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch06_linear_programme");
  // [increments]
  const SolvedScene beam = solve_cantilever(paper, "q4_incompatible", 100);
  const ContactProblem& problem = beam.condensed.problem;
  const ContactState once = linear_programme(problem);
  const std::vector<ContactState> steps =
      incremental_linear_programme(problem, beam.model.pairs.initial_gap, 20);
  Index pivots = 0;
  for (const ContactState& step : steps) pivots += step.report.iterations;
  // [increments]
  results.add("lp_pivots_once", static_cast<double>(once.report.iterations), "-");
  results.add("lp_pivots_steps", static_cast<double>(pivots), "-");
  results.add("lp_increments", static_cast<double>(steps.size()), "-");
  const Eigen::VectorXd& force = beam.solution.contact.force;
  results.add("lp_deviation", (once.force - force).norm() / force.norm(), "-", Repeats::No);
  results.add("lp_increments_deviation", (steps.back().force - force).norm() / force.norm(), "-",
              Repeats::No);
  results.add("lp_closed_nodes", static_cast<double>(steps.back().active.size()), "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch06_linear_programme", "A linear programme", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}
