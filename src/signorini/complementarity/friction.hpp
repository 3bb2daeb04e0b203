/// \file
/// Contact with friction and cohesion, for one load step, condensed on the contact unknowns.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/complementarity/problem.hpp"

namespace signorini {

/// Find normal forces, friction forces and rigid amplitudes a with
///
/// \f[ \begin{pmatrix} gap \\ slip \end{pmatrix} = \begin{pmatrix} d \\ s \end{pmatrix}
///     + F \begin{pmatrix} \lambda \\ \tau \end{pmatrix} + R a,\qquad
///     R^T \begin{pmatrix} \lambda \\ \tau \end{pmatrix} = r, \f]
///
/// lambda >= 0, gap >= 0, lambda gap = 0, and \f$ |\tau_i| \le b_i = \mu_i\lambda_i + c_i \f$ where the
/// pair is closed, 0 where it is open; a pair slides only against a friction force at its bound:
/// slip > 0 needs tau = -b, slip < 0 needs tau = b.
struct FrictionProblem {
  Eigen::MatrixXd compliance;  ///< F `2 n_c x 2 n_c` gaps first, then slips [length/force]
  Eigen::VectorXd free_gap;    ///< d `n_c` [length]
  Eigen::VectorXd free_slip;   ///< s `n_c` [length]
  Eigen::VectorXd coefficient;  ///< mu `n_c` >= 0 [-]
  Eigen::VectorXd cohesion;     ///< c `n_c` >= 0 [force], of closed pairs only
  Eigen::MatrixXd rigid = {};      ///< R `2 n_c x n_r` [length/amplitude]; no columns if bodies are held
  Eigen::VectorXd resultant = {};  ///< r `n_r` [force*length/amplitude]
};

/// What a pair does.
enum class PairStatus { Open, Stick, Slip };

/// A solution of a friction problem.
struct FrictionState {
  Eigen::VectorXd force;           ///< lambda `n_c` [force], compression > 0
  Eigen::VectorXd friction;        ///< tau `n_c` [force], on the source along the tangent
  Eigen::VectorXd gap;             ///< `n_c` [length]
  Eigen::VectorXd slip;            ///< `n_c` [length], of the source along the tangent
  Eigen::VectorXd amplitude;       ///< a `n_r`
  std::vector<PairStatus> status;  ///< `n_c`
  Report report;                   ///< how the solver got there
};

}  // namespace signorini
