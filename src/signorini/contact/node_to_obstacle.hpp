/// \file
/// The gaps between the nodes of one boundary and a rigid obstacle.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "signorini/contact/obstacle.hpp"
#include "signorini/elasticity/unknowns.hpp"
#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// Linear gaps gap = initial_gap - A u of candidate pairs, and what turns forces into pressures.
struct Gaps {
  /// `n_c x n` [-]: minus the normal, in the columns of the node's unknowns.
  Eigen::SparseMatrix<double, Eigen::RowMajor> A;
  Eigen::VectorXd initial_gap;  ///< `n_c` [length], given displacements included; overlap < 0
  Eigen::VectorXd weight;       ///< `n_c` share of the boundary [length^2]: pressure = force / it
  NodeArray position;           ///< `n_c x 2` where the pairs are before loading [length]
  NodeArray normal;             ///< `n_c x 2` out of the obstacle [-]
  std::vector<Eigen::Index> node;  ///< `n_c` node of each pair
};

/// One pair per node of the boundary that can still move along its normal. \PaperEq{XuanLi2002, 13}
///
/// The normal points out of the obstacle, so that u along it opens the gap: the row of A is minus
/// the normal. The weight of a node is the integral of its shape function along the boundary times
/// the thickness: half a side at the ends of a linear boundary, 1/6 and 4/6 of a side for the
/// corners and midpoints of a quadratic one.
/// \param mesh       of the body, the source (slave)
/// \param boundary   its boundary that may touch
/// \param obstacle   the target (master)
/// \param unknowns   `n` numbered displacements of the mesh
/// \param thickness  of the body across the plane [length]
/// \return the gaps of `n_c` pairs, in the order of boundary_nodes()
/// \throws ProblemError if the boundary does not exist or is held by supports across whole sides,
///   if a held node overlaps the obstacle, which no contact force can undo, or if the obstacle
///   gives a gap that is not finite
[[nodiscard]] Gaps node_to_obstacle(const Mesh& mesh, const std::string& boundary,
                                    const Obstacle& obstacle, const Unknowns& unknowns,
                                    double thickness);

}  // namespace signorini
