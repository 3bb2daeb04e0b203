/// \file
/// The last step of every exact method: the equations of a known set, from the original data.
#pragma once
#include <functional>
#include <memory>

#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/corrections.hpp"

namespace signorini {

/// u += N a, a motion that strains nothing: the part of u that is kept as such grows too. A part that shrinks, because
/// motions cancel, is left with the rounding of what it was, which strains: it becomes the motion nearest to it.
/// \param solution      whose displacement grows
/// \param null_vectors  N `n x n_r`
/// \param amplitude     a `n_r`
/// \param home          whether bodies are where they belong: a rigid part that is larger than u, because forces out of balance
///   took a body far away on its springs and back, becomes the motion nearest to u
void add_rigid(PrimalDual& solution, const Eigen::MatrixXd& null_vectors,
               const Eigen::VectorXd& amplitude, bool home = false);

/// What iterative_refinement() and check_signs() take their equations from.
struct RefinementData {
  /// K, p, A, g as posed; with friction the last rows of A are -T
  const QuadraticProgramme& programme;
  /// K^-1 applied to a vector [force] -> [length]; need not be accurate
  const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve_stiffness;
  /// Only compliance and rigid, which may be inaccurate, and law count
  const ContactProblem& condensed;
  const ScaledProblem& scaled;          ///< `condensed`, equilibrated
  const Eigen::MatrixXd& null_vectors;  ///< N, or nothing if K is regular
  /// What is left of a residual [force] where forces of all rows [force] close some of them; empty: all of it. K u should do no
  /// work along rigid motions, but the entries of K are rounded: what u is made to bear of that work, contact forces need not.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& residual, const Eigen::VectorXd& force,
                                const std::vector<Eigen::Index>& rows)>
      spread = {};
  const KnownMatrices* known = nullptr;  ///< of `programme`; null if they are not known
};

/// What iterative_refinement() did.
struct RefinedSolution {
  PrimalDual solution;        ///< u in two parts, and the forces of all rows of A
  Eigen::VectorXd movement;   ///< initial_gap - A u of all rows of A: gaps, then slips [length]
  Eigen::VectorXd amplitude;  ///< how much of each rigid mode went into u `n_r`
  std::shared_ptr<const ActiveSetSystem> system = {};  ///< the system of its set
  Eigen::Index solves = 0;                             ///< with K
  bool settled = false;  ///< whether corrections have become as small as rounding
};

/// Refines \f$ K u + A^T f = p,\ A_W u = g_W \f$ for known statuses: rows W that do not move, friction forces at
/// their bounds, no force anywhere else.
///
/// A sweep takes residuals of the original data in twice the working precision, and corrects u, then the forces, then u by
/// what these move:
///
/// \f[ r = p - Ku - A^Tf,\quad u \mathrel{+}= K^{-1}r,\qquad h = g_W - A_Wu,\quad
///     J\begin{pmatrix}\Delta f_W\\ \Delta b\end{pmatrix} = -\begin{pmatrix}h\\ N^Tr\end{pmatrix},\quad
///     f_W \mathrel{+}= \Delta f_W,\quad u \mathrel{+}= N\Delta b - K^{-1}A^T\Delta f, \f]
///
/// where J is the matrix of ActiveSetSystem. The factor and the compliance may carry relative errors up to about 1/cond.
/// u and the forces are kept as sums of two doubles: on a slender body the last digit of a force moves the far end by
/// many digits. Corrections says when sweeps end: mostly behind the first. With rigid modes two sweeps move bodies as such,
/// which rounds the rigid part of u; they leave out the last solve, and the end is one of those that follow. That solve is
/// also left out where forces change by rounding only, and move nothing more than that.
///
/// With rigid modes K is singular, and `solve_stiffness` and `condensed` belong to the grounded K_g of
/// add_rigid_modes(). Residuals are still those of K; the amplitudes take up what only a rigid
/// motion feels of them, so that no spring takes part.
/// \param data     the problem
/// \param start    u, and the forces that it belongs to: none, if u is still that without contact
/// \param force    of all rows of A, to begin with; those that the statuses exclude are dropped [force]
/// \param statuses  `n_c`
/// \return the refined numbers; whether all signs are right is for check_signs() to say
/// \throws std::invalid_argument if the sizes of K, p, A, g, `start` and N do not fit
[[nodiscard]] RefinedSolution iterative_refinement(const RefinementData& data, PrimalDual start,
                                                   const Eigen::VectorXd& force,
                                                   const std::vector<ContactStatus>& statuses);

/// What is out of balance along rigid modes.
/// \param programme     K, p, A
/// \param solution      u and f
/// \param null_vectors  N `n x n_r`, or nothing
/// \param rounding      of the terms counts as none; as many roundings as K has entries in a row are added
/// \return `n_r` N^T (p - K u - A^T f), 0 where it is of rounding size [force]
[[nodiscard]] Eigen::VectorXd resultant_left(const QuadraticProgramme& programme,
                                             const PrimalDual& solution,
                                             const Eigen::MatrixXd& null_vectors, double rounding);

/// What refined numbers say of every pair.
struct SignCheck {
  std::vector<ContactStatus> statuses;  ///< what the pairs would rather do
  Eigen::Index wrong = 0;               ///< pairs that would rather do something else
  bool confirmed = false;               ///< refined, balanced and no pair wrong: the solution
};

/// Refined numbers in the units of the equilibrated problem, for predict().
/// \param data      the problem
/// \param solution  as refined, forces `n_c + n_s` [force]
/// \param movement  `n_c + n_s` of all rows [length]
/// \param part      of the largest force, and of the largest displacement and initial gap, that counts as
///   rounding [-]
/// \return forces and movements of all rows with these roundings [sqrt(energy)]
[[nodiscard]] ActiveSetSolution scaled_numbers(const RefinementData& data,
                                               const PrimalDual& solution,
                                               const Eigen::VectorXd& movement, double part);

/// Looks at all signs beyond rounding, by predict(): closed pairs press, open ones do not overlap, friction
/// forces of sticking pairs keep their bound, sliding ones resist.
/// \param data     the problem
/// \param refined  from iterative_refinement() for `statuses`
/// \param statuses  `n_c` what was assumed
/// \return the verdict
[[nodiscard]] SignCheck check_signs(const RefinementData& data, const RefinedSolution& refined,
                                    const std::vector<ContactStatus>& statuses);

}  // namespace signorini
