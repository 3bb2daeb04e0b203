/// \file
/// Runs of one scene, timed phase by phase.
#pragma once
#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "scenes.hpp"
#include "signorini/core/errors.hpp"

namespace ch16 {

inline const std::vector<std::string> phases = {
    "plan",         "assembly", "factor/ordering", "factor/symbolic", "factor/numeric",
    "condensation", "contact",  "refinement",      "recovery"};

/// Some runs of one scene: its counts, and the seconds of every phase and of one solve with the factor.
struct Runs {
  Ledger ledger;                                       // of the last
  double plain_operations = 0;                         // of the factor and one solve
  std::map<std::string, std::vector<double>> seconds;  // of this processor
};

/// \param scene  to be solved once more \param[in,out] runs  what it took
inline void one_more(const Scene& scene, Runs& runs) {
  const auto wall = std::chrono::steady_clock::now();
  const double begin = processor_seconds();
  const SolvedScene run = solved(scene, "the scene");
  const double end = processor_seconds();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - wall;
  const double share = std::min(1.0, (end - begin) / passed.count());  // others took the rest
  runs.ledger = run.solution.ledger;
  for (const std::string& phase : phases)
    runs.seconds[phase].push_back(share * runs.ledger.seconds(phase));
  const Factor& factor = run.condensed.factor;
  const double before = processor_seconds();
  const Eigen::VectorXd free = factor.solve(run.model.programme.load);
  runs.seconds["solve"].push_back(processor_seconds() - before);
  if (!free.allFinite()) throw NotSolved("a plain solve has no numbers");
  runs.plain_operations = factor.operations() + factor.solve_operations();
}

/// \param scene  to be solved five times \return what it took
inline Runs several(const Scene& scene) {
  Runs runs;
  for (int round = 0; round < 5; ++round) one_more(scene, runs);
  return runs;
}

/// \param runs  any \param phase  of the ledger, or `solve` \return the median of its seconds
inline double median(const Runs& runs, const std::string& phase) {
  return quantile(runs.seconds.at(phase), 0.5);
}

}  // namespace ch16
