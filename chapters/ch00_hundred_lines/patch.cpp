// Chapter 0 - The patch test, and the same matrix from the library.
// Run:  make ch00     Reads: nothing     Writes: ch00_patch.results, fig_0_4.csv, fig_0_4_after.csv
#include "outline.hpp"
#include "patch_test.hpp"
#include "signorini/fem/assembly.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch00;
using namespace signorini;

// The library's K of the same cells: no unknown is held, and both number x, y of node 0, 1, ...
SparseMatrix of_library(const ch00::Mesh& mesh, double E, double nu) {
  signorini::Mesh same = block("patch", {0, 0}, {3, 3}, 3, 3);
  same.nodes = mesh.nodes;
  const Material rubber{E, nu, PlaneState::Stress};
  return signorini::assemble(same, q4(), rubber, number_unknowns(same, {}), {}).stiffness;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch00_patch");
  const ch00::Mesh mesh = crooked_patch();
  const Matrix3d D = plane_stress(10, 0.3);
  const Matrix2d F = (Matrix2d() << 0.10, 0.06, /**/ 0.02, -0.05).finished();
  const VectorXd u = patch_test(mesh, D, F);
  write_file(run.out / "fig_0_4.csv", outline(mesh, mesh.nodes));
  write_file(run.out / "fig_0_4_after.csv", outline(mesh, moved(mesh, u)));
  results.add("patch_error", patch_error(mesh, u, F), "mm", Repeats::No);
  const SparseMatrix K = ch00::assemble(mesh, D), theirs = of_library(mesh, 10, 0.3);
  results.add("entries", double(K.nonZeros()), "-");
  results.add("differs_from_library", (K - theirs).norm() / K.norm(), "-", Repeats::No);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch00_patch", "The patch test", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}
