// Chapter 8 - The active set as a semi-smooth Newton method (Lin et al., sec. 2.2, eq. 11).
// Run:  make ch08     Reads: nothing     Writes: ch08_active_set.results, sets.md
#include <iostream>
#include <string>

#include "functions.hpp"
#include "semismooth.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

// 1. Two pairs that overlap, of which one would pull if both were closed.
const ContactProblem two{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(), Eigen::Vector2d(-3, -1)};

std::string named(const std::vector<Index>& set) {
  std::string names;
  for (const Index i : set) names += (names.empty() ? "" : ", ") + std::to_string(i + 1);
  return names.empty() ? "none" : names;
}

// 2. The sets, and beside them Newton's method with the minimum, from the same forces.
void sets(const ProgramOptions& run, Results& results) {
  const SetRun way = semismooth(two, 1, Eigen::Vector2d(0, 0));
  const NewtonRun newton_way = newton(two, functions[1], Eigen::Vector2d(0, 0), {1e-12, 0});
  Table table({"step", "closed", "force 1", "force 2", "gap 1", "gap 2"});
  for (std::size_t k = 0; k + 1 < newton_way.forces.size(); ++k) {
    const VectorXd force = newton_way.forces[k + 1];
    const VectorXd gap = two.free_gap + two.compliance * force;
    table.row({std::to_string(k + 1), named(way.sets[k]), number(force(0) + 0.0, "%.3f"),
               number(force(1) + 0.0, "%.3f"), number(gap(0) + 0.0, "%.3f"),
               number(gap(1) + 0.0, "%.3f")});
  }
  std::cout << table.markdown();
  write_file(run.out / "sets.md", table.markdown());
  results.add("sets", static_cast<double>(way.sets.size() - 1), "-");
  results.add("force_1", way.force(0), "-");
  results.add("gap_2", two.free_gap(1) + two.compliance.row(1).dot(way.force), "-");
  results.headline("force_1", newton_way.forces.back()(0), "by Newton with the minimum");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch08_active_set");
  sets(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch08_active_set", "The active set as Newton's method", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}
