// # Dual functions of an edge
//
// A weighted gap of node \f$i\f$ is \f$\int\psi_i\,g\,/\int\psi_i\f$. With \f$\psi_i = N_i\f$ the
// gap of a node would contain the displacements of its neighbours too, and the gaps along a
// boundary would be coupled by a matrix. Let \f$m_1, m_2\f$ be the means of \f$N_1, N_2\f$ over
// the covered part, \f$c\f$ and \f$v\f$ the mean and the variance of \f$s\f$ there. The ansatz
// \f$\psi_2 = m_2 + k\,(s - c)\f$ has the same mean as \f$N_2\f$, and
//
// \f[ \text{mean}(\psi_2 N_1) = m_1 m_2 - \tfrac12 k v = 0 \quad\text{gives}\quad k = 2 m_1 m_2 / v. \f]
//
// On a whole edge \f$m_1 = m_2 = \tfrac12\f$ and \f$v = \tfrac13\f$, so that
// \f$\psi_2 = (1 + 3s)/2\f$: it runs from -1 to 2. If the part from \f$s = -1\f$ to 0.5 is
// covered, \f$\psi_2\f$ runs from -1.25 to 2.25 there.
//
// A node that faces the target with less than half of its share would need ever steeper lines.
// From \f$(1 + s)^2/4 < 1/2\f$, that is \f$s < 0.414\f$, the second end hands its part of this
// edge to the first one.

#include "signorini/pairing/dual_basis.hpp"

namespace signorini {
namespace {

/// Slack of comparisons that exact arithmetic may decide as a tie: symmetric data, symmetric
/// answer.
constexpr double slack = 1e-9;

}  // namespace

DualBasis dual_basis(const std::vector<EdgePoint>& covered, const Eigen::Vector2d& share) {
  DualBasis basis;
  for (const EdgePoint& point : covered) {
    basis.length += point.length;
    basis.mean += point.length * end_shape(point.s);
  }
  if (basis.length == 0) return basis;
  const Eigen::Vector2d part = basis.mean.cwiseQuotient(share);
  basis.mean /= basis.length;
  basis.centre = basis.mean(1) - basis.mean(0);
  if (part.minCoeff() < 0.5 - slack) {
    const bool second = part(1) > part(0) * (1 + slack);
    basis.mean = second ? Eigen::Vector2d(0, 1) : Eigen::Vector2d(1, 0);
    return basis;
  }
  double variance = 0;
  for (const EdgePoint& point : covered)
    variance += point.length / basis.length * (point.s - basis.centre) * (point.s - basis.centre);
  // A single point has no spread: both ends see the same gap.
  if (covered.size() > 1) basis.slope = 2 * basis.mean(0) * basis.mean(1) / variance;
  return basis;
}

}  // namespace signorini
