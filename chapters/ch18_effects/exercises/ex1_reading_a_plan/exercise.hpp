/// \file
/// Exercise 18.1 - what a scene calls for. Do not change this file.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace ex18_1 {

/// How large a run will be, and what is in it.
struct Needs {
  Eigen::Index unknowns = 0;           ///< displacements that no support gives, of all bodies
  Eigen::Index gaps = 0;               ///< pairs that can open or close
  Eigen::Index slips = 0;              ///< pairs that can slide and rub
  Eigen::Index amplitudes = 0;         ///< of rigid motions that only contact holds
  std::vector<Eigen::Index> gaps_of;   ///< gaps of each contact of the scene, in its order
  std::vector<Eigen::Index> slips_of;  ///< slips of each contact of the scene, in its order
  std::vector<std::string> on;  ///< names of the effects that are on, in the order of the plan
};

/// Reads from the plan of a scene what the run will need. Nothing is assembled or solved.
/// \param scene  any
/// \return the sizes that a run will have, and the effects that will be on
/// \throws signorini::ProblemError as signorini::plan()
[[nodiscard]] Needs needs_of(const signorini::Scene& scene);

/// What one scene has more than another.
struct Step {
  Eigen::Index unknowns = 0;    ///< more of them, or fewer if negative
  Eigen::Index rows = 0;        ///< more rows of A, that is gaps and slips
  Eigen::Index amplitudes = 0;  ///< more of them
  std::vector<std::string>
      switched_on;  ///< effects that only the second has, in the order of its plan
  std::vector<std::string>
      switched_off;  ///< effects that only the first has, in the order of its plan
};

/// One rung of a ladder.
/// \param from  the lower rung
/// \param to    the upper rung
/// \return what the upper one takes besides
/// \throws signorini::ProblemError as signorini::plan()
[[nodiscard]] Step step(const signorini::Scene& from, const signorini::Scene& to);

}  // namespace ex18_1
