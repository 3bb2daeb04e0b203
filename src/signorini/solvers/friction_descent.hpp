/// \file
/// What the Newton methods for friction share: the line search and the exact end.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/closing/friction_closure.hpp"

namespace signorini {

class FrictionEquations;

/// How a formulation writes the law of friction: the tangential equations, and those of the unknowns that it
/// adds to forces and amplitudes.
struct FrictionFormulation {
  Eigen::Index added;  ///< unknowns and equations per pair, behind those of FrictionEquations
  /// Sets the added unknowns where the others are given; null if there are none.
  void (*start)(const FrictionEquations& equations, Eigen::VectorXd& x);
  /// Evaluates the tangential equations and the added ones, at equations.movement().
  void (*evaluate)(const FrictionEquations& equations, const Eigen::VectorXd& x,
                   Eigen::VectorXd& residual);
  /// Evaluates their derivatives. Row n_c + i of J still holds d slip_i / d x.
  void (*differentiate)(const FrictionEquations& equations, const Eigen::VectorXd& x,
                        Eigen::MatrixXd& J);
};

/// Contact with friction as equations Phi(x) = 0.
///
/// The unknowns x are forces `2 n_c`, amplitudes `k`, and what a law adds. The first equations belong to
/// the pairs, those from `2 n_c` on are R^T f = r, then come those of the law. Forces are measured by the
/// gaps that such forces on all pairs make, as in fischer_burmeister().
class FrictionEquations {
 public:
  /// \param problem  scaled by equilibrate(); must outlive this
  /// \param law      must outlive this
  FrictionEquations(const ScaledFriction& problem, const FrictionFormulation& law);

  /// \return the number of unknowns
  [[nodiscard]] Eigen::Index size() const { return (2 + law_.added) * pairs() + modes(); }
  /// Decides which pairs carry cohesion, those whose force exceeds their gap, and sets the added unknowns.
  /// \param x  all unknowns
  void start(Eigen::VectorXd& x);
  /// Decides which pairs carry cohesion: those whose force exceeds their gap. \param x  all unknowns
  void choose_closed(const Eigen::VectorXd& x);
  /// Evaluates the equations.
  /// \param x         all unknowns
  /// \param residual  Phi, as long as x
  void evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residual);
  /// Evaluates their derivatives, where evaluate() was called last.
  /// \param x  all unknowns
  /// \param J  d Phi / d x
  void differentiate(const Eigen::VectorXd& x, Eigen::MatrixXd& J) const;
  /// \return gaps and slips `2 n_c` where evaluate() was called last
  [[nodiscard]] const Eigen::VectorXd& movement() const { return movement_; }
  /// \return what one unit of scaled force counts in x
  [[nodiscard]] double reach() const { return reach_; }
  /// \param x  all unknowns
  /// \param i  a pair
  /// \return the bound b of its friction force
  [[nodiscard]] double bound(const Eigen::VectorXd& x, Eigen::Index i) const;
  /// \param x  all unknowns
  /// \param i  a pair
  /// \return d b / d lambda
  [[nodiscard]] double bound_slope(const Eigen::VectorXd& x, Eigen::Index i) const;
  /// \return n_c
  [[nodiscard]] Eigen::Index pairs() const { return problem_.coefficient.size(); }
  /// \return the number of rigid amplitudes
  [[nodiscard]] Eigen::Index modes() const { return problem_.resultant.size(); }

 private:
  const ScaledFriction& problem_;
  const FrictionFormulation& law_;
  double reach_;
  Eigen::MatrixXd compliance_;  ///< F / reach
  Eigen::VectorXd movement_;
  Eigen::VectorXd cohesion_;  ///< of the pairs taken as closed
};

/// Where a method stands: the numbers, what they say of each pair, and the report so far.
struct FrictionPoint {
  FrictionClosure closure;      ///< the end if it is `confirmed`, else the last iterate
  std::vector<Motion> motions;  ///< `n_c`
  Report report;                ///< its status is set at the end
  std::string reason;           ///< why the method stopped, if it did
};

/// What a unit of force counts against gaps and slips: the largest row sum of |F|, what such forces on
/// all pairs open a gap by.
/// \param problem  scaled
/// \return the sum > 0 [-]
[[nodiscard]] double friction_reach(const ScaledFriction& problem);

/// The entry of a history, in the units of the problem as it was posed.
/// \param problem   scaled
/// \param point     numbers and motions
/// \param changes   pairs that change
/// \param residual  relative
/// \return closed pairs, changes, the largest overlap of an open one and tension of a closed one, residual
[[nodiscard]] Iteration friction_iteration(const ScaledFriction& problem,
                                           const FrictionPoint& point, Eigen::Index changes,
                                           double residual);

/// Takes Newton steps, each as far as \f$ \tfrac12|\Phi|^2 \f$ falls (Armijo's rule), and ends exactly:
/// whenever an iterate says something new of what the pairs do, close_friction() solves the equations of
/// these motions, and of those which that solution asks for, and looks whether all signs are right.
/// \param problem    scaled
/// \param law        of the formulation
/// \param limit      on the iterations in `point.report`
/// \param[in,out] point  where to start, and where it ended
void descend(const ScaledFriction& problem, const FrictionFormulation& law, Eigen::Index limit,
             FrictionPoint& point);

/// The point from which all methods start: forces without friction, or for bodies with rigid modes the
/// smallest forces that balance r; and what these say of the pairs.
/// \param problem  scaled
/// \return the point
[[nodiscard]] FrictionPoint friction_start(const ScaledFriction& problem);

}  // namespace signorini
