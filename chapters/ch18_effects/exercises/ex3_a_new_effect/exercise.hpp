/// \file
/// Exercise 18.3 - an effect of one's own: bodies that spin. Do not change this file.
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "signorini/scene/readings.hpp"

namespace ex18_3 {

/// A body that turns about an axis across the plane, seen by someone who turns with it; in axial symmetry it turns
/// about its own axis x = 0.
struct Spin {
  double density = 0;  ///< rho >= 0 [mass/length^3]
  double speed = 0;    ///< omega, either way round [1/time]
  Eigen::Vector2d centre =
      Eigen::Vector2d::Zero();  ///< of the rotation [length]; in axial symmetry its x is 0
};

/// A scene with one more block. In the library `spin` would be an optional entry of signorini::Body.
struct SpinningScene {
  signorini::Scene scene;                 ///< without it
  std::vector<std::optional<Spin>> spin;  ///< one entry per body of the scene
};

/// Whether a scene calls for it, as signorini::Effect::present.
/// \param spinning  any
/// \return whether a body spins and has a density: a spin with a density or a speed of zero is none
[[nodiscard]] bool present(const SpinningScene& spinning);

/// Checks the block and says in the plan what it takes, as signorini::Effect::declare.
///
/// Gets one line in `draft.on` for each body that spins, with its name. It needs neither an unknown nor a row.
/// \param spinning  in which it is present
/// \param draft     gets the lines
/// \throws signorini::ProblemError naming the body if a density is negative, a number is not finite, or the centre in
///   axial symmetry is not on the axis; or if there is not one entry per body
void declare(const SpinningScene& spinning, signorini::Plan& draft);

/// Adds the centrifugal force, as signorini::Effect::add.
///
/// Every body feels the force per volume \f$ \rho\omega^2 (x - c) \f$; in axial symmetry its component along the axis is
/// zero. Its nodal forces go into `model.programme.load`, besides what is there already. And it goes, besides what is there already,
/// into `loads.body_force` of the body in the model, from which support_forces() takes what loads a body.
/// \param spinning  in which it is present
/// \param model     of the scene; may have a weight, supports, contact, several bodies
void add(const SpinningScene& spinning, signorini::Model& model);

/// Plans with the effect, as signorini::plan() does with those of the table.
/// \param spinning  a scene with the block
/// \return the plan
inline signorini::Plan plan_spinning(const SpinningScene& spinning) {
  signorini::Plan planned = signorini::plan(spinning.scene);
  if (present(spinning))
    declare(spinning, planned);
  else
    planned.off.emplace_back("spin");
  return planned;
}

/// Plans, builds, condenses and solves with the effect, as signorini::solved() does with those of the table.
/// \param spinning  a scene with the block
/// \return its solution
inline signorini::SolvedScene solve_spinning(const SpinningScene& spinning) {
  signorini::Ledger ledger;
  signorini::Model model = signorini::build(plan_spinning(spinning), ledger);
  if (present(spinning)) add(spinning, model);
  signorini::Condensed condensed = signorini::condense(model, ledger);
  signorini::Solution solution = signorini::solve(model, condensed, ledger);
  signorini::require_solved(solution, "the spinning scene");
  return {std::move(model), std::move(condensed), std::move(solution)};
}

}  // namespace ex18_3
