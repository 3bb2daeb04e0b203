// Chapter 0 - The matrix of one square, and of two squares side by side, as pictures.
// Run:  make ch00     Reads: nothing     Writes: ch00_element.results, fig_0_1.csv, fig_0_2.csv
#include "finite_elements.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch00;
using namespace signorini;

// Rows from above, entries in twenty-fourths of E times the thickness.
std::string picture(const Eigen::MatrixXd& K) {
  Table entries({"column", "row", "entry"});
  for (Index i = 0; i < K.rows(); ++i)
    for (Index j = 0; j < K.cols(); ++j)
      entries.row({double(j + 1), double(i + 1), std::round(24 * K(i, j)) + 0.0});
  return entries.csv();
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch00_element");
  const Matrix3d D = plane_stress(1, 0);
  const ch00::Mesh one = rectangle(1, 1, 1, 1), two = rectangle(2, 1, 2, 1);
  const ElementMatrix K = element_stiffness(one.nodes(one.cells.row(0), Eigen::all), D);
  const Eigen::MatrixXd both = assemble(two, D);
  write_file(run.out / "fig_0_1.csv", picture(K));
  write_file(run.out / "fig_0_2.csv", picture(both));
  const auto rank = [](const Eigen::MatrixXd& matrix) {
    const auto values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    return double((values.array() > 1e-12 * values.maxCoeff()).count());
  };
  results.add("corner", 24 * K(0, 0), "-");
  results.add("middle", 24 * both(2, 2), "-");
  results.add("rank_of_one", rank(K), "-");
  results.add("rank_of_two", rank(both), "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch00_element", "The matrix of one square", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}
