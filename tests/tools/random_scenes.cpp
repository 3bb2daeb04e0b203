// Solves random scenes and counts what became of them.
// Run:  random_scenes KIND SOLVER FIRST COUNT [OUTCOME ...]
// KIND is frictionless, frictional, varied, revolved, triangles, paths, moving or any, SOLVER a name, `default`, or `plain` for the default
// without the add-on certified; seeds that end in
// a named OUTCOME are listed with their scenes. Ends with 1 if a scene ended as none may.
// With the OUTCOME `motions` there is one line per seed: how it ended, the bits of its numbers, the motions of its pairs.
#include <algorithm>
#include <iostream>
#include <map>

#include "signorini/scene/ways.hpp"
#include "support/random_outcomes.hpp"

using namespace signorini_test;

int main(int argc, char** argv) try {
  if (argc < 5) {
    std::cerr << "random_scenes KIND SOLVER FIRST COUNT [OUTCOME ...]\n";
    return 2;
  }
  const std::string word = argv[1];
  const std::map<std::string, RandomScenes> kinds = {{"frictionless", RandomScenes::Frictionless},
                                                     {"frictional", RandomScenes::Frictional},
                                                     {"varied", RandomScenes::Varied},
                                                     {"revolved", RandomScenes::Revolved},
                                                     {"triangles", RandomScenes::Triangles},
                                                     {"paths", RandomScenes::Paths},
                                                     {"moving", RandomScenes::Moving},
                                                     {"any", RandomScenes::Any}};
  const RandomScenes kind = kinds.at(word);
  if (argv[2] == std::string("plain")) signorini::set_solve(signorini::solve_plainly);
  const bool usual = argv[2] == std::string("default") || argv[2] == std::string("plain");
  const std::string solver = usual ? "" : argv[2];
  const std::uint64_t first = std::stoull(argv[3]);
  const std::uint64_t count = std::stoull(argv[4]);
  std::array<std::uint64_t, n_outcomes> counts{};
  double seconds = 0;
  double worst = 0;
  double longest = 0;
  double imbalance = 0;
  Eigen::Index halvings = 0;
  std::uint64_t slowest = first;
  bool good = true;
  const bool lines = argc > 5 && argv[5] == std::string("motions");
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const Trial trial = try_scene(seed, kind, solver);
    const auto outcome = static_cast<std::size_t>(trial.outcome);
    ++counts[outcome];
    good = good && !is_fault(trial.outcome);
    seconds += trial.seconds;
    if (trial.seconds > longest) slowest = seed;
    longest = std::max(longest, trial.seconds);
    imbalance = std::max(imbalance, trial.imbalance);
    halvings += trial.halvings;
    if (trial.outcome != Outcome::Wrong) worst = std::max(worst, trial.errors.worst());
    if (lines)
      std::cout << word << ' ' << seed << ' ' << outcome_names[outcome] << ' ' << std::hex
                << trial.bits << std::dec << ' ' << trial.statuses << '\n';
    const SceneErrors& e = trial.errors;
    if (std::find(argv + 5, argv + argc, std::string(outcome_names[outcome])) != argv + argc)
      std::cout << outcome_names[outcome] << ' ' << seed << ": " << trial.text << "\n  equilibrium "
                << e.equilibrium << ", strain " << e.strain << ", penetration " << e.penetration
                << ", tension " << e.tension << ", complementarity " << e.complementarity
                << ", cone " << e.cone << ", stick " << e.stick << ", sliding " << e.sliding
                << ", reading " << e.reading << ", balance " << e.balance
                << ", work that nobody got " << trial.imbalance << std::endl;
  }
  if (lines) return 0;
  std::cout << argv[1] << ' ' << argv[2] << ' ' << first << " + " << count << ':';
  for (std::size_t k = 0; k < n_outcomes; ++k)
    std::cout << ' ' << outcome_names[k] << ' ' << counts[k];
  std::cout << "; largest error " << worst << "; ";
  if (kind == RandomScenes::Paths || kind == RandomScenes::Any)
    std::cout << "work that nobody got, over the most that was done: " << imbalance
              << " (wrong above " << most_imbalance << "); halvings " << halvings << "; ";
  std::cout << seconds << " s, of them " << longest << " for " << slowest << '\n';
  return good ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "random_scenes: " << error.what() << '\n';
  return 1;
}
