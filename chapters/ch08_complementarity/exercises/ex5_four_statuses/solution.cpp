#include <set>

#include "exercise.hpp"
#include "signorini/core/dense.hpp"

namespace ex8_5 {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

std::vector<Status> statuses_at(const Problem& problem, double c, const VectorXd& force,
                                const VectorXd& friction) {
  const Index n = force.size();
  VectorXd all(2 * n);
  all << force, friction;
  const VectorXd moved = problem.compliance * all;
  std::vector<Status> statuses(static_cast<std::size_t>(n), Status::Open);
  for (Index i = 0; i < n; ++i) {
    const double pressed = force(i) - c * (problem.free_gap(i) + moved(i));
    if (!(pressed > 0)) continue;
    const double bound = problem.mu * pressed;
    const double trial = friction(i) - c * (problem.free_slip(i) + moved(n + i));
    statuses[static_cast<std::size_t>(i)] = trial > bound    ? Status::Backward
                                            : trial < -bound ? Status::Forward
                                                             : Status::Stick;
  }
  return statuses;
}

VectorXd forces_of(const Problem& problem, const std::vector<Status>& statuses) {
  const Index n = problem.free_gap.size();
  Eigen::MatrixXd rows = Eigen::MatrixXd::Identity(2 * n, 2 * n);
  VectorXd right = VectorXd::Zero(2 * n);
  for (Index i = 0; i < n; ++i) {
    const Status status = statuses[static_cast<std::size_t>(i)];
    if (status == Status::Open) continue;
    rows.row(i) = problem.compliance.row(i);
    right(i) = -problem.free_gap(i);
    if (status == Status::Stick) {
      rows.row(n + i) = problem.compliance.row(n + i);
      right(n + i) = -problem.free_slip(i);
    } else {
      rows(n + i, i) = status == Status::Forward ? problem.mu : -problem.mu;
    }
  }
  return signorini::LuFactor(rows).solve(right);
}

Answer semismooth(const Problem& problem, double c) {
  const Index n = problem.free_gap.size();
  Answer answer{VectorXd::Zero(n), VectorXd::Zero(n), {}, 0, false};
  answer.statuses = statuses_at(problem, c, answer.force, answer.friction);
  std::set<std::vector<Status>> seen;
  while (seen.insert(answer.statuses).second) {
    const VectorXd forces = forces_of(problem, answer.statuses);
    ++answer.steps;
    answer.force = forces.head(n);
    answer.friction = forces.tail(n);
    if (!forces.allFinite()) return answer;
    const std::vector<Status> next = statuses_at(problem, c, answer.force, answer.friction);
    answer.solved = next == answer.statuses;
    answer.statuses = next;
    if (answer.solved) return answer;
  }
  return answer;
}

}  // namespace ex8_5
