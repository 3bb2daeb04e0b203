/// \file
/// Exercise 14.3 - the gaps before anything moves. Do not change this file.
#pragma once
#include "signorini/scene/scene.hpp"

namespace ex14_3 {

/// What the plan of a scene says about its gaps.
struct FirstGaps {
  Eigen::Index pairs = 0;   ///< that can open or close, of all contacts
  Eigen::Index inside = 0;  ///< of them, pairs that overlap from the start: gap < 0
  double least = 0;         ///< smallest gap [length], overlap < 0; 0 without pairs
  double most = 0;          ///< largest gap [length]; 0 without pairs
};

/// Reads the gaps before any displacement from the plan. Nothing is assembled or solved.
/// \param scene  any
/// \return what its pairs begin with
/// \throws signorini::ProblemError as signorini::plan()
[[nodiscard]] FirstGaps first_gaps(const signorini::Scene& scene);

/// Whether the meshes have the gap of the drawing.
/// \param gaps   of a scene
/// \param drawn  the same everywhere [length]; a press fit has drawn < 0
/// \param part   of |drawn| by which each gap may differ [-]
/// \return whether all do; true without pairs
[[nodiscard]] bool as_drawn(const FirstGaps& gaps, double drawn, double part);

/// How many straight sides a quarter of a circle needs, so that the middle of a side lies no further inside the circle
/// than a part of a gap.
/// \param radius  of the circle [length], > 0
/// \param gap     [length], > 0
/// \param part    of the gap, > 0 [-]
/// \return the smallest number of equal sides, at least 1
/// \throws std::invalid_argument unless all three are positive
[[nodiscard]] Eigen::Index sides_needed(double radius, double gap, double part);

}  // namespace ex14_3
