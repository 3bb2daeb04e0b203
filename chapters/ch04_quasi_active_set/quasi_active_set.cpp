// Chapter 4 - The quasi-active-set iteration (Xuan & Li 2002, secs. 2.3 and 3, eqs. 30-39): its outer loop.
// Run:  make ch04     Reads: nothing     Writes: ch04.results, zigzag.md, fig_4_2.csv
#include "cases.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch04;

// 1. The outer loop: (37) all violated rows, (38)-(39) their problem, (36) the minimum moved; exact, with K = I.
struct Step {
  exact::Vector u;      // u^k
  exact::Set violated;  // VIO, all of it is QAS (37)
  exact::Fraction eta;
};

// [outer loop]
std::vector<Step> outer_loop(const exact::Programme& q, int most) {
  std::vector<Step> way;
  for (exact::Vector u = q.p; static_cast<int>(way.size()) < most;) {  // u^0 = K^-1 p
    const exact::Set violated = rows_with(q, u, -1);
    if (violated.empty()) break;
    const exact::Rest next = closest(q, violated, u);  // (38): the minimum is at u, the force is
    exact::Fraction eta;                               // eta xi
    for (const exact::Fraction& force : next.force) eta = eta + force;  // (39)
    way.push_back({u, violated, eta});
    u = next.u;  // (36)
  }
  return way;
}
// [outer loop]

// 2. Between two half-planes it never ends; in floating point a tolerance ends it.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch04");
  Table table({"k", "u", "violated row", "η"});
  Table path({"x", "y"});
  int k = 0;
  for (const Step& step : outer_loop(corner, 11)) {
    path.row({step.u[0].value(), step.u[1].value()});
    if (k <= 6)
      table.row({std::to_string(k), text_of(step.u), text_of(step.violated), step.eta.text()});
    ++k;
  }
  write_file(run.out / "zigzag.md", table.markdown());
  write_file(run.out / "fig_4_2.csv", path.csv());
  const QuasiActiveRun floats = run_quasi_active_set_literal(condensed(corner));
  results.add("zigzag_steps", static_cast<double>(floats.outer_steps), "-");
  results.headline("zigzag_steps", 78, "two steps halve the overlap, until 1e-12 of it is left");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch04", "The quasi-active-set iteration", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
