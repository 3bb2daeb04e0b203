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
/// tangent, and the target (master) the other way. Gaps of several points are divided by their weight,
/// so that gap and slip are lengths and a force divided by the weight is a pressure.
struct Pairs {
  NodalRows opening;            ///< N `n_c x 2 n_nodes` [-]
  NodalRows sliding;            ///< S `n_c x 2 n_nodes` [-]; no entries unless asked for
  Eigen::VectorXd initial_gap;  ///< g `n_c` before any displacement [length]; overlap < 0
  Eigen::VectorXd weight;       ///< `n_c` share of the source [length^2]: pressure = force / it
  NodeArray position;           ///< `n_c x 2` on the source before loading [length]
  NodeArray normal;             ///< `n_c x 2` out of the target [-]; the tangent is (n_y, -n_x)
  std::vector<Eigen::Index>
      node;  ///< `n_c` source node of each pair in its own mesh; -1 if it has none
  /// Nodes of the source that face no target and have no pair, in walking order.
  std::vector<Eigen::Index> unpaired;
};

/// One boundary of one body.
struct Surface {
  const Mesh& mesh;             ///< of the body
  std::string boundary;         ///< its name
  Eigen::Index first_node = 0;  ///< number of the body's first node among the nodes of all bodies
};

}  // namespace signorini
