// Chapter 7 - The method of the paper on the pin, as it is printed and repaired.
// Run:  make ch07     Reads: nothing     Writes: ch07_as_printed.results, fig_7_4_*.csv
#include "papers/printed_method.hpp"
#include "pin.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace {

using namespace ch07;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch07_as_printed");
  int one_step = 0;
  for (const auto& [name, pin] : {std::pair("t", tension), std::pair("c", compression)}) {
    const SolvedScene now = on_paper_mesh(pin).run;
    const ContactProblem& problem = now.condensed.problem;
    one_step += solved_in_one_step(problem, now.solution.contact) ? 1 : 0;
    const PrintedMethod printed = printed_method(problem);
    const VectorXd x = pin.side() * now.model.pairs.position.col(0);  // from the middle to the pole
    write_printed_method(run.out / text("fig_7_4_", name), printed,
                         (x / hole_radius).array().acos() / degree);
    add_counts(results, printed, text("_", name));
    results.add(text("least_compliance_", name),
                problem.compliance.minCoeff() / problem.compliance.maxCoeff(), "-");
    const ContactState repaired = quasi_active_set(problem);
    results.add(text("repaired_steps_", name), static_cast<double>(repaired.report.iterations),
                "-");
  }
  results.add("one_step_readings", one_step, "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch07_as_printed", "The method of the paper on the pin", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}
