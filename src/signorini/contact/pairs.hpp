/// \file
/// Candidate pairs of points that may touch, as the geometry gives them: before supports, loads and stiffness.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// Rows of numbers for every displacement component of every node: column 2 * node + axis, with the
/// nodes of all bodies one after another.
using NodalRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// How much every candidate pair opens and slides when nodes move, with u the displacement
/// components of all nodes, held or not: \PaperEq{LinEtAl, 1}
///
/// \f[ gap = g + N u,\qquad slip = S u. \f]
///
/// Contact forces \f$ \lambda \f$ (compression > 0) and friction forces \f$ \tau \f$ act on the nodes
/// as \f$ N^T\lambda + S^T\tau \f$: they push the source (slave) along the normal and drag it along the
/// tangent, and the target (master) the other way. Every row adds up to a unit vector on the source, its normal or
/// its tangent, and to the opposite on the target: a contact force is the force that the pair hands on, whichever
/// way the sides turn at its points. The weight of a pair is that force of a pressure of one on its share of the side,
/// which is less than the share where the side turns.
struct Pairs {
  NodalRows opening;            ///< N `n_c x 2 n_nodes` [-]
  NodalRows sliding;            ///< S `n_c x 2 n_nodes` [-]; no entries unless asked for
  Eigen::VectorXd initial_gap;  ///< g `n_c` before any displacement [length]; overlap < 0
  Eigen::VectorXd weight;       ///< `n_c` > 0 [length^2]: pressure = force / it
  NodeArray position;           ///< `n_c x 2` on the source before loading [length]
  NodeArray normal;  ///< `n_c x 2` unit vectors out of the target [-]; the tangent is (n_y, -n_x)
  /// `n_c x 2` moments about the origin of a contact force of one and a friction force of one [length]: on the source
  NodeArray moment;
  NodeArray
      target_moment;  ///< and on the target: friction across a gap turns the two by more than one
  std::vector<Eigen::Index>
      node;  ///< `n_c` source node of each pair in its own mesh; -1 if it has none
  /// Nodes of the source that face no target and have no pair, in walking order.
  std::vector<Eigen::Index> unpaired;
};

/// \param x       a place [length]
/// \param normal  unit vector [-]
/// \return the moments about the origin of a force of one there along the normal, and along its tangent [length]
inline Eigen::RowVector2d moments_at(const Eigen::Vector2d& x, const Eigen::Vector2d& normal) {
  return {x.x() * normal.y() - x.y() * normal.x(), -x.dot(normal)};
}

/// Weights of pairs that are nodes: what a pressure of one on the side does along the normal of each pair. A side that hardly
/// faces the target, by 60 degrees or more, counts with half of its share.
/// \param area    `n_c x 2` of the nodes, see boundary_areas() [length^2]
/// \param normal  `n_c x 2` out of the target [-]
/// \return `n_c` [length^2]
inline Eigen::VectorXd weights_of_nodes(const NodeArray& area, const NodeArray& normal) {
  return (-area.cwiseProduct(normal).rowwise().sum()).cwiseMax(area.rowwise().norm() / 2);
}

/// One boundary of one body.
struct Surface {
  const Mesh& mesh;             ///< of the body
  std::string boundary;         ///< its name
  Eigen::Index first_node = 0;  ///< number of the body's first node among the nodes of all bodies
};

}  // namespace signorini
