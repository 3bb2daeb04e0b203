/// \file
/// Contact of a body that nothing but contact holds: rigid modes are unknowns, and forces balance a load.
#pragma once
#include "signorini/complementarity/certificate.hpp"
#include "signorini/complementarity/problem.hpp"
#include "signorini/complementarity/solvers.hpp"

namespace signorini {

/// A contact problem with rigid modes: find forces >= 0 and amplitudes a with
///
/// \f[ gap = d + G\lambda + R a \ge 0,\qquad \lambda^T gap = 0,\qquad R^T\lambda = r. \f]
///
/// Column j of R is what mode j opens each gap by, and r what the contact forces must add up to. With
/// the gap matrix A, null vectors N of the stiffness and the load p, R = -A N and r = -N^T p: contact
/// pushes the body against the load.
struct FloatingProblem {
  ContactProblem contact;     ///< G and d for any one way of holding the modes
  Eigen::MatrixXd rigid;      ///< R `n_c x n_r` [gap/amplitude]
  Eigen::VectorXd resultant;  ///< r `n_r` [force*gap/amplitude]
};

/// A solution of a floating problem.
struct FloatingState {
  ContactState
      contact;  ///< forces, gaps, closed pairs and the report, with iterations of all passes
  Eigen::VectorXd amplitude;  ///< a `n_r`
  Eigen::Index passes = 0;    ///< contact problems solved on the way, 0 if none was needed
  /// Proof that no forces hold the body, or empty: a direction a `n_r` that closes no gap, R a >= 0,
  /// while the load does work along it, r^T a < 0. It would move that way for ever.
  Eigen::VectorXd escape = {};
};

/// Solves a floating problem with any member of the family.
///
/// Springs on the modes, of compliance rho and anchored at a, turn it into a contact problem with
/// \f$ G + \rho R P R^T \f$ and \f$ d + R (a - \rho P r) \f$. Its forces and the new amplitude
/// \f$ a + \rho P (R^T\lambda - r) \f$ satisfy every condition but one: the springs still carry
/// \f$ R^T\lambda - r \f$. So the anchor is moved there, and again: the method of multipliers
/// [\ref Rockafellar1976], akin to the minimum that Xuan and Li move. As soon as a new set of closed
/// pairs W appears,
///
/// \f[ \begin{pmatrix} G_{WW} & R_W \\ R_W^T & 0 \end{pmatrix}
///     \begin{pmatrix} \lambda_W \\ a \end{pmatrix} =
///     \begin{pmatrix} -d_W \\ r \end{pmatrix} \f]
///
/// is solved and refined; if all signs are right beyond rounding, that is the solution, and no spring
/// is left in it. A member with `solve_floating` first tries the whole problem at once, and the springs
/// come in where that fails. Nothing is to be tuned: on equilibrated data \f$ P = (R^T R)^{-1} \f$ and rho is the
/// trace of G, twice as much after each pass that did not halve the spring forces. The first anchor is
/// where the body meets the first obstacle when it follows its load.
///
/// Whether forces >= 0 can balance r at all is decided before, by the point of the cone of all
/// \f$ R^T\lambda \f$ that is closest to r: what is missing there is the direction of escape.
/// \param problem  G, d, R, r
/// \param solver   a member of solvers()
/// \param options  handed to it
/// \return `Solved`; `Infeasible` with `escape` if the load pulls the body away, or with the vector y of
///   ContactState, for which also R^T y = 0, if gaps contradict each other; `IterationLimit` after 100
///   passes; else what the solver said. If fewer pairs close than there are modes, the amplitude is one of many
/// \throws std::invalid_argument as check_problem() and the solver, or if R or r do not fit
[[nodiscard]] FloatingState solve(const FloatingProblem& problem, const Solver& solver,
                                  const SolverOptions& options = {});

/// Certificate of (lambda, gap, a) against G, d, R and r.
///
/// As certify() for a contact problem, with gap = d + G lambda + R a. `equilibrium` is also the largest
/// entry of R^T lambda - r, each over the largest of its terms; the energies include r^T a.
/// \param problem  as it was posed
/// \param state    forces, gaps and amplitudes; its status is not looked at
/// \return the figures; all infinite if a number is not finite
/// \throws std::invalid_argument if sizes do not fit, or as check_problem()
[[nodiscard]] Certificate certify(const FloatingProblem& problem, const FloatingState& state);

}  // namespace signorini
