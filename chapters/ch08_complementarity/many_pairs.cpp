// Chapter 8 - Friction on forty pairs, of which many are open (Lin et al., sec. 2.2, eqs. 15-19).
// Run:  make ch08     Reads: nothing     Writes: ch08_many_pairs.results, methods.md
#include <algorithm>
#include <iostream>

#include "one_pair.hpp"
#include "papers/examples.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::VectorXd;

// 1. The problem.
/// The half-plane, dragged along by a shift of the punch with mu = 0.3. A half-plane that does not change its
/// volume gives way along its surface as it does across it, and the two do not mix.
ContactProblem sheared(double shift) {
  const ContactProblem pressed = half_plane_indentation(40).problem;
  const Eigen::Index n = pressed.free_gap.size();
  ContactProblem problem{Eigen::MatrixXd::Zero(2 * n, 2 * n), pressed.free_gap,
                         Eigen::VectorXd::Constant(n, shift),
                         law_of_all(Eigen::VectorXd::Constant(n, 0.3), Eigen::VectorXd::Zero(n))};
  problem.compliance.topLeftCorner(n, n) = pressed.compliance;
  problem.compliance.bottomRightCorner(n, n) = pressed.compliance;
  return problem;
}

// 2. The library's methods for friction, on the lifted pair and on 40 pairs, of which many are open.
void compare_friction(const ProgramOptions& run, Results& results) {
  const auto one = [](double x) { return VectorXd::Constant(1, x); };
  const OnePair& lifted = one_pairs.back().pair;
  const std::vector<ContactProblem> all = {
      {Eigen::MatrixXd::Identity(2, 2), one(lifted.free_gap), one(lifted.free_slip),
       law_of_all(one(lifted.mu), one(lifted.cohesion))},
      sheared(0.02),
      sheared(0.05),
      sheared(0.1)};
  Table table({"", "open, cohesion", "shift 0.02", "shift 0.05", "shift 0.1"});
  std::vector<std::string> counts = {"open, stick, slide"};
  for (const char* name : {"primal_dual_active_set", "lemke", "fischer_burmeister",
                           "friction_split", "friction_split_literal"}) {
    const Solver& solver = find_solver(name);
    std::vector<std::string> row = {name};
    for (const ContactProblem& problem : all) {
      const ContactState state = solver.solve(problem, {});
      const bool solved = state.report.status == SolveStatus::Solved;
      row.push_back(solved ? std::to_string(state.report.iterations)
                           : to_string(state.report.status));
      if (counts.size() > all.size()) continue;  // the first member is enough
      const auto of = [&](ContactStatus s) {
        return std::count(state.contact_status.begin(), state.contact_status.end(), s);
      };
      counts.push_back(text(of(ContactStatus::Open), ", ", of(ContactStatus::Stick), ", ",
                            of(ContactStatus::SlipForward) + of(ContactStatus::SlipBackward)));
      results.add(text("open_pairs_", counts.size() - 1),
                  static_cast<double>(of(ContactStatus::Open)), "-");
    }
    table.row(row);
  }
  table.row(counts);
  std::cout << table.markdown();
  write_file(run.out / "methods.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch08_many_pairs");
  compare_friction(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch08_many_pairs", "Friction on forty pairs", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}
