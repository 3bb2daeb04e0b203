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
  Solved,   ///< and right
  Hovers,   ///< solved and right, but pairs that carry or stick leave rigid motions
  Unsaid,   ///< the same, but no note says so
  Refused,  ///< ProblemError before the solver begins
  Unclear,  ///< the same, but its message does not say what is wrong and what to do, see is_clear()
  Escaped,  ///< proof that the load pulls a body away
  Infeasible,  ///< proof that gaps contradict each other
  Ray,         ///< the status of that name, as the next three
  Jump,
  Limit,
  Breakdown,
  Turned,    ///< small strain does not hold, as a body has turned: refused at that step, with the law that would
  Threw,     ///< an error that is not ProblemError
  Accepted,  ///< what no scene may have is in it, and nothing says so
  Disputed,  ///< solved and right, but another method finds another solution where there is one only
  Wrong      ///< solved, says the library, but a law is broken by more than `most_error`
};
inline constexpr std::size_t n_outcomes = 16;
inline constexpr std::array<const char*, n_outcomes> outcome_names = {
    "solved", "hovers", "unsaid",    "refused", "unclear",  "escaped",  "infeasible", "ray",
    "jump",   "limit",  "breakdown", "turned", "threw",   "accepted", "disputed", "wrong"};

/// \return whether no scene may end like this
inline bool is_fault(Outcome outcome) {
  return outcome == Outcome::Unclear || outcome >= Outcome::Threw;
}

/// Whether the message of an error names an object or a number, says what it must be or is, and what to do or what
/// there is instead. \param message  of a ProblemError \return that, as far as words tell
bool is_clear(const std::string& message);

/// Most that a solved scene may break any law by, balance of the resultants that are told among them [-].
inline constexpr double most_error = 1e-9;

/// What became of one scene.
struct Trial {
  Outcome outcome = Outcome::Refused;
  SceneErrors errors;  ///< of what is solved, of the worst step
  std::string text;    ///< the scene in words, and what the library said
  std::string
      statuses;  ///< of the pairs of every solution, a letter each: open, stick, slide forward or backward
  std::uint64_t bits = 0;     ///< that forces and displacements of all solutions were folded into
  double seconds = 0;         ///< of the solution
  double imbalance = 0;       ///< of the work along a path, see CheckedPath::imbalance() [-]
  Eigen::Index halvings = 0;  ///< of steps that were not solved at once
};

/// Draws a scene and solves it, every step of its path if it has one; one of Any by a second method as well, if that takes
/// it. \param seed, kind of random_scene()
/// \param solver  of the family that the kind needs; empty: the default
/// \param change  spoils what was solved, to see that it is found out; null: leaves it
/// \return what became of it
Trial try_scene(std::uint64_t seed, RandomScenes kind, const std::string& solver = "",
                void (*change)(signorini::Solution& solution) = nullptr);

}  // namespace signorini_test
