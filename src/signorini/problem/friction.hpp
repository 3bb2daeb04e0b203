/// \file
/// Contact with friction and cohesion, for one load step, condensed on the contact unknowns.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/problem/certificate.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Find normal forces, friction forces and rigid amplitudes a with
///
/// \f[ \begin{pmatrix} gap \\ slip \end{pmatrix} = \begin{pmatrix} d \\ s \end{pmatrix}
///     + F \begin{pmatrix} \lambda \\ \tau \end{pmatrix} + R a,\qquad
///     R^T \begin{pmatrix} \lambda \\ \tau \end{pmatrix} = r, \f]
///
/// lambda >= 0, gap >= 0, lambda gap = 0, and \f$ |\tau_i| \le b_i = \mu_i\lambda_i + c_i \f$ where the
/// pair is closed, 0 where it is open; a pair slides only against a friction force at its bound:
/// slip > 0 needs tau = -b, slip < 0 needs tau = b. \PaperEq{LinEtAl, 6}, \PaperEq{LinEtAl, 8}
///
/// With c > 0 a solution need not exist: a pair that only the friction force of its cohesion would
/// pull open has no force to stay closed with, and once open no friction force that pulls. With rigid
/// modes it need not exist either: pairs that could balance r may not be pressed hard enough. For held
/// bodies without cohesion and a positive definite F there is one for every mu, see friction_lemke().
struct FrictionProblem {
  Eigen::MatrixXd compliance;   ///< F `2 n_c x 2 n_c` gaps first, then slips [length/force]
  Eigen::VectorXd free_gap;     ///< d `n_c` [length]
  Eigen::VectorXd free_slip;    ///< s `n_c` [length]
  Eigen::VectorXd coefficient;  ///< mu `n_c` >= 0 [-]
  Eigen::VectorXd cohesion;     ///< c `n_c` >= 0 [force], of closed pairs only
  Eigen::MatrixXd rigid =
      {};  ///< R `2 n_c x n_r` [length/amplitude]; no columns if bodies are held
  Eigen::VectorXd resultant = {};  ///< r `n_r` [force*length/amplitude]
};

/// What a pair does.
enum class PairStatus { Open, Stick, Slip };

/// Whether other forces would do as well.
enum class Uniqueness {
  Proved,   ///< no other solution exists, for any free gaps and slips
  Unknown,  ///< nothing was found that speaks for another solution, or against it
  Doubtful  ///< a warning: others may exist, see uniqueness()
};

/// A solution of a friction problem, if `report.status` is Solved.
struct FrictionState {
  Eigen::VectorXd force;           ///< lambda `n_c` [force], compression > 0
  Eigen::VectorXd friction;        ///< tau `n_c` [force], on the source along the tangent
  Eigen::VectorXd gap;             ///< `n_c` [length]
  Eigen::VectorXd slip;            ///< `n_c` [length], of the source along the tangent
  Eigen::VectorXd amplitude;       ///< a `n_r`
  std::vector<PairStatus> status;  ///< `n_c`
  Report report;                   ///< how the solver got there
  Uniqueness uniqueness = Uniqueness::Unknown;  ///< of a solution
  std::string reason = {};  ///< what stopped the solver, in words; empty if it did not stop short
  /// Proof that no forces balance r, or empty: see escape().
  Eigen::VectorXd escape = {};
};

/// Checks sizes and numbers.
/// \param problem  any
/// \throws std::invalid_argument unless all sizes fit, F is symmetric to rounding without a negative
///   diagonal entry, mu and c are >= 0, and all numbers are finite
void check_problem(const FrictionProblem& problem);

/// The certificate of a claimed solution, recomputed from the data in twice the working precision.
///
/// As certify() for a contact problem, with slips beside gaps; `equilibrium` is also the largest R^T f - r over
/// its terms, and there is no duality gap. Open or closed as in certify() for a programme with friction.
/// \param problem  as it was posed
/// \param state    forces, friction forces, gaps, slips and amplitudes; nothing else is looked at
/// \return the figures; all infinite if a number is not finite
/// \throws std::invalid_argument if sizes do not fit, or as check_problem()
[[nodiscard]] Certificate certify(const FrictionProblem& problem, const FrictionState& state);

}  // namespace signorini
