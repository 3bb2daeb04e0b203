// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Dense programmes with a singular stiffness whose null vectors are known: bodies that float.
#pragma once
#include <Eigen/Core>

#include "addons/programme/dense_programme.hpp"

namespace signorini {

/// Grounds the rigid modes of a body and eliminates the displacements.
///
/// \f$ K_s = K + C C^T \f$ adds one spring per mode, with \f$ C = D N (N^T D N)^{-1/2} \f$ and D the
/// diagonal of K: every unknown is held in proportion to its own stiffness, whatever its unit, and
/// scaled by D the springs have the mean of the eigenvalues of K. They change no solution:
///
/// K N = 0 and symmetry give N^T K = 0. So N^T f = N^T K_s x = N^T C C^T x for f = K_s x, where N^T C
/// is regular. If f is in balance, N^T f = 0, then C^T x = 0: the springs carry nothing, and K x = f.
/// All solutions of K u = f are u = K_s^-1 f + N a. With f = p - A^T lambda, balance reads
/// R^T lambda = r, which the floating problem demands, and the gaps are g - A u = d + G lambda + R a.
/// \param programme     K singular, p, A, g, no equations
/// \param null_vectors  N `n x n_r`: all rigid modes, independent, K N = 0
/// \return the factor of K_s, \f$ H = L^{-1} A^T \f$, the floating problem G = H^T H, d = g - A K_s^-1 p, R = -A N, r = -N^T p,
///   and the displacement K_s^-1 p of the grounded body
/// \throws std::invalid_argument if sizes do not fit, a number is not finite or there are equations
/// \throws ProblemError if a column of N is stretched by K, if the columns are dependent, or if the
///   grounded stiffness is not positive definite to rounding: then a mode is missing in N
[[nodiscard]] DenseCondensed condense(const DenseProgramme& programme,
                                      const Eigen::MatrixXd& null_vectors);

/// A solution of a dense programme with rigid modes.
struct FloatingSolution {
  DenseSolution dense;        ///< as for a programme without rigid modes
  Eigen::VectorXd amplitude;  ///< a `n_r`, of the columns of N on top of the grounded body
  Eigen::VectorXd
      unbounded_direction;  ///< as in ContactState: the body would move along N * unbounded_direction; or empty
};

/// Grounds, solves, recovers u, refines u and lambda with residuals of the K that was posed, and
/// certifies.
/// \param programme     K singular, p, A, g, no equations
/// \param null_vectors  N `n x n_r`
/// \param solver        a member of solvers()
/// \param options       handed to it
/// \return the solution; look at its `dense.report.status` first. A solution that the certificate does
///   not confirm to 1e-12 is called `Breakdown`
/// \throws std::invalid_argument, ProblemError as condense() and the solver
[[nodiscard]] FloatingSolution solve(const DenseProgramme& programme,
                                     const Eigen::MatrixXd& null_vectors, const Solver& solver,
                                     const SolverOptions& options = {});

}  // namespace signorini
