// Chapter 9 - The equations of one element as printed and repaired (Lin et al., sec. 2.3, eqs. 28-31).
// Run:  make ch09     Reads: nothing     Writes: ch09_printed.results, printed.md
#include <Eigen/LU>
#include <cmath>
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

const Nodes X = (Nodes() << 4, 0, 0, 3, 3, 1.5).finished();  // [mm]

// 1. Newton's method with full steps.
/// Where full Newton steps end.
struct End {
  Vector10d x;
  int steps = 0;
  double residual = 0;
  bool solved = false;
};

End solved(const ContactElement& element, Vector10d x) {
  End end;
  for (int k = 0; k <= 60; ++k) {
    const System at = equations(element, x);
    end = {x, k, at.residual.cwiseAbs().maxCoeff(), false};
    end.solved = end.residual <= 1e-12;
    if (end.solved || !std::isfinite(end.residual)) break;
    x -= at.jacobian.fullPivLu().solve(at.residual);
  }
  return end;
}

// 2. The equations of one element as printed and repaired.
void as_printed(const ProgramOptions& run) {
  const Place at = projected(X);
  ContactElement element{X, (Vector6d() << 10, 10, 10, 10, 5, 5).finished(), Vector6d::Zero(), 0.3,
                         0};
  Vector10d start = Vector10d::Zero();
  start(6) = 1;
  Table table({"shear load", "c", "bound", "upper right block", "ends", "f_n", "τ", "u⁺", "u⁻"});
  for (const auto& [shear, cohesion] :
       {std::pair(0.5, 0.0), std::pair(4.0, 0.0), std::pair(4.0, 1.0)})
    for (const auto& [bound, reaction] : {std::pair(1, -1), std::pair(-1, -1), std::pair(1, 1)}) {
      if (shear < 1 && (bound < 0 || reaction > 0)) continue;  // once is enough
      element.load.tail(2) = -6 * at.n + shear * at.t;
      element.cohesion = cohesion;
      element.bound = bound;
      element.reaction = reaction;
      const End end = solved(element, start);
      std::vector<std::string> row = {number(shear), number(cohesion),
                                      bound > 0 ? "c + μ f_n" : "c - μ f_n",
                                      reaction < 0 ? "-a" : "a"};
      row.push_back(end.solved           ? text("after ", end.steps)
                    : end.residual > 1e6 ? "runs away"
                                         : text("never, residual ", number(end.residual, "%.1f")));
      for (Index i = 6; i < 10; ++i)
        row.push_back(end.solved ? number(std::abs(end.x(i)) < 1e-9 ? 0 : end.x(i), "%.3f") : "");
      table.row(row);
    }
  std::cout << table.markdown();
  write_file(run.out / "printed.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch09_printed");
  as_printed(run);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch09_printed", "The equations as printed", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
