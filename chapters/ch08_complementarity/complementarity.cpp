// Chapter 8 - Contact as complementarity (Lin et al., secs. 2.1 and 2.2, eqs. 1-12).
// Run:  make ch08     Reads: nothing     Writes: ch08.results, functions.md,
//       fig_8_1.csv
#include <cmath>

#include "functions.hpp"
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
using Eigen::Vector3d;

// 1. What acts on a face of the source, and whether Coulomb's law lets it stick.
/// \PaperEq{LinEtAl, 5} to \PaperEq{LinEtAl, 10}
void face(Results& results) {
  const double mu = 0.3, cohesion = 0;
  const Traction on = traction(Vector3d(-2, -6, 1), Vector2d(0.6, -0.8));  // sigma [MPa], n
  const double bound = cohesion - mu * on.normal;                          // (6)
  const bool sticks = on.tangential.norm() < bound;                        // (9), else (10)
  results.add("normal_stress", on.normal, "MPa");
  results.add("pressure", -on.normal, "MPa");
  results.add("shear_stress", on.tangential.norm(), "MPa");
  results.add("bound", bound, "MPa");
  results.add("sticks", sticks ? 1 : 0, "-");
}

// 2. Complementarity functions: zero where they should be, slopes, level lines.
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
  write_file(run.out / "fig_8_1.csv", levels.csv());
}

// 3. One equation for each of forty pairs, against a method that knows nothing of such functions.
/// \PaperEq{LinEtAl, 11}, \PaperEq{LinEtAl, 12}
void forty_pairs(Results& results) {
  const ContactProblem cylinder = pressed_cylinder();
  results.add("largest_force", fischer_burmeister(cylinder).force.maxCoeff(), "N");
  results.headline("largest_force",
                   find_solver("quasi_active_set").solve(cylinder, {}).force.maxCoeff(),
                   "by an active set");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch08");
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
