/// \file
/// Random programmes of the sizes of table 1: what the literal and the repaired method make of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "cases.hpp"
#include "readings.hpp"
#include "signorini/problem/examples.hpp"

namespace signorini {

inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Share {
  Tally ends;
  double violated = 0, fresh = 0;  // mean number of pairs that overlap at u^0 and at u^1
  double crowded = 0;              // runs in which the former outnumber the unknowns
  double repaired = 0;
  std::vector<double> steps, repaired_steps;
  std::vector<double> gap, lost, lost_whole;  // over the energy that contact adds, or all energy
};

inline Share try_size(Eigen::Index n, Eigen::Index m, std::uint64_t runs) {
  Share share;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const KnownProgramme known = rosen_suzuki(n, m, seed);
    const ContactProblem problem = condensed(known.programme);
    const auto ways = run_readings(problem);
    for (std::size_t i = 0; i < 4; ++i) share.ends[i].count(ways[i]);
    const QuasiActiveRun& way = ways[0];
    const ContactState repaired = find_solver("quasi_active_set").solve(problem, {});
    const Report& report = way.state.report;
    share.repaired += repaired.report.status == Status::Solved ? 1 : 0;
    share.violated += static_cast<double>(report.history[0].changes) / static_cast<double>(runs);
    share.fresh += static_cast<double>(report.history[1].changes) / static_cast<double>(runs);
    share.crowded += report.history[0].changes > n ? 1 : 0;
    if (way.outer_steps > 1) share.steps.push_back(static_cast<double>(way.outer_steps));
    share.repaired_steps.push_back(static_cast<double>(repaired.report.iterations));
    const double added = -0.5 * repaired.force.dot(problem.free_gap + repaired.gap);
    if (report.status == Status::Solved) continue;
    const double excess = report.history.back().dual_energy + energy_gap(way.state) - added;
    share.gap.push_back(energy_gap(way.state) / added);
    share.lost.push_back(excess / added);
    share.lost_whole.push_back(excess / std::abs(known.energy));
  }
  return share;
}

}  // namespace signorini
