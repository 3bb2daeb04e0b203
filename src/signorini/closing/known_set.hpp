/// \file
/// What all pairs do, and the one linear system that follows from it.
#pragma once
#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// What a pair does, with the direction in which it slides: \PaperEq{LinEtAl, 13}, \PaperEq{LinEtAl, 14}
enum class Motion : signed char {
  Open,     ///< no force at all
  Stick,    ///< no gap and, if the pair rubs, no slip
  Forward,  ///< slip > 0, tau = -b
  Backward  ///< slip < 0, tau = b
};

/// \param motion  of a pair
/// \return the sign of tau at its bound, 0 where the pair does not slide
[[nodiscard]] inline double friction_sign(Motion motion) {
  return motion == Motion::Forward ? -1 : motion == Motion::Backward ? 1 : 0;
}

/// A friction force at its bound, tau = slope lambda + offset.
struct SlidingPair {
  Eigen::Index gap;   ///< row of its gap
  Eigen::Index slip;  ///< row of its slip
  double slope;       ///< -mu, 0 or mu [-]
  double offset;      ///< -c, 0 or c [force]
};

/// What follows for the rows of gaps and slips: which of them do not move, and which friction forces are at
/// their bounds. All other forces vanish.
struct KnownSet {
  std::vector<Eigen::Index> closed;  ///< rows that do not move, in increasing order
  std::vector<SlidingPair> sliding;  ///< in increasing order
};

/// The set that the motions of all pairs make.
/// \param motions  `n_c`
/// \param law      of the pairs that rub; one whose mu and c vanish slides without a force
/// \return rows `n_c` of gaps, then `n_s` of slips
[[nodiscard]] KnownSet known_set(const std::vector<Motion>& motions, const FrictionLaw& law);

/// The system of a known set, factored once:
///
/// \f[ \begin{pmatrix} F_{WW} + F_{WS}\,\mathrm{slope} & R_W \\ (R_W + R_S\,\mathrm{slope})^T & 0 \end{pmatrix}
///     \begin{pmatrix} f_W \\ a \end{pmatrix} = \dots \f]
///
/// for closed rows W and the slips S of sliding pairs, whose friction forces follow the normal ones. On
/// equilibrated data. Where rows of W repeat each other, as many as are independent are kept, and close
/// the others as well; sliding pairs that make the system singular leave its least-norm solution. Copies
/// share the numbers.
class Closing {
 public:
  /// \param compliance  F of all rows, symmetric [length/force]
  /// \param rigid       R of all rows [length/amplitude]; no columns if bodies are held
  /// \param set         W and S
  Closing(const Eigen::MatrixXd& compliance, const Eigen::MatrixXd& rigid, const KnownSet& set);

  /// \return independent rows of W, all of W if it has no others
  [[nodiscard]] const std::vector<Eigen::Index>& rows() const;
  /// Changes that end a movement of W and an imbalance.
  /// \param movement   of all rows [length]
  /// \param resultant  that R^T f lacks `n_r` [force*length/amplitude]
  /// \return changes of the forces of rows(), and of the amplitudes
  [[nodiscard]] std::pair<Eigen::VectorXd, Eigen::VectorXd> solve(
      const Eigen::VectorXd& movement, const Eigen::VectorXd& resultant) const;

 private:
  struct System;
  std::shared_ptr<const System> system_;
};

}  // namespace signorini
