// Chapter 19 - The block on a flat obstacle, where every method has a closed form.
// Run:  make ch19     Reads: nothing     Writes: ch19_flat.results, flat.md, fig_19_1.csv
#include <iostream>

#include "methods.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch19;

const double nu = rubber.poisson_ratio;
const double stiff = rubber.youngs_modulus / (1 - nu * nu) / height;  // of the block [N/mm^3]
const double overlap = -flat_gap(0);                                  // without contact [mm]
const double pressure = overlap * stiff;                              // of the solution [N/mm^2]

// The pressure over that of the solution; it is uniform.
double share(const Answer& answer) { return answer.force.sum() / (pressure * width); }

// 1. Pass by pass: parameters are given as parts of the block's own stiffness.
void passes(const ProgramOptions& run, const Pressed& block, const MatrixXd& G) {
  Table curve({"pass", "short", "long", "too_long", "augmented", "penalty"});
  const double soft = share(penalty(block, 2 * stiff));
  for (Index pass = 0; pass <= 8; ++pass)
    curve.row({double(pass), share(uzawa(block, G, 0.5 * stiff, pass)),
               share(uzawa(block, G, 1.6 * stiff, pass)), share(uzawa(block, G, 2.2 * stiff, pass)),
               share(augmented_lagrangian(block, 2 * stiff, pass)), pass == 0 ? 0 : soft});
  write_file(run.out / "fig_19_1.csv", curve.csv());
}

// 2. Penetration of the penalty, beside p / epsilon.
Table penetrations(const Pressed& block, Results& results) {
  Table table({"stiffness over that of the block", "pressure [N/mm²]", "penetration [mm]",
               "pressure over stiffness [mm]"});
  double worst = 0;
  for (const double times : {1.0, 10.0, 100.0, 1000.0}) {
    const Answer now = penalty(block, times * stiff);
    const double p = now.force.sum() / width;
    const double depth = -(block.free_gap + opening(block, now.u)).minCoeff();
    table.row({number(times), number(p, "%.5f"), number(depth, "%.6f"),
               number(p / (times * stiff), "%.6f")});
    worst = std::max(worst, std::abs(depth * times * stiff / p - 1));
  }
  results.add("penalty_off", worst, "-", Repeats::No);
  return table;
}

// 3. The largest error of the pressure by Nitsche's method, from just above its bound.
double nitsche_off(const Pressed& block) {
  double worst = 0;
  for (const double times : {1.01, 10.0, 1000.0})
    worst = std::max(worst, std::abs(share(nitsche(block, times * inverse_inequality(block))) - 1));
  return worst;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch19_flat");
  const Pressed block = on_flat(4);
  const MatrixXd G = compliance(block);
  passes(run, block, G);
  const Table table = penetrations(block, results);
  results.add("nitsche_off", nitsche_off(block), "-", Repeats::No);
  results.add("stiff", stiff, "N/mm^3");
  results.add("pressure", active_set(block, G).force.sum() / width, "N/mm^2");
  std::cout << table.markdown();
  write_file(run.out / "flat.md", table.markdown());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch19_flat", "Five closed forms", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}
