/// \file
/// The primal-dual active set, which is Newton's method for lambda = max(0, lambda - c gap), and friction as a return map.
#pragma once
#include <algorithm>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// The sets of closed pairs that a run went through, and where it ended.
struct SetRun {
  std::vector<std::vector<Eigen::Index>> sets;
  Eigen::VectorXd force;
  bool ended = false;
};

/// \PaperEq{LinEtAl, 11} as lambda = max(0, lambda - c gap), by Newton's method with whole steps.
/// \param problem  G and d \param c  > 0 [force/length] \param force  where it starts
/// \return the sets, 60 at most
// [loop]
inline SetRun semismooth(const ContactProblem& problem, double c, Eigen::VectorXd force) {
  SetRun run;
  for (int k = 0; k < 60 && !run.ended; ++k) {
    const Eigen::VectorXd gap = problem.free_gap + problem.compliance * force;
    std::vector<Eigen::Index> closed;  // where the slope of the maximum is 1
    for (Eigen::Index i = 0; i < force.size(); ++i)
      if (force(i) - c * gap(i) > 0) closed.push_back(i);
    run.ended = k > 0 && closed == run.sets.back();
    run.sets.push_back(closed);
    force.setZero();
    if (!closed.empty())
      force(closed) = LuFactor(problem.compliance(closed, closed)).solve(-problem.free_gap(closed));
  }
  run.force = force;
  return run;
}
// [loop]

/// Coulomb's law as a return map: the friction that follows from a trial value.
/// \param trial  tau - c slip [force] \param bound  of the friction, not negative [force]
/// \return the number between -bound and bound that is nearest to the trial value
inline double returned(double trial, double bound) { return std::clamp(trial, -bound, bound); }

}  // namespace signorini
