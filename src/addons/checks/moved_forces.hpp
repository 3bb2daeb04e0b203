// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What pairs do to the nodes, in the meshes and where the bodies have moved to.
#pragma once
#include "addons/checks/follow.hpp"
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Forces of pairs.
struct PairForces {
  Eigen::VectorXd normal;  ///< `n_c` [force], compression > 0
  Eigen::VectorXd
      shear;  ///< `n_c` [force], on the source along the tangent; 0 of pairs without friction
};

/// \param contact  any
/// \return its forces
[[nodiscard]] PairForces pair_forces(const ContactState& contact);

/// \param opening  `n_c x 2 n_nodes`, as in Pairs
/// \param forces   of its pairs
/// \return `2 n_nodes` what they do to the nodes [force], entries of their own nodes only
[[nodiscard]] Eigen::SparseVector<double> on_nodes(const NodalRows& opening, const PairForces& forces);

/// Solves the contact problem where the bodies have moved to, linearised there: one step of Newton's method. Pairs that face
/// nothing there are far open.
/// \param model         that was solved
/// \param condensed     from condense() of it
/// \param there         its pairs where the bodies have moved to
/// \param displacement  `2 n_nodes` [length]
/// \param opens         `n_c` by how much gaps are larger there than the linear ones [length]
/// \param contact       that was found
/// \return of the pairs there were, then of the fresh ones; no solution unless its status is Solved
[[nodiscard]] ContactState forces_there(const Model& model, const Condensed& condensed,
                                        const MovedPairs& there,
                                        const Eigen::VectorXd& displacement,
                                        const Eigen::VectorXd& opens, const ContactState& contact);

/// The same with the rows and the compliance of the pairs in the meshes, so that only gaps are others: for pairs that hardly
/// moved, and no fresh ones.
/// \param model         that was solved
/// \param condensed     of it; of a compliance that was left out only the rows that are needed are made
/// \param displacement  `2 n_nodes` [length]
/// \param opens         `n_c` by how much gaps are larger there than the linear ones [length]
/// \param contact       that was found
/// \return of the pairs there were; no solution unless its status is Solved
[[nodiscard]] ContactState forces_nearby(const Model& model, const Condensed& condensed,
                                         const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& opens, const ContactState& contact);

}  // namespace signorini
