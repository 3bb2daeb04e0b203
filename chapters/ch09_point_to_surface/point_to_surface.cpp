// Chapter 9 - One node over one edge (Lin et al., sec. 2.3, eqs. 20-27).
// Run:  make ch09     Reads: nothing     Writes: ch09.results, element.md, fig_9_1.csv
#include <iostream>

#include "contact_element.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch09;
using namespace signorini;
using Eigen::Index;

/// Figure 9.1: the edge, node 3 and its projection, the forces on nodes 1 to 3, the reaction at 3'.
/// \param X   positions of the nodes
/// \param fn  normal force \param ft  friction
/// \return a line from (x, y) to (x2, y2) per row
Table sketch(const Nodes& X, double fn, double ft) {
  Table table({"x", "y", "x2", "y2"});
  const auto line = [&table](const Eigen::RowVector2d& from, const Eigen::RowVector2d& to) {
    table.row({from.x(), from.y(), to.x(), to.y()});
  };
  const Place at = projected(X);
  const Eigen::RowVector2d foot = at.N1 * X.row(0) + at.N2 * X.row(1);
  const Nodes forces = nodal_forces(at, fn, ft);
  line(X.row(0), X.row(1));
  line(X.row(2), foot);
  for (Index i = 0; i < 3; ++i) line(X.row(i), X.row(i) + forces.row(i));
  line(foot, foot + forces.row(0) + forces.row(1));
  return table;
}

const Nodes X = (Nodes() << 4, 0, 0, 3, 3, 1.5).finished();  // [mm]

// 1. One node over one edge: (20)-(27).
void one_element(const ProgramOptions& run, Results& results) {
  const Place at = projected(X);
  results.add("N1", at.N1, "-");
  results.add("N2", at.N2, "-");
  results.add("initial_gap", at.gap, "mm");
  Table table({"force on", "of f_n = 1", "of τ = 1", "at"});
  const Nodes fn = nodal_forces(at, 1, 0), ft = nodal_forces(at, 0, 1);
  const auto vector = [](double x, double y) {
    return text("(", number(x, "%.3f"), ", ", number(y, "%.3f"), ")");
  };
  for (Index i = 0; i < 3; ++i)
    table.row({text("node ", i + 1), vector(fn(i, 0), fn(i, 1)), vector(ft(i, 0), ft(i, 1)),
               vector(X(i, 0), X(i, 1))});
  std::cout << table.markdown();
  write_file(run.out / "element.md", table.markdown());
  for (Index i = 0; i < 3; ++i) {
    results.add(text("a_", i + 1, "x"), fn(i, 0), "-");
    results.add(text("a_", i + 1, "y"), fn(i, 1), "-");
  }
  results.add("moment_of_friction", moment(X, ft), "N mm");
  results.headline("moment_of_friction", -at.gap, "a couple across the gap");
  write_file(run.out / "fig_9_1.csv", sketch(X, 1.2, 0.5).csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch09");
  one_element(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch09", "Point-to-surface contact", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
