/// \file
/// Dual functions of the source: what weighs the gaps of an edge for its two ends.
///
/// Dual means: \f$\psi_1\f$ averages to zero against \f$N_2\f$, and \f$\psi_2\f$ against \f$N_1\f$.
/// The gap of a node then contains the displacement of this node of the source and of no other, and
/// the contact force of a node acts on that node alone.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// A place on an edge where something is integrated.
struct EdgePoint {
  double s;  ///< from -1 at the first end to 1 at the second [-]
  double
      length;  ///< of the edge that it stands for [length]; in axial symmetry times its radius [length^2]
};

/// The linear shape functions of the two ends of an edge.
/// \param s  place in [-1, 1] [-]
/// \return \f$ N = ((1 - s)/2,\ (1 + s)/2) \f$ [-]
[[nodiscard]] inline Eigen::Vector2d end_shape(double s) { return {0.5 * (1 - s), 0.5 * (1 + s)}; }

/// Two straight lines psi over the covered part C of an edge, which average as the shape
/// functions N of the ends do, and are blind to the other end [\ref Wohlmuth2000]:
///
/// \f[ \int_C \psi_i N_j\,d\Gamma = \delta_{ij} \int_C N_i\,d\Gamma,\qquad \psi_1 + \psi_2 = 1. \f]
///
/// If the gap is a straight line between the ends, \f$ \int\psi_i\,gap / \int\psi_i \f$ is therefore
/// the gap at end i. The sum makes equal pressures of the ends a uniform pressure.
struct DualBasis {
  Eigen::Vector2d mean = {0, 0};  ///< of psi_1, psi_2 over C, with sum 1 [-]
  double slope = 0;               ///< d psi_2/ds = -d psi_1/ds [-]
  double centre = 0;              ///< mean s over C [-]
  double length = 0;              ///< of C, as EdgePoint counts it

  /// \param s  place in [-1, 1] [-]
  /// \return psi_1, psi_2 [-]
  [[nodiscard]] Eigen::Vector2d value(double s) const {
    const double change = slope * (s - centre);
    return {mean(0) - change, mean(1) + change};
  }
};

/// Dual functions of an edge of which a part is covered [\ref CichoszBischoff2011].
///
/// With the means m_i of N_i over C and the variance v of s there, psi_2 = m_2 + 2 m_1 m_2 (s - centre)/v.
/// On a whole straight edge that is (1 + 3 s)/2. As C shrinks towards one end, the line of
/// the other one keeps its steepness while its integral vanishes: its gap would be that of the target
/// prolonged to where the target has long ended, and a pressure there a lever. So an end that has less
/// than half of its share of the edge covered hands it to the other one, which then weighs all of C
/// with psi = 1; if neither has half, the one with more takes it. The sum remains 1.
/// \param covered  points of C with positive lengths; the integrals above are sums over them
/// \param share    integrals of N_1, N_2 over the whole edge, by the same rule
/// \return the functions; all zero if nothing is covered
[[nodiscard]] DualBasis dual_basis(const std::vector<EdgePoint>& covered,
                                   const Eigen::Vector2d& share);

}  // namespace signorini
