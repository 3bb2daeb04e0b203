/// \file
/// Candidate pairs of points that may touch, as the geometry gives them: before supports, loads and stiffness.
///
/// This struct is the seam between geometry and mechanics. Gap operators fill it and know nothing
/// of stiffness and loads; solvers read it and know nothing of meshes. What crosses the seam is two
/// sparse matrices and some numbers per pair, whatever the operator.
///
/// A row of \f$N\f$ for a node above the middle of a side of two nodes: \f$n\f$ for the node,
/// \f$-n/2\f$ for each node of the side. In words: move the node out by 1 and the gap opens by 1;
/// move the side out by 1 and it closes by 1; move both and nothing changes.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "signorini/fem/mesh.hpp"

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
/// tangent, and the target (master) the other way. Rows, gaps and normals of several points are means by their weight, so
/// that gap and slip are lengths and a force divided by the weight is a pressure. Every row adds up to the normal on the
/// source and to its opposite on the target: the resultant of a pair is its force times its normal, and less than its
/// force where the side turns. Rows that a relation adds act on all its terms, and tell of the first.
struct Pairs {
  NodalRows opening;            ///< N `n_c x 2 n_nodes` [-]
  NodalRows sliding;            ///< S `n_c x 2 n_nodes` [-]; no entries unless asked for
  Eigen::VectorXd initial_gap;  ///< g `n_c` before any displacement [length]; overlap < 0
  Eigen::VectorXd weight;       ///< `n_c` > 0 [length^2]: pressure = force / it
  NodeArray position;           ///< `n_c x 2` on the source before loading [length]
  /// `n_c x 2` means of unit vectors out of the target [-], not 1 long where it turns; the tangent is (n_y, -n_x)
  NodeArray normal;
  /// `n_c x 2` moments about `position` of a contact force of one and a friction force of one [length]: on the source, 0
  /// if that is all that the pair presses on
  NodeArray moment;
  NodeArray target_moment;  ///< and on the target: friction across a gap turns it too
  std::vector<Eigen::Index>
      node;  ///< `n_c` source node of each pair in its own mesh; -1 if it has none
  /// Nodes of the source that face no target and have no pair, in walking order.
  std::vector<Eigen::Index> unpaired;
  Eigen::VectorXd slid =
      {};  ///< `n_c` slip where no unknown moves [length]; empty: 0, see GapOptions::since
};

/// \param arm     from a point to a place [length]
/// \param normal  unit vector [-]
/// \return the moments about that point of a force of one there along the normal, and along its tangent [length]
inline Eigen::RowVector2d moments_at(const Eigen::Vector2d& arm, const Eigen::Vector2d& normal) {
  return {arm.x() * normal.y() - arm.y() * normal.x(), -arm.dot(normal)};
}

/// Weights of pairs that are nodes: what a pressure of one on the side does along the normal of each pair. A side that hardly
/// faces the target, by 60 degrees or more, counts with half of its share: at 90 degrees it would weigh nothing.
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
