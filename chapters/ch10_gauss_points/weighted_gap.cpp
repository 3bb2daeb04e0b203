// Chapter 10 - One weighted gap by more and more Gauss points.
// Run:  make ch10     Reads: nothing     Writes: ch10_weighted_gap.results
#include <algorithm>
#include <iostream>

#include "signorini/core/table.hpp"
#include "signorini/fem/element.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector4d;

// 1. Two edges of the source, [0, 1] and [1, 2], over three of the target, each 2/3 long: how the four nodes of the
//    target count in the gap of the middle node of the source.
// [row]
Vector4d weighted_row(int points) {
  Vector4d row = Vector4d::Zero();
  double total = 0;
  for (const Index edge : {0, 1})
    for (const GaussPoint& gauss : gauss_line(points)) {
      const double s = gauss.xi;                                         // on the edge, -1 to 1
      const double psi = edge == 0 ? (1 + 3 * s) / 2 : (1 - 3 * s) / 2;  // dual to N of the node
      const double place = static_cast<double>(edge) + (1 + s) / 2;      // x of the point
      const Index facing = std::min<Index>(2, static_cast<Index>(place / (2. / 3)));
      const double t =
          place / (2. / 3) - static_cast<double>(facing);  // on the target's edge, 0 to 1
      const double share = gauss.weight / 2 * psi;
      row(facing) += share * (1 - t);
      row(facing + 1) += share * t;
      total += share;
    }
  return row / total;
}
// [row]

// 2. The exact row is (-2, 11, 11, -2)/18: exercise 10.2.
void more_points(Results& results) {
  Table table({"points an edge", "first node", "second node"});
  for (const int points : {2, 3, 4, 8, 16}) {
    const Vector4d row = weighted_row(points);
    table.row({std::to_string(points), number(row(0), "%.5f"), number(row(1), "%.5f")});
    results.add("first_" + std::to_string(points), row(0), "-");
  }
  std::cout << table.markdown();
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch10_weighted_gap");
  more_points(results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch10_weighted_gap", "One weighted gap", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
