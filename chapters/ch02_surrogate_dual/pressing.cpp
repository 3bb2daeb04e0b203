// Chapter 2 - Forces press: the condition eta >= 0 of the dual problem (Xuan & Li 2002, eqs. 18, 24).
// Run:  make ch02     Reads: nothing     Writes: ch02_pressing.results, fig_2_1.csv
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "three_candidates.hpp"

namespace {

using namespace ch02;
using Eigen::Vector2d;

// 1. Two pairs that do not feel each other, the first open by 2, the second overlapping by 1.
void open_and_overlapping(const ProgramOptions& run) {
  const ContactProblem pairs{Eigen::Matrix2d::Identity(), Vector2d(2, -1)};
  Table table({"weight", "without_constraint", "positive_part"});
  for (int step = 0; step <= 120; ++step) {
    const Vector2d xi(1 - step / 120.0, step / 120.0);
    const double squared = pairs.free_gap.dot(xi) * pairs.free_gap.dot(xi);
    table.row({xi(1), 0.5 * squared / xi.squaredNorm(), trade(pairs, xi).energy});
  }
  write_file(run.out / "fig_2_1.csv", table.csv());
}

// 2. Grazing contact: a pair whose free gap is exactly zero.
double grazing_force() {
  const ContactProblem grazing{Eigen::Matrix2d::Identity(), Vector2d(0, 0.2)};
  return trade(grazing, Vector2d(1, 0)).force;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch02_pressing");
  open_and_overlapping(run);
  results.add("grazing_force", grazing_force(), "N");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch02_pressing", "Forces press", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
