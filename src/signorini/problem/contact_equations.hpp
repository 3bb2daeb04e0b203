// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Contact as a system of nonlinear equations, whose part for friction can be written in several ways.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/active_set_system.hpp"

namespace signorini {

class ContactEquations;

/// Which numbers the equations are about.
enum class Reading {
  /// Movements of forces in balance, forces in units of what they move; only closed pairs carry cohesion, and
  /// only pressed ones mu lambda
  Mended,
  AsPrinted  ///< forces and movements as they are; every pair has the bound c + mu lambda
};

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
  Reading reading = Reading::Mended;  ///< of all equations
};

/// Contact as equations Phi(x) = 0.
///
/// The unknowns x are the forces of all rows, amplitudes `k`, and what a formulation adds. The first equations
/// belong to gaps and slips, then come U^T f = t and the added ones. A force counts as the gap that such forces on
/// all pairs make: without that factor the steps grow with the number of pairs, for a beam of 200 pairs from 15
/// to 55.
///
/// With rigid modes, two things are left to find: how forces in balance differ from the least of them, and
/// the amplitudes. With \f$ P = I - U U^T \f$ the movements that they make are \f$ P F P f + U b \f$: neither
/// how far away a body was put nor the springs that ground it in F are left in the equations.
class ContactEquations {
 public:
  /// \param problem  scaled; must outlive this
  /// \param form     must outlive this
  ContactEquations(const ScaledProblem& problem, const Formulation& form);

  /// \return the number of unknowns
  [[nodiscard]] Eigen::Index size() const { return rows() + modes() + form_.added * slips(); }
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
  /// Decides which pairs carry cohesion, as choose_closed(), and sets what the formulation adds.
  /// \param solution  forces and amplitudes
  /// \return all unknowns
  [[nodiscard]] Eigen::VectorXd unknowns(const ActiveSetSolution& solution);
  /// \param x        all unknowns
  /// \param solution  gets the forces, movements and amplitudes that they stand for
  void read(const Eigen::VectorXd& x, ActiveSetSolution& solution) const;
  /// Decides which pairs carry cohesion: those whose force exceeds their gap, or as printed all. \param x  all unknowns
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
  [[nodiscard]] double force_scale() const { return force_scale_; }
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
  const Formulation& form_;
  const bool in_balance_;       ///< whether movements are those of forces in balance
  Eigen::MatrixXd compliance_;  ///< F, or P F P, over force_scale
  Eigen::VectorXd free_;
  double force_scale_;
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

}  // namespace signorini
