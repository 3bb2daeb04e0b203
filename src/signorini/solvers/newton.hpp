/// \file
/// What the methods for all kinds of contact share: where they start, Newton's steps, and the exact end.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/closing/closing.hpp"

namespace signorini {

/// Where a method stands: the numbers, what they say of each pair, and the report so far.
struct Attempt {
  Closure closure;              ///< the end if `confirmed`, else the last iterate
  std::vector<Motion> motions;  ///< `n_c`
  Report report;                ///< its status is set at the end
  std::string reason = {};      ///< why the method stopped, if it did
  bool confirmed = false;       ///< whether the closure is a solution
};

/// The point from which all methods start, and what it says of the pairs: no forces; with friction forces
/// without friction; for bodies with rigid modes the least forces that balance r, and the amplitudes of least gaps.
/// \param problem  scaled
/// \return the point
[[nodiscard]] Attempt first_attempt(const ScaledProblem& problem);

/// The state where a method ended.
/// \param problem  as it was posed
/// \param scaled   the same, equilibrated
/// \param attempt  the end
/// \return the state, `Solved` if the end was confirmed; with friction with its uniqueness()
[[nodiscard]] ContactState finished(const ContactProblem& problem, const ScaledProblem& scaled,
                                    Attempt attempt);

class ContactEquations;

/// How the law of friction is written: the tangential equations, and those of the unknowns that it adds to forces
/// and amplitudes.
struct Formulation {
  Eigen::Index added;  ///< unknowns and equations per slip, behind those of ContactEquations
  /// Sets the added unknowns where the others are given; null if there are none.
  void (*start)(const ContactEquations& equations, Eigen::VectorXd& x);
  /// Evaluates the tangential equations and the added ones, at equations.movement().
  void (*evaluate)(const ContactEquations& equations, const Eigen::VectorXd& x,
                   Eigen::VectorXd& residual);
  /// Evaluates their derivatives. The row of a slip in J still holds d slip / d x.
  void (*differentiate)(const ContactEquations& equations, const Eigen::VectorXd& x,
                        Eigen::MatrixXd& J);
};

/// Contact as equations Phi(x) = 0.
///
/// The unknowns x are the forces of all rows, amplitudes `k`, and what a law adds. The first equations belong to
/// gaps and slips, then come U^T f = t and those of the law. A force counts as the gap that such forces on all
/// pairs make: without that factor the steps grow with the number of pairs, for a beam of 200 pairs from 15 to
/// 55.
///
/// With rigid modes, two things are left to find: how forces in balance differ from the least of them, and
/// the amplitudes. With \f$ P = I - U U^T \f$ the movements that they make are \f$ P F P f + U b \f$: neither
/// how far away a body was put nor the springs that ground it in F are left in the equations.
class ContactEquations {
 public:
  /// \param problem  scaled; must outlive this
  /// \param law      must outlive this
  ContactEquations(const ScaledProblem& problem, const Formulation& law);

  /// \return the number of unknowns
  [[nodiscard]] Eigen::Index size() const { return rows() + modes() + law_.added * slips(); }
  /// \return n_c + n_s
  [[nodiscard]] Eigen::Index rows() const { return problem_.free.size(); }
  /// \return n_c
  [[nodiscard]] Eigen::Index pairs() const { return problem_.pairs(); }
  /// \return n_s
  [[nodiscard]] Eigen::Index slips() const { return rows() - pairs(); }
  /// \return the number of rigid amplitudes
  [[nodiscard]] Eigen::Index modes() const { return problem_.rigid.cols(); }
  /// \param k  a slip
  /// \return the pair that it belongs to
  [[nodiscard]] Eigen::Index pair(Eigen::Index k) const {
    return problem_.law.pair[static_cast<std::size_t>(k)];
  }
  /// \param attempt  forces and amplitudes
  /// \return all unknowns, those that the law adds included
  [[nodiscard]] Eigen::VectorXd unknowns(const Attempt& attempt);
  /// \param x        all unknowns
  /// \param closure  gets the forces, movements and amplitudes that they stand for
  void read(const Eigen::VectorXd& x, Closure& closure) const;
  /// Decides which pairs carry cohesion: those whose force exceeds their gap. \param x  all unknowns
  void choose_closed(const Eigen::VectorXd& x);
  /// Evaluates the equations. \PaperEq{LinEtAl, 28}, \PaperEq{LinEtAl, 30}
  /// \param x         all unknowns
  /// \param residual  Phi, as long as x
  void evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residual);
  /// Evaluates their derivatives, where evaluate() was called last.
  /// \param x  all unknowns
  /// \param J  d Phi / d x
  void differentiate(const Eigen::VectorXd& x, Eigen::MatrixXd& J) const;
  /// \return gaps and slips where evaluate() was called last
  [[nodiscard]] const Eigen::VectorXd& movement() const { return movement_; }
  /// \return what one unit of scaled force counts in x
  [[nodiscard]] double reach() const { return reach_; }
  /// \param x  all unknowns
  /// \param k  a slip
  /// \return the bound b of its friction force
  [[nodiscard]] double bound(const Eigen::VectorXd& x, Eigen::Index k) const;
  /// \param x  all unknowns
  /// \param k  a slip
  /// \return d b / d lambda
  [[nodiscard]] double bound_slope(const Eigen::VectorXd& x, Eigen::Index k) const;

