/// \file
/// A scene with everything that was made on the road to its solution.
#pragma once
#include <string>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// What build(), condense() and solve() returned.
struct SolvedScene {
  Model model;          ///< K, p, A, g
  Condensed condensed;  ///< factor of K, compliance G and free gaps d
  Solution solution;    ///< certified
};

/// Builds, condenses and solves, for programs that have no use for an unsolved problem.
/// \param scene  to be solved
/// \param what   what the message calls it if it is not solved
/// \return matrices, condensed problem and solution
/// \throws NotSolved as require_solved(); ProblemError as plan(), build() and condense()
[[nodiscard]] SolvedScene solved(const Scene& scene, const std::string& what);

/// Forces of the obstacle on the nodes.
/// \param model     of the scene
/// \param solution  of the model
/// \return `n_nodes x 2` [force], zero at nodes without a closed pair
/// \throws std::invalid_argument if the problem is not solved
[[nodiscard]] NodeArray obstacle_forces(const Model& model, const Solution& solution);

/// Forces of the supports on the nodes.
/// \param model     of the scene
/// \param loads     of the scene
/// \param solution  of the model
/// \return `n_nodes x 2` [force], zero but for rounding where no support holds
/// \throws std::invalid_argument if the problem is not solved
[[nodiscard]] NodeArray support_forces(const Model& model, const Loads& loads,
                                       const Solution& solution);

}  // namespace signorini
