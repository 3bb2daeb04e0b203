// Scenes that their author hardly meant, each beside a sound one.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// What a doubt becomes.
enum class Said {
  Error,    ///< by plan() and solve()
  Plan,     ///< a note of the plan, and so of the solution
  Solution  ///< a note of the solution
};

/// A mistake, and the same scene without it.
struct DoubtfulScene {
  std::string mistake;             ///< in a few words
  signorini::Scene scene;          ///< that has it
  Said said;                       ///< where it is told
  std::vector<std::string> words;  ///< that are in what is told
  signorini::Scene sound;          ///< without it: nothing is told of it
};

/// All of them but files of another kind, which the Gmsh reader knows.
std::vector<DoubtfulScene> doubtful_scenes();

}  // namespace signorini_test
