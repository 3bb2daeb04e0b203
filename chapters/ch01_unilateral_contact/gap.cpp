// Chapter 1 - The gap (2), printed with one division too many (Xuan & Li 2002, eq. 2).
// Run:  make ch01     Reads: nothing     Writes: ch01_gap.results, fig_1_2.csv
#include <cmath>

#include "signorini/contact/obstacle.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::Vector2d;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch01_gap");
  const double radius = 60;  // of the obstacle [mm]
  const Obstacle curve =
      profile([=](double x) { return std::sqrt(radius * radius - x * x) - radius; },
              [=](double x) { return -x / std::sqrt(radius * radius - x * x); });
  Table table({"angle", "repaired", "printed"});
  for (int degrees = 0; degrees <= 60; degrees += 3) {
    const double angle = degrees * pi / 180;
    const Vector2d normal(std::sin(angle), std::cos(angle));
    const ObstacleContact seen = curve.look(Vector2d(0, -radius) + (radius + 1) * normal);  // 1 mm
    const double printed = seen.gap * seen.normal.y();  // the root once more in the denominator
    table.row({static_cast<double>(degrees), seen.gap, printed});
    if (degrees == 45) {
      results.add("repaired_gap_45", seen.gap, "mm");
      results.add("printed_gap_45", printed, "mm");
    }
  }
  write_file(run.out / "fig_1_2.csv", table.csv());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch01_gap", "The gap above a slope", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
