// Whether every step of a path solves what was posed, with friction that counts from the step before.
#pragma once
#include "addons/steps/steps.hpp"
#include "support/checked_scene.hpp"

namespace signorini_test {

/// Most that the work put in may differ from where it went along a path [-].
inline constexpr double most_imbalance = 1e-10;

/// The scene as it is at a time of its path: loads, temperatures, given displacements and interferences times what their
/// histories are then, and no load steps.
signorini::Scene at_time(const signorini::Scene& scene, double time);

/// Checks the steps of a path one after another.
///
/// K, p, A and g are those of the scene at the time of the step, built anew as if it had no path. The slip of a pair is
/// that of all its nodes' displacements, summed here, less the same of the step before.
class CheckedPath {
 public:
  /// \param scene  with load steps
  explicit CheckedPath(const signorini::Scene& scene) : scene_(scene) {}
  /// \param model  of the step, for the frictional pairs \param step  the next one, solved
  /// \return its errors; `reading` has those of total slips and of the dissipation as well
  SceneErrors add(const signorini::Model& model, const signorini::Step& step);
  /// \return what the work of the loads differs from energy, dissipation and what steps do not resolve, largest over the
  ///   steps, over the largest of these at any step [-]; 0 if it is no more than rounding of the displacements makes: the
  ///   last bit of each times the force that moves its unknown alone
  [[nodiscard]] double imbalance() const;

 private:
  const signorini::Scene& scene_;
  signorini::WorkMeter meter_;
  Eigen::VectorXd slip_;  // `n_s` in total
  double dissipation_ = 0;
  double length_ = 0;  // of the step before
  double most_ = 0;    // that friction forces may have done
  double missing_ = 0;
  double rounding_ = 0;
  double turnover_ = 0;
};

}  // namespace signorini_test
