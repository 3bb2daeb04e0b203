/// \file
/// Exercise 15.6 - sticking, sliding and open pairs of a mesh. Do not change this file.
#pragma once
#include <vector>

#include "signorini/scene/readings.hpp"

namespace ex15_6 {

/// What a solution says of one pair.
struct Pair {
  double x = 0;         ///< its place before loading, along x [length]
  double gap = 0;       ///< [length], open > 0
  double force = 0;     ///< lambda [force], compression > 0
  double friction = 0;  ///< tau [force]; 0 if it cannot slide
  double slip = 0;      ///< [length]; 0 if it cannot slide
  double bound = 0;     ///< mu lambda + c of a closed pair [force]; 0 if it is open or cannot slide
};

/// Collects the pairs of a solved scene.
/// \param run  of contacts with friction; its load came in one step
/// \return all pairs, those that cannot slide too, in the order of their x
/// \throws std::invalid_argument if the scene is not solved
[[nodiscard]] std::vector<Pair> pairs_of(const signorini::SolvedScene& run);

/// What a pair does.
enum class State { Open, Stick, Slide };

/// Tells it from the numbers, without a tolerance. Of a gap and a force one is zero, and of a slip and what friction could still
/// bear, `bound - |friction|`, again one: but for rounding, so whichever is larger counts. Lengths are measured by the
/// largest |gap| or |slip| of all pairs, forces by the largest force of all; where all are zero, so is the share.
/// \param pairs  of one solution
/// \return open if the gap is larger than the force; else sliding if the slip is larger than what friction could still
///   bear, else sticking
[[nodiscard]] std::vector<State> states_of(const std::vector<Pair>& pairs);

/// How far Coulomb's law is broken, measured as above; 0 is perfect.
struct Breach {
  double cone = 0;  ///< largest |friction| beyond its bound
  double sliding =
      0;  ///< largest of what slides below the bound: the smaller of |slip| and bound - |friction|
  double against = 0;  ///< largest slip times friction with the same sign: friction that pushes on
};

/// Checks Coulomb's law.
/// \param pairs  of one solution
/// \return the three figures, none negative
[[nodiscard]] Breach breach_of(const std::vector<Pair>& pairs);

}  // namespace ex15_6
