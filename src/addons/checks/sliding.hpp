// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How far the pairs of a solution have slid, and whether they are still those of the bodies.
///
/// Small sliding leaves every point of a source on the place of the target that it faces in the meshes. Here the pairs
/// of a solution are found again where the bodies have moved to: the same points, the places and normals that they face
/// there, the gaps that are left. One step of Newton's method on the condensed problem then says what forces they would
/// carry. Where nothing changes, as along a half plane, sliding is exact however far it goes.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "signorini/scene/solution.hpp"

namespace signorini {

/// A change of a contact force that is noted [-]: half of 5 %, because one step of Newton's method may foresee half of a
/// change only.
constexpr double noted_change = 0.025;

/// What the pairs of one contact would do where the bodies have moved to.
struct SlidingChange {
  Eigen::Index pair =
      -1;  ///< of those that carry forces, the one that slid farthest; -1: none carries any
  double slip = 0;  ///< of it [length], >= 0
  double edge = 0;  ///< the longest of the sides that it is on or faces [length]
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< on the source, as solved [force]
  std::optional<Eigen::Vector2d> new_force =
      {};  ///< there, to first order [force]; nothing if none is found
  /// Of the sum of normal forces: the larger of its own change and that of the resultant [-]; infinite if there are only
  /// forces there, or if it is proved that there are none
  double change = 0;
  double elsewhere = 0;  ///< share of the forces on nodes that act on others there [-], 1 of a loss
  double normal = 0;     ///< the larger sum of normal forces, as solved or there [force]
  bool moves = false;    ///< whether any row or gap of its pairs is another there
  std::string lost = {};  ///< why its pairs face nothing there; empty if some do
};

/// Finds the pairs of a solution again where the bodies have moved to.
/// \param model      that was solved
/// \param condensed  from condense() of it
/// \param none       says up to which force a pair carries none that matters [force]
/// \param solution   of it, Solved
/// \return of each contact
[[nodiscard]] std::vector<SlidingChange> sliding_changes(const Model& model,
                                                         const Condensed& condensed,
                                                         const std::function<double()>& none,
                                                         const Solution& solution);

}  // namespace signorini
