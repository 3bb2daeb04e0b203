/// \file
/// The one check of proofs that nothing solves a condensed problem.
#pragma once
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Whether y proves that nothing solves a problem, checked on G and d in twice the working precision.
///
/// With y >= 0, \f$ G^T y = 0 \f$ and d^T y < 0 the gaps of any forces sum to \f$ y^T(d + G\lambda) = d^T y < 0
/// \f$. Computed numbers give G^T y = 0 but for rounding, allowed here to be 1e3 epsilon of the largest that it
/// could be; so the forces that lift the sum to zero, at least \f$ -d^T y / \max_i |G^T y|_i \f$, must be out of
/// reach as well: beyond \f$ 1/\sqrt{\epsilon} \f$ times the one that closes the deepest free overlap alone, all
/// in the units of equilibrate(). And d^T y must exceed what rounding did to d. The same is asked of a
/// programme by proves_infeasible().
/// \param problem  G and d as they were posed, or any M and q
/// \param y        `n_c`, or of another size, which proves nothing
/// \return whether it does
[[nodiscard]] bool refutes(const ContactProblem& problem, const Eigen::VectorXd& y);

/// The same with G = H^T H, so that G y carries the rounding of H y and not that of a product.
/// \param problem  H and d as they were posed
/// \param y        `n_c`, or of another size, which proves nothing
/// \return whether it does
[[nodiscard]] bool refutes(const HalfProblem& problem, const Eigen::VectorXd& y);

}  // namespace signorini
