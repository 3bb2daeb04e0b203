// The judge of chapter 5: what was put into a programme, and a certificate. No other solver is asked.
#pragma once
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/problem/examples.hpp"
#include "signorini/programme/dense_programme.hpp"

namespace ch05 {

using namespace signorini;
using Eigen::VectorXd;

/// What a run of a solver took.
struct Run {
  double steps = 0;  ///< pivots, pairs that joined or left, or steps of the quasi-active set
  double factorisations = 0;  ///< dense ones
  double closed = 0;          ///< rows
  double seconds = 0;         ///< wall time
  double deviation = 0;       ///< |f / f* - 1|
};

inline double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The counts of a run whose certificate holds.
template <typename Found>
Run certified(const Found& found, const Certificate& certificate, double seconds) {
  if (found.report.status != Status::Solved || !certificate.holds(1e-12))
    throw NotSolved(text("a solver ends as ", to_string(found.report.status)));
  return {static_cast<double>(found.report.iterations),
          static_cast<double>(found.report.factorisations),
          static_cast<double>(found.active.size()), seconds};
}

/// A solver has to find the displacements that were put in, and a certificate.
// [judge]
inline Run judged(const KnownProgramme& known, const char* name) {
  const auto begin = std::chrono::steady_clock::now();
  const DenseSolution found = solve(known.programme, find_solver(name));
  Run run = certified(found, found.certificate, seconds_since(begin));
  const VectorXd& u = found.refined.displacement;
  if ((u - known.displacement).norm() > 1e-12 * known.displacement.norm())
    throw NotSolved(text(name, " does not find the displacements that were put in"));
  const double f = 0.5 * u.dot(known.programme.stiffness * u) - known.programme.load.dot(u);
  run.deviation = std::abs(f / known.energy - 1);
  return run;
}
// [judge]

/// A solver has to find forces and gaps with a certificate.
inline Run judged(const ContactProblem& problem, const char* name) {
  const auto begin = std::chrono::steady_clock::now();
  const ContactState found = find_solver(name).solve(problem, {});
  const double seconds = seconds_since(begin);
  return certified(found, certify(problem, found), seconds);
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

/// The largest deviation of the energy.
inline double worst_deviation(const std::vector<Run>& runs) {
  double worst = 0;
  for (const Run& run : runs) worst = std::max(worst, run.deviation);
  return worst;
}

}  // namespace ch05
