// What became of random scenes, one by one and counted.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "support/checked_path.hpp"
#include "support/random_scenes.hpp"

namespace signorini_test {

/// How a scene can end.
enum class Outcome {
  Solved,      ///< and right
  Hovers,      ///< solved and right, but pairs that carry or stick leave rigid motions
  Unsaid,      ///< the same, but no note says so
  Refused,     ///< ProblemError before the solver begins
  Escaped,     ///< proof that the load pulls a body away
  Infeasible,  ///< proof that gaps contradict each other
  Ray,         ///< the status of that name, as the next three
  Jump,
  Limit,
  Breakdown,
  Threw,  ///< an error that is not ProblemError
  Wrong   ///< solved, says the library, but a law is broken by more than `most_error`
};
inline constexpr std::size_t n_outcomes = 12;
inline constexpr std::array<const char*, n_outcomes> outcome_names = {
    "solved", "hovers", "unsaid", "refused",   "escaped", "infeasible",
    "ray",    "jump",   "limit",  "breakdown", "threw",   "wrong"};

/// Most that a solved scene may break any law by [-].
inline constexpr double most_error = 1e-9;

/// What became of one scene.
struct Trial {
  Outcome outcome = Outcome::Refused;
  SceneErrors errors;         ///< of what is solved, of the worst step
  std::string text;           ///< the scene in words, and what the library said
  double seconds = 0;         ///< of the solution
  double imbalance = 0;       ///< of the work along a path, see CheckedPath::imbalance() [-]
  Eigen::Index halvings = 0;  ///< of steps that were not solved at once
};

/// Draws a scene and solves it, every step of its path if it has one. \param seed, kind of random_scene()
/// \param solver  of the family that the kind needs; empty: the default
/// \param change  spoils what was solved, to see that it is found out; null: leaves it
/// \return what became of it
Trial try_scene(std::uint64_t seed, RandomScenes kind, const std::string& solver = "",
                void (*change)(signorini::Solution& solution) = nullptr);

}  // namespace signorini_test
