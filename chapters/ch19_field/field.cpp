// Chapter 19 - Five methods on the block of chapter 1, each over six decades of its parameter.
// Run:  make ch19     Reads: nothing     Writes: ch19.results, methods.md, fig_19_2_penalty.csv,
//      fig_19_2_uzawa.csv, fig_19_2_augmented.csv, fig_19_2_nitsche.csv, fig_19_2_active.csv
#include <iostream>

#include "error.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch19;

const Index rows = 8, fine_rows = 64;

struct Ways {
  Pressed block = on_round(rows);
  MatrixXd G = compliance(block);
  Answer exact = active_set(block, G);
  Reference fine = reference(fine_rows);
};

enum class Way { Penalty, Uzawa, Augmented, Nitsche };

Answer ask(const Ways& ways, Way way, double parameter) {
  const double value = parameter * ways.block.unit;
  if (way == Way::Penalty) return penalty(ways.block, value);
  if (way == Way::Uzawa) return uzawa(ways.block, ways.G, value);
  if (way == Way::Augmented) return augmented_lagrangian(ways.block, value);
  return nitsche(ways.block, value);
}

// Of the last matrix that the method factors.
double condition_of(const Ways& ways, Way way, double parameter, const Answer& answer) {
  const double value = parameter * ways.block.unit;
  if (way == Way::Uzawa) return condition(ways.block.K);
  if (way == Way::Nitsche)
    return condition(
        nitsche_matrix(ways.block, side_points(ways.block), value, answer.force.array() > 0));
  SparseMatrix K = ways.block.K;
  for (Index i = 0; i < answer.force.size(); ++i)
    if (answer.force(i) > 0) {
      const Index unknown = ways.block.up[std::size_t(i)];
      K.coeffRef(unknown, unknown) += value * ways.block.weight(i);
    }
  return condition(K);
}

struct Reading {
  double error, away, condition;  // of the true solution, of the active set, of the matrix
  Index passes;
  bool ended;
  double force;
};

Reading read(const Ways& ways, Way way, double parameter) {
  const Answer answer = ask(ways, way, parameter);
  return {ways.fine.error(ways.block, answer.u),
          difference(ways.block, answer.u, ways.exact.u),
          condition_of(ways, way, parameter, answer),
          answer.passes,
          answer.ended,
          answer.force.sum()};
}

// A row for every parameter at which the method ends and its matrix is positive definite.
void sweep(const ProgramOptions& run, const Ways& ways, Way way, const std::string& name,
           Results& results) {
  Table curve({"parameter", "error", "away", "condition", "passes"});
  double first = 0, last = 0;
  for (int step = -8; step <= 16; ++step) {
    const double parameter = std::pow(10, step / 4.0);
    const Reading now = read(ways, way, parameter);
    if (!now.ended || now.condition <= 0) continue;
    curve.row({parameter, now.error, now.away, now.condition, double(now.passes)});
    if (first == 0) first = parameter;
    last = parameter;
  }
  results.add(name + "_from", first, "-");
  results.add(name + "_to", last, "-");
  write_file(run.out / ("fig_19_2_" + name + ".csv"), curve.csv("rel 1e-4 abs 1e-11"));
}

// Where steps are too long for Uzawa, and gamma too small for Nitsche.
void limits(const Ways& ways, Results& results) {
  const VectorXd k = ways.block.weight.cwiseSqrt() * std::sqrt(ways.block.unit);
  const MatrixXd scaled = k.asDiagonal() * ways.G * k.asDiagonal();
  std::vector<Index> closed;
  for (Index i = 0; i < k.size(); ++i)
    if (ways.exact.force(i) > 0) closed.push_back(i);
  const auto limit = [](const MatrixXd& part) {
    return 2 / Eigen::SelfAdjointEigenSolver<MatrixXd>(part).eigenvalues().maxCoeff();
  };
  results.add("uzawa_limit", limit(scaled), "-");
  results.add("uzawa_limit_closed", limit(scaled(closed, closed)), "-");
  results.add("nitsche_bound", inverse_inequality(ways.block) / ways.block.unit, "-");
}

Table compare(const Ways& ways) {
  Table table({"method and parameter", "error [%]", "from the active set [%]", "condition",
               "passes", "total force [N]"});
  const auto row = [&](const std::string& name, const Reading& now) {
    table.row({name, number(100 * now.error, "%.1f"), number(100 * now.away, "%.3f"),
               number(now.condition, "%.0f"), number(double(now.passes)),
               number(now.force, "%.3f")});
  };
  row("active set", {ways.fine.error(ways.block, ways.exact.u), 0, condition(ways.block.K),
                     ways.exact.passes, true, ways.exact.force.sum()});
  for (const double parameter : {1.0, 10.0, 1000.0})
    row("penalty, " + number(parameter), read(ways, Way::Penalty, parameter));
  row("Uzawa, 0.2", read(ways, Way::Uzawa, 0.2));
  for (const double parameter : {1.0, 10.0, 1000.0})
    row("augmented Lagrangian, " + number(parameter), read(ways, Way::Augmented, parameter));
  for (const double parameter : {10.0, 1000.0})
    row("Nitsche, " + number(parameter), read(ways, Way::Nitsche, parameter));
  return table;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch19");
  const Ways ways;
  sweep(run, ways, Way::Penalty, "penalty", results);
  sweep(run, ways, Way::Uzawa, "uzawa", results);
  sweep(run, ways, Way::Augmented, "augmented", results);
  sweep(run, ways, Way::Nitsche, "nitsche", results);
  const double error = ways.fine.error(ways.block, ways.exact.u);
  Table line({"parameter", "error", "condition", "passes"});
  for (const double parameter : {1e-2, 1e4})
    line.row({parameter, error, condition(ways.block.K), double(ways.exact.passes)});
  write_file(run.out / "fig_19_2_active.csv", line.csv("rel 1e-4 abs 1e-11"));
  limits(ways, results);
  results.add("error", 100 * error, "%");
  results.add("condition_of_K", condition(ways.block.K), "-");
  results.add("force", ways.exact.force.sum(), "N");
  results.add("fine_force", ways.fine.answer.force.sum(), "N");
  results.headline("force", ways.fine.answer.force.sum(), "128 x 64 cells");
  const Table table = compare(ways);
  std::cout << table.markdown();
  write_file(run.out / "methods.md", table.markdown());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch19", "Five ways to close a gap", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
