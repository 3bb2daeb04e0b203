/// \file
/// Exercise 15.3 - a load step of many sliders. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex15_3 {

/// Sliders side by side that one hand moves.
struct Sliders {
  Eigen::VectorXd stiffness;  ///< k `n` > 0 of their springs [force/length]
  Eigen::VectorXd bound;      ///< B `n` >= 0, largest friction forces [force]
};

/// What they remember.
struct State {
  Eigen::VectorXd place;  ///< `n` of the tips, that is their slips in total [length]
  double lost = 0;        ///< dissipated so far [force*length]
};

/// Moves the hand. A tip moves only if friction would have to bear more than its bound, and no further than it must.
/// \param sliders  `n`, with k > 0 and B >= 0
/// \param hand     where it is now [length]
/// \param state    of before, with `n` places; gets that of now
/// \return what the hand pulls [force], positive towards positive places
[[nodiscard]] double step(const Sliders& sliders, double hand, State& state);

}  // namespace ex15_3
