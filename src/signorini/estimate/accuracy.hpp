/// \file
/// A solution as accurate as asked for: meshes are refined where the estimate of the error says, until it is met.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "signorini/estimate/estimate.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// What is asked for.
struct Accuracy {
  double target = 0.01;                  ///< largest error of the goal by its value, above 0 [-]
  Goal goal;                             ///< what is to be so accurate
  Eigen::Index most_unknowns = 400000;  ///< that a mesh may have
};

/// What one mesh came to.
struct AccuracyRound {
  Eigen::Index unknowns = 0;  ///< of all bodies
  double value = 0;  ///< of the goal; nothing is read or estimated before `closed` is enough for it
  /// Estimate of the size of the error: the sum of the sizes of its parts, and no less than `overlooked`. Nothing if
  /// contact is not resolved yet.
  std::optional<double> error = {};
  ErrorParts parts = {};  ///< of the error of discretisation
  /// What the parts leave out, as changes from mesh to mesh have shown it, see solve_to_accuracy(); 0: nothing was seen
  double overlooked = 0;
  double algebraic = 0;   ///< see Estimate
  double seconds = 0;     ///< wall time of the round, the estimate with it [s]
  double estimating = 0;  ///< of these, for the estimate [s]
};

/// A solution, and how it was come by.
struct AccurateSolution {
  Scene scene;                        ///< with the last meshes
  Model model;                        ///< of it
  Solution solution;                  ///< of that; not solved if the problem is not
  std::optional<Estimate> estimate;   ///< of the last round, if it could be made
  std::vector<AccuracyRound> rounds;  ///< one or more
  bool met = false;                   ///< whether the error is small enough
  std::string verdict;                ///< that it is, or what stands in the way
};

/// Solves a scene, estimates the error of a goal, refines, and begins again.
///
/// A contact with fewer than six closed pairs is refined where it is closed before anything is estimated. From then
/// on each cell's share of the error falls to the chords that cross it, see chords(): halving a chord leaves a quarter
/// of its share, for as many new nodes as it has edges. The cheapest ones are halved, some more than once, until a
/// quarter of the error or somewhat less than the target is left, see marks_for(). What goals and
/// gaps overlook between nodes falls to the sides of the source that are closed, the free boundary to those where
/// contact ends.
///
/// It ends when twice the size of the error is at most the target, on a mesh of 1.5 times the unknowns of the first estimated one
/// at the earliest. The size is the
/// sum of the sizes of the parts of the estimate; but if the value has changed from the mesh before otherwise than the
/// estimates of both foresee, and by more than both allow for, it is no less than that difference, and in each later round
/// no less than half of what it was for that before. An estimate is no bound, see estimates().
/// \param scene    without load steps
/// \param wanted   what is asked for
/// \param observe  called after every round
/// \return the last solution; `met` says whether it is accurate enough
/// \throws ProblemError if the target is not above 0, or the scene has load steps; as solve() and estimates()
[[nodiscard]] AccurateSolution solve_to_accuracy(
    Scene scene, const Accuracy& wanted,
    const std::function<void(const AccuracyRound&)>& observe = {});

}  // namespace signorini
