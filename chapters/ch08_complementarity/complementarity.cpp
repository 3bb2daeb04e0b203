// Chapter 8 - Contact as complementarity (Lin et al., secs. 2.1 and 2.2, eqs. 1-12).
// Run:  make ch08     Reads: nothing     Writes: ch08.results, functions.md,
//       fig_8_1.csv, fig_8_2.csv
#include <cmath>

#include "functions.hpp"
#include "laws.hpp"
#include "papers/solver_table.hpp"
#include "problems.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"

namespace {

using namespace signorini;
using Eigen::Vector2d;

// 1. Figure 8.1: two bodies, the places that their points face, and the line of mid-points.
/// The side of b is an arc about (2, -3), that of a one about (2, 2.6).
/// \param angle  of a point of a about the centre of a, from straight down
FacingPoints facing(double angle) {
  const Vector2d centre_a(2, 2.6), centre_b(2, -3), down(std::sin(angle), -std::cos(angle));
  const Vector2d x_a = centre_a + 2.1 * down, n_b = (x_a - centre_b).normalized();
  return {x_a, centre_b + 3.1 * n_b, Vector2d::Zero(), Vector2d::Zero(), n_b};
}

/// \return blocks of points: side of a, side of b, S_c; then a pair from (x, y) on b to a
Table two_bodies() {
  Table table({"x", "y"});
  for (const double part : {0.0, 1.0, 0.5}) {  // on a, on b, half-way
    for (int k = -10; k <= 10; ++k) {
      const FacingPoints at = facing(0.1 * k);
      const Vector2d x = (1 - part) * at.x_a + part * at.x_b;
      table.row({x.x(), x.y()});
    }
    table.blank_line();
  }
  const FacingPoints pair = facing(0.3);
  table.row({pair.x_b.x(), pair.x_b.y()});
  table.row({pair.x_a.x(), pair.x_a.y()});
  return table;
}

// 2. What acts on a face of the source, and whether Coulomb's law lets it stick.
void face(Results& results) {
  const Eigen::Vector3d sigma(-2, -6, 1);  // sigma_x, sigma_y, tau_xy [MPa]
  const Traction on = traction(sigma, {0.6, -0.8});
  const double along = on.normal, shear = on.tangential.norm();
  const double bound = shear_bound(0, 0.3, along);  // no cohesion
  const bool sticks = tangential_case(shear, 0, bound) == TangentialCase::Sticks;
  results.add("normal_stress", along, "MPa");
  results.add("pressure", -along, "MPa");
  results.add("shear_stress", shear, "MPa");
  results.add("bound", bound, "MPa");
  results.add("sticks", sticks ? 1 : 0, "-");
}

// 3. Complementarity functions: zero where they should be, slopes, level lines.
void compare_functions(const ProgramOptions& run) {
  Table table({"", "both 1", "-1 and 1", "both -1", "from (−1, −1) to (−2, −2)", "slope at (2, 0)",
               "slope at (0, 0)"});
  const auto pair = [](const ComplementaritySlope& s) {
    return text("(", number(s.a + 0.0, "%.3g"), ", ", number(s.b + 0.0, "%.3g"), ")");
  };
  for (const ComplementarityFunction& phi : functions) {
    table.row({phi.name, number(phi.value(1, 1), "%.3f"), number(phi.value(-1, 1), "%.3f"),
               number(phi.value(-1, -1), "%.3f"),
               text("times ", phi.value(-2, -2) / phi.value(-1, -1)), pair(phi.slope(2, 0)),
               pair(phi.slope(0, 0))});
  }
  write_file(run.out / "functions.md", table.markdown());
  Table levels({"a", "b", "phi"});
  for (int i = -20; i <= 20; ++i) {
    for (int j = -20; j <= 20; ++j)
      levels.row({0.1 * i, 0.1 * j, fischer_burmeister(0.1 * i, 0.1 * j)});
    levels.blank_line();
  }
  write_file(run.out / "fig_8_2.csv", levels.csv());
}

// 4. One equation for each of forty pairs, against a method that knows nothing of such functions.
void forty_pairs(Results& results) {
  const ContactProblem cylinder = pressed_cylinder();
  results.add("largest_force", fischer_burmeister(cylinder).force.maxCoeff(), "N");
  results.headline("largest_force",
                   find_solver("quasi_active_set").solve(cylinder, {}).force.maxCoeff(),
                   "by an active set");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch08");
  write_file(run.out / "fig_8_1.csv", two_bodies().csv());
  results.add("sketch_gap", gap_of(facing(0.3)), "-");
  face(results);
  compare_functions(run);
  forty_pairs(results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch08", "Contact as complementarity", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
