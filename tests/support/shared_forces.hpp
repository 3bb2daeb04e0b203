// Random scenes whose forces may not be determined, and which of them are not by dense arithmetic of another kind.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// Draws one or two blocks that mostly rub: in a corner of two walls, on a side that two contacts share in one node, on each
/// other by one to five Gauss points per edge, or in one plain contact; turned, sheared, in units over twelve decades.
/// \param seed  names the scene \param[out] text  says it in words \return the scene
signorini::Scene shared_force_scene(std::uint64_t seed, std::string& text);

/// Which forces of a solution can move while displacements stay: by singular values of the dense rows of pairs without a
/// gap, and by Farkas' lemma with least squares of non-negative numbers. A row can move up unless minus its change is a
/// combination of the bounds that are met.
/// \param model     that was solved
/// \param solution  of it
/// \return rows, in increasing order
std::vector<Eigen::Index> movable_forces(const signorini::Model& model,
                                         const signorini::Solution& solution);

/// How often notes and truth agree.
struct SharedForceCounts {
  int solved = 0;
  int unsolved = 0;      ///< or refused
  int open = 0;          ///< scenes with forces that can move
  int missed = 0;        ///< of these, without a note
  int in_vain = 0;       ///< a note where none can
  int pairs = 0;         ///< that can move, of all scenes
  int pairs_missed = 0;  ///< of these, not named
  int pairs_in_vain = 0;
  std::vector<std::string> wrong;  ///< seeds and scenes where they disagree
};

/// Solves scenes and compares. \param first  seed \param count  scenes that are to be solved \return what came of it
SharedForceCounts compare_shared_forces(std::uint64_t first, int count);

}  // namespace signorini_test
