// # The first scene is explained
//
// A program that people watch says once what its scene consists of, and once what it cost. Chapters
// solve many scenes, so later ones are solved without a word.

#include "signorini/report/shown.hpp"

#include <iostream>

namespace signorini {

// The plan comes before the solution, so that a reader sees it even if the scene cannot be solved.
SolvedScene shown(const Scene& scene, const std::string& what) {
  static bool first = true;
  if (!first) return solved(scene, what);
  first = false;
  std::cout << "the plan of " << what << '\n' << plan(scene) << '\n';
  SolvedScene run = solved(scene, what);
  std::cout << "what it took\n" << run.solution.ledger << '\n';
  return run;
}

}  // namespace signorini
