// Chapter 15 - The square that sticks, slips and opens (SSNV128).
// Run:  make ch15     Reads: nothing     Writes: ch15_square.results, square.md, fig_15_6.csv
#include <iostream>
#include <vector>

#include "blocks.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch15;

// How far the lower side has moved, in one step and in five, beside what is published.
void sliding(const ProgramOptions& run, Results& results) {
  const double published[] = {2.86, 2.72, 2.28, 1.98, 1.50};
  const double aster[] = {2.8722, 2.7355, 2.2996, 1.9943, 1.5569};  // one model of Code_Aster
  Table table({"x [mm]", "published", "ssnv128d", "one step", "five steps"});
  Table figure({"x", "moved", "motion"});
  std::vector<Eigen::VectorXd> moved;
  for (const int steps : {1, 5})
    remember(square(steps), [&](const Model& model, const Step& step) {
      if (step.state.time < 1) return;
      moved.push_back(1e5 * step.solution.displacements[0].col(0).head(33));
      for (Eigen::Index i = 0; steps == 5 && i < 32; ++i)
        figure.row({number(1e3 * model.pairs.position(i, 0)), number(moved.back()(i)),
                    to_string(step.solution.contact.contact_status[static_cast<std::size_t>(i)])});
    });
  const Eigen::Index node[] = {0, 1, 4, 6, 9};
  for (int i = 0; i < 5; ++i)
    table.row({number(1.25 * double(node[i])), number(published[i], "%.2f"),
               number(aster[i], "%.4f"), number(moved[0](node[i]), "%.4f"),
               number(moved[1](node[i]), "%.4f")});
  results.add("square_above", 100 * (moved[0](node[4]) / published[4] - 1), "%");
  std::cout << table.markdown();
  write_file(run.out / "square.md", table.markdown());
  write_file(run.out / "fig_15_6.csv", figure.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch15_square");
  sliding(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch15_square", "It sticks, slides and opens", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}
