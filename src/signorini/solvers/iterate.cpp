#include "signorini/solvers/iterate.hpp"

#include <utility>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/contact_equations.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void Iterate::stop(SolveStatus status, const char* why) {
  report.status = status;
  if (why != nullptr) reason = why;
}

void Iterate::solve(const ScaledProblem& problem, const ActiveSet& set,
                    const ActiveSetSolution* start) {
  report.factorisations += set.closed.empty() ? 0 : 1;
  ++report.iterations;
  solution = solve_active_set(problem, set, start);
}

Iterate first_iterate(const ScaledProblem& problem) {
  const Index pairs = problem.pairs();
  const MatrixXd& U = problem.rigid;
  Iterate iterate;
  ActiveSetSolution& now = iterate.solution;
  now.force.setZero(problem.free.size());
  now.amplitude.setZero(U.cols());
  double unit = force_scale(problem);
  if (U.cols() > 0) {
    unit = ContactEquations(problem, nested_friction).force_scale();
    now.force = U * problem.resultant;
    now.amplitude = -U.transpose() * (problem.free + problem.compliance * now.force);
  } else if (!problem.law.pair.empty() && problem.symmetric && problem.sparse.size() == 0) {
    const ContactState normal =
        goldfarb_idnani({problem.compliance.topLeftCorner(pairs, pairs), problem.free.head(pairs)});
    if (normal.report.status == SolveStatus::Solved) now.force.head(pairs) = normal.force;
  }
  now.movement = problem.free + problem.compliance * now.force;
  VectorXd size = problem.free.cwiseAbs() + problem.compliance.cwiseAbs() * now.force.cwiseAbs();
  if (U.cols() > 0) {
    now.movement += U * now.amplitude;
    size += U.cwiseAbs() * now.amplitude.cwiseAbs();
  }
  // A pair that touches is open until something presses it, whatever rounding says of its gap.
  now.movement_rounding = static_cast<double>(size.size() + U.cols() + 1) * epsilon * size;
  iterate.statuses = statuses_of({}, pairs);
  predict(problem, now, unit, iterate.statuses);
  return iterate;
}

Iterate iterate_from(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses) {
  Iterate iterate;
  iterate.solution.force.setZero(problem.free.size());
  iterate.solution.movement = problem.free;
  iterate.solution.amplitude.setZero(problem.rigid.cols());
  iterate.statuses = statuses;
  return iterate;
}

ContactState finished(const ContactProblem& problem, const ScaledProblem& scaled, Iterate iterate) {
  Report& report = iterate.report;
  if (iterate.confirmed) {
    report.status = SolveStatus::Solved;
    iterate.reason.clear();
  } else if (report.status == SolveStatus::Solved) {
    report.status = SolveStatus::Breakdown;  // of another problem that was solved on the way
  }
  ContactState state =
      finished(problem, scaled, iterate.solution, iterate.statuses, std::move(report));
  if (state.reason.empty()) state.reason = std::move(iterate.reason);
  return state;
}

}  // namespace signorini
