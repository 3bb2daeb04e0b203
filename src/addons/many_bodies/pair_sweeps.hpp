// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Sweeps over pairs with friction, each of which is solved exactly.
#pragma once
#include <Eigen/SparseCore>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// What a pair alone does: gap = a + F_nn lambda + F_nt tau, slip = b + F_tn lambda + F_tt tau, with Coulomb's law.
struct LonePair {
  double gap = 0;          ///< a, the gap without a force of this pair [length]
  double slip = 0;         ///< b, the slip without [length]
  double nn = 1;           ///< F_nn > 0 [length/force]
  double nt = 0;           ///< F_nt [length/force]
  double tn = 0;           ///< F_tn [length/force]
  double tt = 1;           ///< F_tt > 0 [length/force]
  double coefficient = 0;  ///< mu [-]
  double cohesion = 0;     ///< c [force]
};

/// \param pair  alone
/// \return lambda and tau: open, sticking or sliding, whichever fits; of several solutions the first one in this order, and
///   where none fits, as may be where F_nt mu exceeds F_nn, what sticks without pulling and is cut off at the bound
[[nodiscard]] Eigen::Vector2d lone_pair_force(const LonePair& pair);

/// Non-smooth Gauss-Seidel: sweep after sweep, each pair in turn gets the forces that solve it while all others stay
/// [\ref Jean1999]. A sweep costs as much as F has entries, and redundant forces do no harm; but a long chain of pairs needs
/// many, as one hands on to the next.
/// \param compliance  F `n_c + n_s`, gaps first, with a positive diagonal
/// \param free        d, then s
/// \param law         of the frictional pairs
/// \param sweeps      how many
/// \param[in,out] force  of all rows
void sweep_pairs(const Eigen::SparseMatrix<double>& compliance, const Eigen::VectorXd& free,
                 const FrictionLaw& law, Eigen::Index sweeps, Eigen::VectorXd& force);

}  // namespace signorini
