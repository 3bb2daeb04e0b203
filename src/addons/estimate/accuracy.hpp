/// \file
/// A solution as accurate as asked for: meshes are refined where the estimate of the error says, until it is met.
#pragma once
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "addons/estimate/estimate.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// What is asked for.
struct Accuracy {
  double target = 0.01;                 ///< largest error of the goal by its value, above 0 [-]
  Goal goal;                            ///< what is to be so accurate
  Eigen::Index most_unknowns = 400000;  ///< that a mesh may have
  /// That the next mesh may take by the forecast: one that takes longer is not solved [s]
  double most_seconds = std::numeric_limits<double>::infinity();
  /// Forecast of what a scene takes, of which only the growth counts, as predict() of the add-on prediction makes it [s];
  /// empty: the cube of the unknowns
  std::function<double(const Scene& scene)> forecast = {};
  /// Solves what condense() made of a scene, as solve_to_limit() of the add-on steps; empty: solve()
  std::function<Solution(const Scene& scene, const Model& model, const Condensed& condensed,
                         Ledger ledger)>
      solve = {};
  /// Says what no finer mesh mends, as point_supports() of the add-on checks; empty: nothing is asked
  std::function<std::vector<std::string>(const Model& model, const Solution& solution)> warnings = {};
};

/// What one mesh came to.
struct AccuracyRound {
  Eigen::Index unknowns = 0;  ///< of all bodies
  double of_mesh =
      0;  ///< the goal as solved; nothing is read or estimated before contact is resolved
  /// The answer: the same, and what the estimate says is missing; of a peak or a width, whose estimate has no sign, the same
  double value = 0;
  /// Estimate of the size of the error of `value`: the largest of `of_estimate`, `saturation`, `to_come` and `model_error`.
  /// Nothing if the mesh is too coarse for an estimate.
  std::optional<double> error = {};
  ErrorParts parts = {};  ///< of the error of discretisation
  double of_estimate =
      0;  ///< the sum of their sizes; of an estimate without a sign twice its size, which is no less
  /// What the parts leave out, as changes from mesh to mesh have shown it, see solve_to_accuracy(); 0: nothing was seen
  double saturation = 0;
  double to_come = 0;      ///< if answers go on as from the mesh before, see solve_to_accuracy()
  double model_error = 0;  ///< of the reading, see signorini::model_error()
  double algebraic = 0;    ///< see Estimate
  double seconds = 0;      ///< wall time of the round, the estimate with it [s]
  double estimating = 0;   ///< of these, for the estimate [s]
};

/// A solution, and how it was come by.
struct AccurateSolution {
  Scene scene;                        ///< with the last meshes that gave an answer
  Model model;                        ///< of it
  Solution solution;                  ///< of that; not solved if the problem is not
  std::optional<Estimate> estimate;   ///< of the last round, if it could be made
  std::vector<AccuracyRound> rounds;  ///< one or more
  bool met = false;                   ///< whether the error is small enough
  std::string verdict;                ///< that it is, or what stands in the way
  Eigen::Index too_dear =
      0;  ///< unknowns of a mesh that would take too long; 0: that did not stop it
};

/// Solves a scene, estimates the error of a goal, refines, and begins again.
///
/// What is estimated is not thrown away: the answer is the value on the mesh and the error that is estimated, with its sign
/// [\ref BeckerRannacher2001]. An estimate within a factor of two of the error leaves at most itself; so the
/// size of the error of the answer is the sum of the sizes of the parts of the estimate. That of a peak or a width has no sign:
/// there the answer is the value on the mesh, and its error up to twice the estimate. But if the answer has changed
/// from the mesh before by more than both allow for, it is no less than what is beyond that, and in each later
/// round no less than what it was for that before by the growth of the unknowns; nor is it less than the model error.
///
/// Parts that cancel make an estimate small on a mesh that is not fine enough. What answers do from mesh to mesh does not know
/// of that: if the error falls to its part r from one mesh to the next, and they change from v_0 to v_1,
///
/// \f[ |J - v_1| = \frac{r}{1 - r} |v_1 - v_0|, \qquad r = N_0 / N_1 \f]
///
/// is still to come, and the error of the answer is no less. For unknowns that grow from N_0 to N_1, r is that of linear shapes
/// where nothing is singular, or cells are small where something is; quadratic ones, whose errors fall faster, lose little
/// by it, because what is compared are answers, of which most of the error is gone. Of a goal without a sign nothing is: its
/// answers change by the errors themselves. There r is how the estimates fall, if that is less, but not less than the
/// eighth that a round aims at.
///
/// Meshes too coarse for an estimate, see marks_where_coarse(), are refined before anything is estimated. From then
/// on each cell's share of the error falls to the refinement lines that cross it, see refinement_lines(): halving one leaves a quarter
/// of its share, for as many new nodes as it has edges. The cheapest ones are halved, some more than once, until a
/// eighth of the error or somewhat less than the target is left, see mark_elements(), and there are twice the nodes, or half as
/// many again if only the estimate is too large on a mesh that would confirm. What
/// goals and gaps overlook between nodes falls to the sides of the source that are closed, the free boundary to those where
/// contact ends, and what a curved outline leaves to its sides.
///
/// A value that is nothing beside what it is a sum of, see terms_of(), is 0, and no error can be compared with it. What
/// Accuracy::warnings says of the first mesh that resolves contact ends it.
///
/// Where no contact closes, or refinement closes no more pairs of one that it does not resolve, all cells are halved,
/// twice at most for either, before that is the verdict: coarse meshes are too stiff.
///
/// It ends when the size of the error is at most the target, on a mesh of twice the unknowns of the first estimated one
/// at the earliest, of those since the last that was too coarse; or with the last answer and the reason if refining does not help, or a finer mesh gives no answer. An
/// estimate is no bound, see estimates().
/// \param scene    without load steps
/// \param wanted   what is asked for
/// \param observe  called after every round
/// \return the last solution; `met` says whether it is accurate enough
/// \throws ProblemError if the target is not above 0, or the scene has load steps; of the first mesh, as solve() and
///   estimates()
[[nodiscard]] AccurateSolution solve_to_accuracy(
    Scene scene, const Accuracy& wanted,
    const std::function<void(const AccuracyRound&)>& observe = {});

}  // namespace signorini