 private:
  void move(const Eigen::VectorXd& x);

  const ScaledProblem& problem_;
  const Formulation& law_;
  Eigen::MatrixXd compliance_;  ///< F, or P F P, over reach
  Eigen::VectorXd free_;
  double reach_;
  Eigen::VectorXd movement_;
  Eigen::VectorXd cohesion_;  ///< of the slips whose pairs are taken as closed
};

/// Friction as one equation per slip: the friction force lies between -b and b, at -b while the pair slides
/// forwards and at b while it slides backwards. With fischer_burmeister(), applied twice [\ref Billups1995],
///
/// \f[ \varphi(\tau + b, \varphi(b - \tau, -slip)) = 0,\qquad b = \mu\max(\lambda, 0) + c, \f]
///
/// with c of pairs only whose force exceeds their gap. Where b = 0 the equation just says tau = 0.
extern const Formulation nested_friction;

/// Takes Newton steps, each as far as \f$ \tfrac12|\Phi|^2 \f$ falls (Armijo's rule). If J is singular to working
/// precision, so that its step does not point downhill, the step follows the gradient \f$ J^T\Phi \f$, which
/// exists even where \f$ \Phi \f$ has kinks [\ref DeLucaFacchineiKanzow1996].
///
/// Newton's method ends near a solution, not on it: as soon as two iterates agree on what the pairs do,
/// close() solves the equations of these motions, and of those which that solution asks for, and the result is
/// kept if it is a solution.
/// \param problem  scaled
/// \param law      of friction
/// \param limit    on the iterations in `attempt.report`
/// \param[in,out] attempt  where to start, and where it ended
void follow_newton(const ScaledProblem& problem, const Formulation& law, Eigen::Index limit,
                   Attempt& attempt);

/// Newton steps with friction if the caller sets no limit.
inline constexpr Eigen::Index newton_limit = 25;

/// Exchanges the motions of all wrong pairs at once: takes what each pair does as known, open, sticking, or
/// sliding one way or the other, and solves the linear equations of these motions exactly. From the result, a
/// pair opens if its force is tensile, closes if it overlaps, starts to slide if its friction force exceeds the
/// bound, and stops if it slides along with its friction force; and again.
///
/// If a set comes back, only the first wrong pair changes from then on where bodies are held and nothing rubs
/// [\ref Murty1974]; else the method stops. Of pairs that depend on each other, those that overlapped most
/// stay closed.
/// \param problem  scaled
/// \param limit    on the exchanges
/// \param[in,out] attempt  where to start, and where it ended
void exchange_motions(const ScaledProblem& problem, Eigen::Index limit, Attempt& attempt);

/// Exchanges with friction if the caller sets no limit.
inline constexpr Eigen::Index exchange_limit = 50;

/// Follows Lemke's path through all kinds of contact, see lemke().
/// \param problem  scaled
/// \param options  of each path
/// \param[in,out] attempt  its report is continued
void follow_pivots(const ScaledProblem& problem, const SolverOptions& options, Attempt& attempt);

}  // namespace signorini
