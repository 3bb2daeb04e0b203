// Chapter 8 - Newton's method with five complementarity functions (Lin et al., sec. 2.2, eqs. 11, 12).
// Run:  make ch08     Reads: nothing     Writes: ch08_newton.results, newton.md
#include <algorithm>
#include <cmath>
#include <iostream>

#include "functions.hpp"
#include "papers/examples.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"

namespace {

using namespace signorini;
using Eigen::Vector2d;
using Eigen::VectorXd;

// 1. Problems that are easy, degenerate, and hard.
/// A stretched string that sags onto a rigid wave: n pairs that all act on each other.
ContactProblem string_over_wave(Eigen::Index n) {
  ContactProblem string{Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n + 2, 0, 1).segment(1, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    string.free_gap(i) = std::cos(9 * x(i)) - 0.2;
    for (Eigen::Index j = 0; j < n; ++j)
      string.compliance(i, j) = std::min(x(i), x(j)) * (1 - std::max(x(i), x(j)));
  }
  return string;
}

struct Named {
  const char* name;
  ContactProblem problem;
};

const std::vector<Named> problems = {
    {"one pair", {Eigen::MatrixXd::Ones(1, 1), -Eigen::VectorXd::Ones(1)}},
    {"touching", {(Eigen::Matrix2d() << 2, 1, 1, 2).finished(), Eigen::Vector2d(-2, -1)}},
    {"in a circle",
     {(Eigen::Matrix3d() << 4, -6, -4, -6, 10, 8, -4, 8, 9).finished(),
      Eigen::Vector3d(3, -4, -1)}},
    {"string", string_over_wave(40)},
    {"half-plane", half_plane_indentation(40).problem}};

// 2. Newton's method with each of them, from zero forces.
/// \PaperEq{LinEtAl, 11}, \PaperEq{LinEtAl, 12}
void compare(const ProgramOptions& run, Results& results) {
  Table table({"", "one pair", "touching", "in a circle", "string", "half-plane"});
  for (const ComplementarityFunction& phi : functions) {
    std::vector<std::string> row = {phi.name};
    for (const Named& on : problems) {
      const NewtonRun way = newton(on.problem, phi, 0 * on.problem.free_gap, {1e-10, 0});
      row.push_back(way.ended ? std::to_string(way.steps()) : "-");
    }
    table.row(row);
  }
  std::vector<std::string> row = {"the library's method"};
  for (const Named& on : problems) {
    const ContactState state = fischer_burmeister(on.problem);
    if (state.report.status != SolveStatus::Solved) throw NotSolved(text(on.name, ": not solved"));
    row.push_back(std::to_string(state.report.iterations));
  }
  table.row(row);
  std::cout << table.markdown();
  write_file(run.out / "newton.md", table.markdown());
  const NewtonRun touch = newton(problems[1].problem, functions.back(), Vector2d(0, 0), {1e-10, 0});
  results.add("smooth_residual", touch.residuals.back(), "-");
  results.add("smooth_error", (touch.forces.back() - Vector2d(1, 0)).norm(), "-");

  const NewtonRun way =
      newton(problems[0].problem, functions[0], VectorXd::Constant(1, 4), {1e-10, 0});
  for (std::size_t k = 1; k <= 4; ++k) results.add(text("path_", k), way.forces[k](0), "-");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch08_newton");
  compare(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch08_newton", "Newton's method with a kink", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}
