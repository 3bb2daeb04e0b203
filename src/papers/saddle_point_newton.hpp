/// \file
/// The uncondensed Newton method of the second paper: displacements and contact forces together.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/certificate.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Which equations saddle_point_newton() solves, and when it stops.
enum class SaddlePointForm {
  OneUnit,    ///< gaps and forces scaled to one unit; stops when certify() holds
  AsPrinted,  ///< (28) as it stands, a length beside a force; stops when |F| is small
};

/// Choices for saddle_point_newton().
struct SaddlePointOptions {
  Eigen::Index iteration_limit = 100;  ///< factorisations at most
  /// Where it stops [-]: for OneUnit, the worst figure of the certificate; AsPrinted, |F| over its start.
  double tolerance = 1e-12;
  SaddlePointForm form = SaddlePointForm::OneUnit;  ///< of the equations
  Eigen::VectorXd start_force = {};  ///< `n_c` lambda to start from [force]; none if empty
};

/// What the method came to.
struct SaddlePointSolution {
  PrimalDual solution;  ///< u in two parts, and lambda
  /// `iterations` are factorisations; `residual` in the history is |F| over its size at the start.
  Report report;
};

/// Solves for displacements and contact forces together, by Newton's method with a sparse LU factor of
/// the whole Jacobian in every iteration.
///
/// Equilibrium and one Fischer-Burmeister equation per pair, \PaperEq{LinEtAl, 28}, \PaperEq{LinEtAl, 30}
///
/// \f[ F = \begin{pmatrix} K u + A^T\lambda - p \\ \varphi(g - A u, \lambda) \end{pmatrix} = 0,
///     \qquad
///     J = \begin{pmatrix} K & A^T \\ -D_a A & D_b \end{pmatrix}, \f]
///
/// with the diagonal matrices of the slopes of \f$ \varphi \f$, \PaperEq{LinEtAl, 31} with
/// -a, as lambda is a pressure (chapter 9, one sign). It starts at u = 0
/// with the forces that are given. Both residuals are summed in twice the working precision and u is kept in two
/// parts, so the last steps are also the refinement.
///
/// In the paper's form, AsPrinted, \f$ \varphi \f$ compares a length with a force. The paper names neither
/// a step length nor a test. Whole steps are our choice, and so is the end where |F|, forces and lengths
/// mixed, is `tolerance` of its start: it depends on the units. The default compares numbers of one unit, gap / sqrt(s c_i) and
/// lambda sqrt(s c_i), where \f$ c_i = \sum_j A_{ij}^2 / K_{jj} \f$ is the compliance of a pair whose
/// neighbours stand still and s how much more forces on all pairs do; row j of equilibrium counts as
/// force / sqrt(K_jj). s costs a factor of K; without it the steps grow with the number of
/// pairs. The first step is taken whole, as equilibrium is linear and holds from then on, others as
/// far as |F| falls (Armijo's rule), and the method stops when certify() holds to `tolerance`.
///
/// The time of a step is that of J, its factor, a solve with it, the residuals at every length that is tried and,
/// OneUnit, one certificate; in a plane mesh the factor outweighs the rest.
///
/// A body that nothing but contact holds has a singular K. J is regular where enough pairs touch or push
/// at the start, and singular where all are open and without force: give `start_force` an equal share of
/// the load.
/// \param programme  K, p, A, g
/// \param options    limits, and which form
/// \return OneUnit, `Solved` with a certificate of `tolerance`; AsPrinted, only with one of 1e-12, whatever
///   `tolerance`. `Breakdown` if J is singular to working precision, if |F| falls no more, or if the
///   paper's form stops at what is no solution; `IterationLimit`
/// \throws std::invalid_argument if sizes do not fit, or if a force to start from is not finite
[[nodiscard]] SaddlePointSolution saddle_point_newton(const QuadraticProgramme& programme,
                                                      const SaddlePointOptions& options = {});

}  // namespace signorini
