/// \file
/// A scene with everything that was made on the way to its solution, and the forces read from that.
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

/// \param contact  of a solution
/// \return `n_s` slips of the step [length]; exactly 0 of a pair that sticks, where rounding leaves the solution a rest
[[nodiscard]] Eigen::VectorXd increment(const ContactState& contact);

/// \param contact  of a solution
/// \return `n_s` work |tau| |slip| that each frictional pair lost by sliding [force length], see increment()
[[nodiscard]] Eigen::VectorXd dissipated(const ContactState& contact);

/// What the frictional pairs did in all load steps so far.
struct PathTotals {
  Eigen::VectorXd slip;         ///< `n_s` [length], of the source along the tangent
  Eigen::VectorXd dissipation;  ///< `n_s` [force length], >= 0
  /// Of each contact, what nodes dissipated until they lost their pair [force length]; empty: none did
  Eigen::VectorXd elsewhere = {};
};

/// Forces of contact on the nodes of one body: \f$ N^T\lambda \f$. In axial symmetry, here and below, of the whole
/// circle: sums along y are resultants, sums along x mean nothing.
/// \param model     from build()
/// \param solution  of the model
/// \param body      its number
/// \return `n_nodes x 2` [force], zero at nodes without a closed pair
/// \throws std::invalid_argument if the problem is not solved
[[nodiscard]] NodeArray contact_forces(const Model& model, const Solution& solution,
                                       std::size_t body = 0);

/// Forces of the springs on the nodes of one body.
/// \param model     from build()
/// \param solution  of the model
/// \param body      its number
/// \return `n_nodes x 2` [force], zero at nodes without a spring
/// \throws std::invalid_argument if the problem is not solved
[[nodiscard]] NodeArray spring_forces(const Model& model, const Solution& solution,
                                      std::size_t body = 0);

/// Forces of the supports on the nodes of one body; what springs do is not among them.
/// \param model     from build()
/// \param solution  of the model
/// \param body      its number
/// \return `n_nodes x 2` [force], zero but for rounding where no support holds
/// \throws std::invalid_argument if the problem is not solved
[[nodiscard]] NodeArray support_forces(const Model& model, const Solution& solution,
                                       std::size_t body = 0);

/// What contact and supports do to one boundary, in the order of boundary_nodes().
struct BoundaryForces {
  NodeArray position;  ///< `n x 2` before loading [length]
  NodeArray force;     ///< `n x 2` on the body: of contact, and of supports at held components
  Eigen::VectorXd
      weight;  ///< `n` share of the boundary [length^2]: pressure = force / it, see nodes_without_share()
};

/// Collects the forces on one boundary.
/// \param run   what solved() made of a scene
/// \param side  boundary and body
/// \return forces at its nodes, exactly zero where neither contact nor support acts
/// \throws ProblemError if there is no such boundary
[[nodiscard]] BoundaryForces boundary_forces(const SolvedScene& run, const Side& side);

/// Rows along the tangents (n_y, -n_x) of rows along normals n, as `sliding` has them.
/// \param opening  `n_c x 2 n_nodes`, as in Pairs
/// \return `n_c x 2 n_nodes`
[[nodiscard]] NodalRows turned(const NodalRows& opening);

/// How far the points of all sources have slid along the places that they face, from the displacements alone.
/// \param model          of them
/// \param displacements  `n_nodes x 2` of each body [length]
/// \return `n_c` along the tangent [length], as the slip of ContactState
[[nodiscard]] Eigen::VectorXd slips(const Model& model,
                                    const std::vector<NodeArray>& displacements);

/// \param model          of them
/// \param displacements  `n_nodes x 2` of each body [length]
/// \return `2 n_nodes` of all bodies, one below the other [length]
[[nodiscard]] Eigen::VectorXd all_displacements(const Model& model,
                                                const std::vector<NodeArray>& displacements);

}  // namespace signorini
