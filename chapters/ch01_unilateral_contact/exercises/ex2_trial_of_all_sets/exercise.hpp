/// \file
/// Exercise 1.2 - contact by trial of all sets. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex1_2 {

/// Most pairs that solve_by_trial() accepts: 256 sets.
inline constexpr Eigen::Index largest = 8;

/// Where the body comes to rest, and what holds it there.
struct Rest {
  Eigen::VectorXd displacement;   ///< u `n` [length]
  Eigen::VectorXd contact_force;  ///< lambda `n_c` [force], compression > 0; 0 for open pairs
};

/// Least potential energy without penetration, \PaperEq{XuanLi2002, 11}, by trying every set of
/// closed pairs.
///
/// Four conditions make a solution: equilibrium K u + A^T lambda = p, no overlap g - A u >= 0, no
/// tension lambda >= 0, and lambda = 0 wherever the gap is open. For a set W of closed pairs
/// equilibrium and A_W u = g_W determine u and lambda; the set is right if the rest holds as well,
/// up to rounding. Neither units nor the scale of a row of A and its gap decide what is closed: u stays, and
/// the force of a row times r is 1/r of what it was. If rows of A depend on each other, lambda need not be
/// unique and any solution will do; u is always unique.
/// \param stiffness   K `n x n`, symmetric positive definite [force/length]
/// \param load        p `n` [force]
/// \param A           `n_c x n`: gap = initial_gap - A u [-]; rows may repeat, scale or vanish
/// \param initial_gap g `n_c` [length]
/// \throws std::invalid_argument if there are more than 8 pairs
/// \throws signorini::ProblemError if no displacement keeps all gaps open or closed
[[nodiscard]] Rest solve_by_trial(const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& load,
                                  const Eigen::MatrixXd& A, const Eigen::VectorXd& initial_gap);

}  // namespace ex1_2
