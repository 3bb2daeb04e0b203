// Chapter 0 - A block of rubber that is held at its left side and pulled down at its right one.
// Run:  make ch00     Reads: nothing     Writes: ch00.results, bracket.md, fig_0_3.csv,
//      fig_0_3_before.csv
#include "outline.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch00;
using namespace signorini;

const double length = 40, height = 20;  // of the block, which is 1 mm thick [mm]
const double E = 10, nu = 0.3;          // of rubber, as in chapter 1 [N/mm^2], [-]
const double pull = 0.5;                // at its right side, downwards [N]

// [bracket]
struct Bracket {
  ch00::Mesh mesh;
  VectorXd u;         // x, y of every node [mm]
  VectorXd reaction;  // of the support, zero elsewhere [N]
};

Bracket bracket(Index across, Index up) {
  Bracket now{rectangle(length, height, across, up), {}, {}};
  Held held;
  std::vector<Index> right;
  for (Index node = 0; node < now.mesh.nodes.rows(); ++node) {
    if (now.mesh.nodes(node, 0) == 0) held[2 * node] = held[2 * node + 1] = 0;
    if (now.mesh.nodes(node, 0) == length) right.push_back(node);
  }
  const VectorXd load = side_load(now.mesh, right, 0, -pull / height);
  const SparseMatrix K = assemble(now.mesh, plane_stress(E, nu));
  now.u = solve(K, load, held);
  now.reaction = K * now.u - load;
  return now;
}
// [bracket]

// How far the middle of the right side goes down, of a block with an even number of cells up [mm].
double tip(const Bracket& now, Index across, Index up) {
  return -now.u(2 * (up / 2 * (across + 1) + across) + 1);
}

// By the theory of beams: bending, and shear with 5/6 of the section.
double tip_of_beam() {
  const double I = std::pow(height, 3) / 12, G = E / (2 * (1 + nu));
  return pull * std::pow(length, 3) / (3 * E * I) + pull * length / (5.0 / 6 * G * height);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch00");
  Table table({"cells", "unknowns", "tip moves down [mm]", "less than the beam [%]"});
  for (const Index up : {2, 4, 8, 16, 32}) {
    const Bracket now = bracket(2 * up, up);
    const double down = tip(now, 2 * up, up);
    table.row({number(double(2 * up)) + " × " + number(double(up)),
               number(double(now.u.size() - 2 * (up + 1))), number(down, "%.4f"),
               number(100 * (1 - down / tip_of_beam()), "%.1f")});
    if (up == 4) {
      write_file(run.out / "fig_0_3.csv", outline(now.mesh, moved(now.mesh, now.u)));
      write_file(run.out / "fig_0_3_before.csv", outline(now.mesh, now.mesh.nodes));
      results.add("tip_coarse", down, "mm");
    }
    if (up == 32) {
      results.add("tip", down, "mm");
      double up_force = 0;
      for (Index i = 1; i < now.reaction.size(); i += 2) up_force += now.reaction(i);
      results.add("reaction", up_force, "N");
    }
  }
  results.add("tip_of_beam", tip_of_beam(), "mm");
  results.headline("tip", tip_of_beam(), "a beam with shear");
  write_file(run.out / "bracket.md", table.markdown());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch00", "A finite element program in a hundred lines",
                                SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
