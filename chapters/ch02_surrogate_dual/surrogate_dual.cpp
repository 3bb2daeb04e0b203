// Chapter 2 - The surrogate dual (Xuan & Li 2002, sec. 2.1, eqs. 14-24).
// Run:  make ch02     Reads: nothing     Writes: ch02.results, vertices.md
#include "papers/surrogate_dual.hpp"

#include <iostream>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "three_candidates.hpp"

namespace {

using namespace ch02;

// 1. One weighted gap after another: all weight on one pair, equal weights, and the best ones.
void try_weights(const ProgramOptions& run, const Block& block) {
  const ContactProblem& problem = block.problem;
  Table table({"all weight on", "overlap $`b^T\\xi`$ [mm]", "$`\\eta`$ [N]", "$`s`$ [N mm]"});
  const auto row = [&](const char* name, const VectorXd& xi) {
    const Trade found = trade(problem, xi);
    table.row({name, number(-problem.free_gap.dot(xi), "%.3f"), number(found.force, "%.3f"),
               number(found.energy, "%.3f")});
  };
  row("left", Vector3d(1, 0, 0));
  row("middle", Vector3d(0, 1, 0));
  row("right", Vector3d(0, 0, 1));
  row("each a third", VectorXd::Constant(3, 1.0 / 3));
  row("as the forces", shares(block));
  write_file(run.out / "vertices.md", table.markdown());
  std::cout << table.markdown();
}

// 2. Strong duality: the best weights give the forces, and the energy of the solution.
void strong_duality(const Block& block, Results& results) {
  // [strong]
  const QuadraticProgramme& programme = block.programme;
  const VectorXd none = VectorXd::Zero(3);
  const VectorXd weights = shares(block);
  const Trade best = trade(block.problem, weights);  // (23), (24)
  const VectorXd u = block.factor.solve(             // (22)
      programme.load - best.force * (programme.A.transpose() * weights));
  const double energy = lagrangian(programme, u, none);  // pi(u)
  const double free_energy = lagrangian(programme, block.free_displacement, none);
  const double lost = best.energy + free_energy - energy;  // between (24) and (11)
  // [strong]
  results.add("duality_gap", lost, "N*mm", Repeats::No);
  results.add("energy", energy, "N*mm");
  results.add("free_energy", free_energy, "N*mm");
  results.add("best_s", best.energy, "N*mm");
  results.add("total_contact_force", best.force, "N");
  for (Eigen::Index i = 0; i < 3; ++i) results.add(text("weight_", i + 1), weights(i), "-");
  results.headline("best_s", energy - free_energy,
                   "energy of the solution above that without contact");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch02");
  const Block block = pressed_block();
  try_weights(run, block);
  strong_duality(block, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch02", "The surrogate dual", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}
