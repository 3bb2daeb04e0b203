// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The central path of contact with friction: where nothing is at a bound, and what is left of each product falls.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "addons/many_bodies/diagonal_lu.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Forces f for which every pair has the same product m of what it has left and what it gives way by:
/// \f[ \lambda g = m,\qquad (\mu\lambda + c + \tau)\,s^+ = m,\qquad (\mu\lambda + c - \tau)\,s^- = m,\qquad
///     g = d + (Ff)_n,\quad s^+ - s^- = s + (Ff)_t , \f]
/// all factors positive. At m = 0 this is Coulomb's law. Redundant forces do no harm: the path keeps to the middle of them.
///
/// The path begins at equal normal forces. What the two equations of the second line then lack falls with m. Friction
/// makes it turn: m may rise before it falls again. So it is followed by its length and not by m, and the sign of the determinant
/// of its equations tells the way [\ref AllgowerGeorg1990].
class CentralPath {
 public:
  /// \param compliance  F `n_c + n_s`, gaps first, with a positive diagonal
  /// \param free        d, then s; not all 0
  /// \param law         of the frictional pairs, of which each has a coefficient or cohesion
  /// \param wide        gaps at the beginning over the largest free movement [-]: each has a path of its own, short or long
  CentralPath(const Eigen::SparseMatrix<double>& compliance, const Eigen::VectorXd& free,
              FrictionLaw law, double wide);

  /// Goes on along the path.
  /// \param part  of the m at the beginning that is small enough [-]
  /// \param most  steps from the beginning, each with one factor
  /// \return whether m is that small; otherwise nothing leads on, or the steps are used up
  [[nodiscard]] bool follow(double part, Eigen::Index most);
  /// \return f of all rows
  [[nodiscard]] Eigen::VectorXd force() const { return scale_.cwiseProduct(force_); }
  /// \return m where it has come to, of forces that are scaled so that the diagonal of F is 1
  [[nodiscard]] double level() const { return level_; }
  /// \return steps so far
  [[nodiscard]] Eigen::Index steps() const { return steps_; }

 private:
  /// A change of forces, and of both factors of each product.
  struct Change {
    Eigen::VectorXd force, room, give;
  };
  /// One step along the path, or back to it. \return whether there is one
  bool advance();
  /// Takes a step that stays near the path.
  /// \param back   to the path, with the change of m `level_back`
  /// \param along  the path, for a change of m by 1
  /// \param unit   change of m for which the largest relative change along the path, of m too, is 1; > 0
  /// \param sign   -1: m falls along the path, 1: it rises
  /// \return whether there is such a step
  bool step(const Change& back, double level_back, const Change& along, double unit, double sign);
  bool factorise();
  /// What changes products by as much, and F f less the movements of pairs by `moves`.
  [[nodiscard]] Change change(const Eigen::VectorXd& products, const Eigen::VectorXd& moves) const;
  /// \return a times the one and b times the other
  [[nodiscard]] static Change sum(double a, const Change& one, double b, const Change& other);
  /// All changes over what changes.
  [[nodiscard]] Eigen::VectorXd relative(const Change& change) const;
  /// What is left to the bounds of the law: forces, then forward, then backward. \param cohesion  whether it counts
  [[nodiscard]] Eigen::VectorXd rooms(const Eigen::VectorXd& force, bool cohesion) const;
  /// Gaps and slips of what pairs give way by.
  [[nodiscard]] Eigen::VectorXd movements(const Eigen::VectorXd& give) const;

  Eigen::VectorXd scale_;  ///< of forces, so that the diagonal of F is 1
  Eigen::SparseMatrix<double> F_;
  Eigen::VectorXd free_;
  FrictionLaw law_;
  Eigen::VectorXd force_, room_, give_;
  Eigen::VectorXd lack_;        ///< of the equations of movements, over m
  double level_, first_level_;  ///< m, now and at the beginning
  double reach_;                ///< how far a step may go
  int first_sign_ = 0;          ///< of the determinant
  Eigen::Index steps_ = 0;
  DiagonalLu factor_;  ///< what pairs give way by is added to the diagonal of F
};

}  // namespace signorini
