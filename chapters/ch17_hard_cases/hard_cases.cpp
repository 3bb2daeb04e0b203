// Chapter 17 - Hard cases: the museum in tests/hard, and what certificate and refinement are worth.
// Run:  make ch17     Reads: tests/hard     Writes: ch17.results, museum.md, rooms.md, lies.md, fig_17_1*.csv, fig_17_2.csv
#include <numeric>

#include "papers/solver_table.hpp"
#include "signorini/report/program.hpp"
#include "tour.hpp"

namespace {

using namespace museum;
using namespace signorini;

// 1. Every exhibit, as it is posed.
std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const std::string& room : rooms())
    for (const Exhibit& exhibit : exhibits(SIGNORINI_CHAPTER_DATA "/../../tests/hard", room))
      all.push_back(open(exhibit));
  return all;
}

// 2. Everybody is asked about everything.
void visit(const std::vector<Case>& all, const ProgramOptions& run, Results& results) {
  const Tour found = tour(all);
  Table summary({"room", "exhibits", "solved", "refused or honest", "claims of others", "refuted"});
  Table places({"room", "begins", "ends"});  // in the figure
  int place = 0;
  for (const std::string& name : rooms()) {
    const Tally& room = found.rooms.at(name);
    summary.row({name, text(room.exhibits), text(room.solved), text(room.honest), text(room.claims),
                 text(room.refuted)});
    places.row({name, text(place), text(place + room.exhibits)});
    place += room.exhibits;
  }
  write_file(run.out / "museum.md", found.everything.markdown());
  write_file(run.out / "rooms.md", summary.markdown());
  write_file(run.out / "fig_17_1.csv", found.points.csv());
  write_file(run.out / "fig_17_1_rooms.csv", places.csv());
  const Tally& sum = found.rooms.at("");
  results.add("exhibits", sum.exhibits, "-");
  results.add("solved", sum.solved, "-");
  results.add("alone", sum.alone, "-");
  results.add("honest", sum.honest, "-");
  results.add("claims", sum.claims, "-");
  results.add("refuted", sum.refuted, "-");
}

// 3. The control: a solver that lies.
void control(const std::vector<Case>& all, const ProgramOptions& run, Results& results) {
  Table table({"the lie", "told", "caught"});
  Lies last;
  for (const double share : {1e-15, 1e-13, 1e-11, 1e-10, 1e-9}) {
    last = lie(all, share);
    table.row({number(share, "%.0e") + " of a force", text(last.told), text(last.caught)});
  }
  table.row({"a failure called solved", text(last.failures), text(last.unmasked)});
  write_file(run.out / "lies.md", table.markdown());
  results.add("lies", last.told + last.failures, "-");
  results.add("caught", last.caught + last.unmasked, "-");
  results.headline("caught", last.told + last.failures, "all lies");
}

// 4. Hilbert's matrix in whole numbers; x is 1 everywhere, and so are the forces on the first and the last.
// [hilbert]
DenseProgramme hilbert(Index n) {
  Index common = 1;
  for (Index k = 1; k < 2 * n; ++k) common = std::lcm(common, k);
  const MatrixXd K = MatrixXd::NullaryExpr(
      n, n, [&](Index i, Index j) { return static_cast<double>(common / (i + j + 1)); });
  VectorXd force = VectorXd::Zero(n), gap = VectorXd::Constant(n, 2);
  force(0) = force(n - 1) = 1;
  gap(0) = gap(n - 1) = 1;
  return {K, K.rowwise().sum() + force, MatrixXd::Identity(n, n), gap, 0};
}
// [hilbert]

// [ends]
void refine(const ProgramOptions& run) {
  Table curve({"condition", "plain", "plain_certificate", "refined", "refined_certificate"});
  const Solver& solver = find_solver("primal_dual_active_set");
  for (Index n = 2; n <= 10; ++n) {
    const DenseProgramme programme = hilbert(n);
    const DenseCondensed condensed = condense(programme);
    const VectorXd force = solver.solve(condensed.problem, {}).force;
    const VectorXd plain = condensed.factor.solve(programme.load - programme.A.transpose() * force);
    const DenseSolution refined = solve(programme, solver);
    const auto error = [](const VectorXd& x) { return (x.array() - 1).abs().maxCoeff(); };
    const VectorXd values = symmetric_eigenvalues(programme.stiffness);
    curve.row({values.maxCoeff() / values.minCoeff(), error(plain),
               certify(programme, {plain, {}, force}).worst(), error(refined.refined.displacement),
               refined.certificate.worst()});
  }
  // Errors of rounding differ from one compiler to the next, and by more than a factor.
  write_file(run.out / "fig_17_2.csv", curve.csv("rel 0.999 abs 1e-9"));
}
// [ends]

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch17");
  const std::vector<Case> all = all_cases();
  visit(all, run, results);
  control(all, run, results);
  refine(run);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch17", "Hard cases", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
