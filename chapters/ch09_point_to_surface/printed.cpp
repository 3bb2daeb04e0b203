// Chapter 9 - The equations of one element with one sign or another (Lin et al., sec. 2.3, eqs. 28-31).
// Run:  make ch09     Reads: nothing     Writes: ch09_printed.results, printed.md
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

// 1. The element of figure 9.1 on springs, pressed with 6 N and pulled along the edge.
ContactElement pressed(double shear, double cohesion, const Signs& sign) {
  const Place at = projected(X);
  ContactElement element{
      X, (Vector6d() << 10, 10, 10, 10, 5, 5).finished(), Vector6d::Zero(), 0.3, cohesion, sign};
  element.load.tail(2) = -6 * at.n + shear * at.t;
  return element;
}

Vector10d start(const Signs& sign) {
  Vector10d x = Vector10d::Zero();
  x(6) = sign.gap_row;  // pressed with 1 N, whatever f_n is
  return x;
}

// 2. Newton's method with f_n as a pressure, as a stress, and with all signs as printed.
struct Reading {
  const char* name;
  Signs sign;
};
const std::vector<Reading> readings = {
    {"pressure", as_pressure}, {"stress", as_stress}, {"as printed", as_printed}};

std::vector<std::string> row_of(double shear, double cohesion, const Reading& reading) {
  const End end = solved(pressed(shear, cohesion, reading.sign), start(reading.sign));
  std::vector<std::string> row = {number(shear), number(cohesion), reading.name};
  row.push_back(end.solved           ? text("after ", end.steps)
                : end.residual > 1e6 ? "runs away"
                                     : text("never, residual ", number(end.residual, "%.1f")));
  for (Index i = 6; i < 10; ++i)
    row.push_back(end.solved ? number(std::abs(end.x(i)) < 1e-9 ? 0 : end.x(i), "%.3f") : "");
  return row;
}

void one_sign(const ProgramOptions& run, Results& results) {
  Table table({"shear load", "c", "f_n is", "ends", "f_n", "τ", "u⁺", "u⁻"});
  for (const auto& [shear, cohesion] :
       {std::pair(0.5, 0.0), std::pair(4.0, 0.0), std::pair(4.0, 1.0)})
    for (const Reading& reading : readings) table.row(row_of(shear, cohesion, reading));
  std::cout << table.markdown();
  write_file(run.out / "printed.md", table.markdown());
  const End end = solved(pressed(4, 0, as_pressure), start(as_pressure));
  const End image = solved(pressed(4, 0, as_stress), start(as_stress));
  results.add("pressure_f_n", end.x(6), "N");
  results.add("steps", end.steps, "-");
  results.headline("pressure_f_n", -image.x(6), "minus that with f_n as a stress");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch09_printed");
  one_sign(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch09_printed", "The equations as printed", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
