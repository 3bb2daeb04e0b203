// Programmes made backwards from their solution, and the judge: what was put in, and a certificate.
#pragma once
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "addons/programme/dense_programme.hpp"
#include "papers/examples.hpp"
#include "papers/solver_table.hpp"

namespace ch05 {

using namespace signorini;
using Eigen::VectorXd;
const char* const ours = "quasi_active_set";

/// The load and the gaps that make a chosen solution one.
// [backwards]
inline KnownProgramme backwards(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A,
                                const VectorXd& u, const VectorXd& force, const VectorXd& gap) {
  const VectorXd p = K * u + A.transpose() * force;  // equilibrium
  const VectorXd g = A * u + gap;                    // gap = g - A u
  return {{K, p, A, g}, u, force, 0.5 * u.dot(K * u) - p.dot(u)};
}
// [backwards]

/// The counts and seconds of a run of a solver.
struct Run {
  bool right = false;  ///< solved, with a certificate, at what was put in
  double steps = 0;    ///< pivots, pairs that joined or left, or steps of the quasi-active set
  double factorisations = 0;  ///< dense ones, solves with a factor that is updated included
  double closed = 0;          ///< rows
  double seconds = 0;         ///< wall time
  double deviation = 0;       ///< |f / f* - 1|
};

inline double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The counts of a run, which is right if its certificate holds.
inline Run counted(const Report& report, std::size_t closed, const Certificate& certificate,
                   double seconds) {
  return {report.status == SolveStatus::Solved && certificate.holds(1e-12),
          static_cast<double>(report.iterations), static_cast<double>(report.factorisations),
          static_cast<double>(closed), seconds};
}

inline Run judged(const KnownProgramme& known, const char* name) {
  const auto begin = std::chrono::steady_clock::now();
  const DenseSolution found = solve(known.programme, find_solver(name));
  Run run = counted(found.report, found.active.size(), found.certificate, seconds_since(begin));
  const VectorXd& u = found.refined.displacement;
  if ((u - known.displacement).norm() > 1e-12 * known.displacement.norm()) run.right = false;
  const double f = 0.5 * u.dot(known.programme.stiffness * u) - known.programme.load.dot(u);
  run.deviation = std::abs(f / known.energy - 1);
  return run;
}

inline Run judged(const ContactProblem& problem, const char* name) {
  const auto begin = std::chrono::steady_clock::now();
  const ContactState found = find_solver(name).solve(problem, {});
  const double seconds = seconds_since(begin);
  return counted(found.report, found.active().size(), certify(problem, found), seconds);
}

/// The quickest of the runs that fit into a millisecond.
template <typename Problem>
Run timed(const Problem& problem, const char* name) {
  Run best = judged(problem, name);
  for (double total = best.seconds; total < 1e-3;) {
    const double seconds = judged(problem, name).seconds;
    total += seconds;
    best.seconds = std::min(best.seconds, seconds);
  }
  return best;
}

/// The middle one of an odd number of runs.
inline double median(std::vector<Run> runs, double Run::*field) {
  const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
  std::nth_element(runs.begin(), middle, runs.end(),
                   [=](const Run& a, const Run& b) { return a.*field < b.*field; });
  return (*middle).*field;
}

}  // namespace ch05
