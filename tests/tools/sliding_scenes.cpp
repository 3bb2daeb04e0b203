// Solves random scenes in which a body slides over another, and compares their contact forces with those of pairs that
// follow the bodies.
// Run:  sliding_scenes FIRST COUNT [OUTCOME ...]
// Scenes of a named OUTCOME are listed: unsaid (a force changes by more than 5 %, and the scene is solved without a note),
// vain (noted or refused, and it changes by less than 1 %), refused, noted, or lost (the pairs that follow come to no end).
// Ends with 1 if any is unsaid.
#include "support/sliding_scenes.hpp"

#include <algorithm>
#include <array>
#include <iostream>

using namespace signorini_test;

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "sliding_scenes FIRST COUNT [OUTCOME ...]\n";
    return 2;
  }
  const std::uint64_t first = std::stoull(argv[1]);
  const std::uint64_t count = std::stoull(argv[2]);
  std::array<std::uint64_t, 6> counts{};
  const std::array<const char*, 6> names = {"refused", "noted",  "lost",
                                            "changed", "unsaid", "vain"};
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const SlidingTrial trial = try_sliding(seed);
    const bool said = trial.refused || trial.noted;
    const bool changed = trial.found && trial.change > 0.05;
    const std::array<bool, 6> is = {trial.refused,    trial.noted,
                                    !trial.found,     changed,
                                    changed && !said, trial.found && trial.change < 0.01 && said};
    for (std::size_t k = 0; k < is.size(); ++k) {
      counts[k] += is[k] ? 1 : 0;
      if (is[k] && std::find(argv + 3, argv + argc, std::string(names[k])) != argv + argc)
        std::cout << names[k] << ' ' << seed << ", change " << trial.change << ": " << trial.text
                  << '\n';
    }
  }
  std::cout << first << " + " << count << ':';
  for (std::size_t k = 0; k < counts.size(); ++k) std::cout << ' ' << names[k] << ' ' << counts[k];
  std::cout << '\n';
  return counts[4] == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "sliding_scenes: " << error.what() << '\n';
  return 1;
}
