// Chapter 2 - The landscape s over the triangle of weights, and the way of the line search of chapter 3.
// Run:  make ch02     Reads: nothing     Writes: ch02_landscape.results, fig_2_2.csv,
//                                                fig_2_2_path.csv, fig_2_2_best.csv, fig_2_2_top.csv
#include <cmath>

#include "papers/weight_iteration.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "three_candidates.hpp"

namespace {

using namespace ch02;
using Eigen::Vector2d;

Vector2d place(const VectorXd& xi) {  // in the triangle, left at (0, 0), middle at (1, 0)
  return {xi(1) + xi(2) / 2, std::sqrt(0.75) * xi(2)};
}

// 1. From the side of the first two pairs up to the vertex of the third.
Table whole_triangle(const ContactProblem& problem) {
  Table grid({"x", "y", "s"});
  for (int row = 0; row <= 60; ++row) {
    for (int column = 0; column <= 60; ++column) {
      const double a = row / 60.0;
      const double b = column / 60.0;
      const Vector3d xi((1 - a) * (1 - b), (1 - a) * b, a);
      grid.row({place(xi).x(), place(xi).y(), trade(problem, xi).energy});
    }
    grid.blank_line();
  }
  return grid;
}

// 2. The part around the maximum, on a finer grid.
Table around_the_top(const ContactProblem& problem) {
  Table grid({"x", "y", "s"});
  for (int row = 0; row <= 52; ++row) {
    for (int column = 0; column <= 72; ++column) {
      const Vector2d at(0.66 + column / 400.0, 0.13 + row / 400.0);
      const double third = at.y() / std::sqrt(0.75);
      const Vector3d xi(1 - at.x() - third / 2, at.x() - third / 2, third);
      grid.row({at.x(), at.y(), trade(problem, xi).energy});
    }
    grid.blank_line();
  }
  return grid;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch02_landscape");
  const Block block = pressed_block();
  const ContactProblem& problem = block.problem;
  write_file(run.out / "fig_2_2.csv", whole_triangle(problem).csv());
  write_file(run.out / "fig_2_2_top.csv", around_the_top(problem).csv());
  // 3. The way of the line search from equal weights, and where it leads.
  Table path({"x", "y", "s"});
  WeightIteration search(problem, WeightRule::LineSearch);
  for (int k = 0; k <= 20; ++k, (void)search.step())
    path.row({place(search.weights()).x(), place(search.weights()).y(), search.value()});
  write_file(run.out / "fig_2_2_path.csv", path.csv());
  Table best({"x", "y"});
  best.row({place(shares(block)).x(), place(shares(block)).y()});
  write_file(run.out / "fig_2_2_best.csv", best.csv());
  results.add("path_share_20", search.value() / trade(problem, shares(block)).energy, "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch02_landscape", "The landscape over the weights", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}
