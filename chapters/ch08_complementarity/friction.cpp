// Chapter 8 - Friction of one pair, by halves (Lin et al., sec. 2.2, eqs. 13-19).
// Run:  make ch08     Reads: nothing     Writes: ch08_friction.results, split.md,
//       fig_8_3.csv
#include <cmath>
#include <iostream>

#include "one_pair.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::Vector2d;
using Eigen::Vector4d;
using Eigen::VectorXd;

// 1. Friction of one pair by the split, from two starts, and by one equation.
/// \PaperEq{LinEtAl, 13} to \PaperEq{LinEtAl, 19}
void one_pair(const ProgramOptions& run, Results& results) {
  Table table({"pair", "friction", "u⁺ from 0", "u⁺ from 1", "singular value from 0", "from 1",
               "of one equation"});
  const auto cell = [](double x) { return number(std::abs(x) < 1e-9 ? 0 : x, "%.3f"); };
  for (const NamedPair& on : one_pairs) {
    const End from0 = solved(split, on.pair, Vector4d(1, 0, 0, 0));
    const End from1 = solved(split, on.pair, Vector4d(1, 0, 1, 1));
    const End one = solved(one_equation, on.pair, Vector2d(1, 0));
    table.row({on.name, cell(one.x(1)), cell(from0.x(2)), cell(from1.x(2)), cell(from0.smallest),
               cell(from1.smallest), cell(one.smallest)});
  }
  std::cout << table.markdown();
  write_file(run.out / "split.md", table.markdown());
  const OnePair open = one_pairs[3].pair;
  results.add("free_part_1", solved(split, open, Vector4d(1, 0, 1, 1)).x(3), "-");
  results.add("free_part_2", solved(split, open, Vector4d(1, 0, 2, 2)).x(3), "-", Repeats::No);
  const OnePair lifted = one_pairs[4].pair;
  results.add("lifted_gap", lifted.free_gap, "-");
  results.add("lifted_friction", solved(split, lifted, Vector4d(1, 0, 0, 0)).x(1), "-");
  Table dots({"free_slip", "slip", "friction"});
  for (const double s : {-1.5, -1.1, -0.4, 0.0, 0.4, 1.1, 1.5}) {
    const VectorXd x = solved(split, {-1, s, 0.5, 0.2}, Vector4d(1, 0, 0, 0)).x;
    dots.row({s, x(2) - x(3), x(1)});
  }
  write_file(run.out / "fig_8_3.csv", dots.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch08_friction");
  one_pair(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch08_friction", "Friction by halves", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
