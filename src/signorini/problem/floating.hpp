/// \file
/// Contact of a body that nothing but contact holds: rigid modes are unknowns, and forces balance a load.
#pragma once
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/problem.hpp"

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
