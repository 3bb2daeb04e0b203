// Chapter 1 - The picture of the three carts: at rest, without their stops, and with them.
// Run:  make ch01     Reads: nothing     Writes: fig_1_4.csv, fig_1_4_springs.csv
#include <cmath>

#include "addons/programme/dense_programme.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "three_carts.hpp"

namespace {

using namespace ch01;

const Vector3d fronts(14, 28, 44);  // of the carts at rest, which are 5 long; the wall is at 0
const double length = 5;

// One row of the picture at the height y: carts that moved by u, their stops and the forces of these.
void draw(const DenseProgramme& carts, double y, const Vector3d& u, const Vector3d& force,
          Table& bodies, Table& springs) {
  double from = 0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double front = fronts(i) + u(i);
    bodies.row({y, front - length, front, fronts(i) + carts.initial_gap(i), force(i)});
    for (int k = 0; k <= 48; ++k)
      springs.row({from + (front - length - from) * k / 48, y + 0.12 * std::sin(k * pi / 4)});
    springs.blank_line();
    from = front;
  }
  bodies.blank_line();
}

SolveStatus chapter(const ProgramOptions& run) {
  const DenseProgramme carts = three_carts();
  const DenseCondensed small = condense(carts);
  const Eigen::VectorXd force = primal_dual_active_set(small.problem).force;
  const Vector3d none = Vector3d::Zero();
  Table bodies({"y", "back", "front", "stop", "force"});
  Table springs({"x", "y"});
  draw(carts, 2, none, none, bodies, springs);
  draw(carts, 1, small.free_displacement, none, bodies, springs);
  draw(carts, 0, small.factor.solve(carts.load - carts.A.transpose() * force), force, bodies,
       springs);
  write_file(run.out / "fig_1_4.csv", bodies.csv());
  write_file(run.out / "fig_1_4_springs.csv", springs.csv());
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch01_carts_sketch", "The picture of the three carts", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}
