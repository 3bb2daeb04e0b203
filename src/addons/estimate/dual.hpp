// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The dual solution of a goal: what each load, and each initial gap, counts for it.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "addons/estimate/goal.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/ledger.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {

/// Displacements and forces of the dual problem.
struct DualSolution {
  Eigen::VectorXd displacement;  ///< z `n`, without its rigid part [goal/force]
  Eigen::VectorXd force;         ///< mu, of all rows of A, 0 of those that can move [goal/length]
  Eigen::VectorXd rigid;         ///< the part of z that moves whole bodies `n` [goal/force]
};

/// The dual problem of a solved model, with the pairs as they are: closed rows C of A, sticking slips among them, stay
/// closed and are equations; all others carry no force. On the factor and the compliance in hand,
///
/// \f[ K z + A_C^T \mu = j,\qquad A_C z = w_C,\qquad N^T (j - A_C^T \mu) = 0 \f]
///
/// costs the dense system of the closed pairs, factored once for all goals, and one back substitution with K for j, if any,
/// and one for mu. The solution itself is a sum over its data: \f$ J = p^T z + g_C^T \mu \f$, but for what held
/// nodes and cohesion say directly. Where pairs slide, their friction forces follow the normal ones, \f$ f = Z f_C \f$: the
/// dual system is the transpose, \f$ Z^T (A z - w) = 0 \f$ in the place of \f$ A_C z = w_C \f$.
class Dual {
 public:
  /// \param model      from build(); must outlive this, as the others
  /// \param condensed  from condense() of it
  /// \param solution   of it, solved
  /// \throws ProblemError if the problem is not solved, or the forces of the closed pairs are not unique
  Dual(const Model& model, const Condensed& condensed, const Solution& solution);

  /// \param goal    how it changes
  /// \param ledger  gets the count `solves`
  /// \return z and mu
  [[nodiscard]] DualSolution solve(const GoalGradient& goal, Ledger& ledger) const;

  /// \return the rows that are closed, in increasing order: gaps, then slips
  [[nodiscard]] const std::vector<Eigen::Index>& closed() const { return set_.closed; }

  /// \return whether a pair with friction slides
  [[nodiscard]] bool slides() const { return !set_.sliding.empty(); }

  /// What an open pair would carry if it were closed where it is.
  /// \param pair  open, where none slides
  /// \return its force, < 0: it would have to pull [force]
  [[nodiscard]] double force_to_close(Eigen::Index pair) const;
  /// What a closed pair would overlap by if it carried nothing.
  /// \param pair  closed, where none slides
  /// \return its gap, < 0 [length]
  [[nodiscard]] double gap_without(Eigen::Index pair) const;

 private:
  /// Forces of the closed rows, and amplitudes, that add so much to their movements and resultants.
  [[nodiscard]] std::pair<Eigen::VectorXd, Eigen::VectorXd> forces(
      const Eigen::VectorXd& top, const Eigen::VectorXd& bottom) const;

  const Model& model_;
  const Condensed& condensed_;
  const Solution& solution_;
  ScaledProblem scaled_;
  ActiveSet set_;                          // with the slopes of scaled forces
  std::optional<ActiveSetSystem> system_;  // where no pair slides
  LuFactor transposed_;                    // where one does
};

}  // namespace signorini
