// Chapter 1 - The solution as the admissible displacement that is nearest, in energy, to the one without obstacle.
// Run:  make ch01     Reads: nothing     Writes: ch01_projection.results, fig_1_6.csv,
//      fig_1_6_set.csv, fig_1_6_points.csv
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/problem.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/enumerate.hpp"

namespace {

using namespace signorini;
using Eigen::Matrix2d;
using Eigen::Vector2d;

// 1. Two carts in a row, on springs of 1 N/mm; 3 N pull at the second; stops 2.6 and 3.5 mm ahead.
const Matrix2d K = (Matrix2d() << 2, -1, -1, 1).finished();  // [N/mm]
const Vector2d p(0, 3), stops(2.6, 3.5);                     // [N], [mm]

// 2. All displacements as far from u0 in energy as a point: an ellipse.
Table ellipse(const Vector2d& u0, double distance) {
  const Matrix2d root = K.llt().matrixL();
  Table curve({"x", "y"});
  for (int step = 0; step <= 180; ++step) {
    const double angle = 2 * pi * step / 180;
    const Vector2d at =
        u0 + distance * root.transpose().inverse() * Vector2d(std::cos(angle), std::sin(angle));
    curve.row({at.x(), at.y()});
  }
  return curve;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch01_projection");
  const Vector2d u0 = K.llt().solve(p);
  const ContactState state = enumerate({K.inverse(), stops - u0});
  const Vector2d u = u0 - K.llt().solve(state.force);
  const double distance = std::sqrt((u - u0).dot(K * (u - u0)));
  const double of_corner = std::sqrt((stops - u0).dot(K * (stops - u0)));
  write_file(run.out / "fig_1_6.csv", ellipse(u0, distance).csv());
  Table set({"x", "y"});
  for (const Vector2d& at :
       {Vector2d(-1, -1), Vector2d(stops.x(), -1), stops, Vector2d(-1, stops.y())})
    set.row({at.x(), at.y()});
  write_file(run.out / "fig_1_6_set.csv", set.csv());
  Table points({"x", "y"});
  for (const Vector2d& at : {u0, u, stops}) points.row({at.x(), at.y()});
  write_file(run.out / "fig_1_6_points.csv", points.csv());
  results.add("nearest_x", u.x(), "mm");
  results.add("nearest_y", u.y(), "mm");
  results.add("distance", distance, "(N*mm)^0.5");
  results.add("distance_of_corner", of_corner, "(N*mm)^0.5");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch01_projection", "The nearest admissible displacement",
                                SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
