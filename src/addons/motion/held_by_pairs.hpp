// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What makes a tangent positive definite that is not, and leaves the answer as it is.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// The rows that hold: gaps of closed pairs, and slips of those of them that stick.
/// \param statuses  `n_c` what the pairs do
/// \param law       of the frictional pairs
/// \return rows of A, increasing
[[nodiscard]] std::vector<Eigen::Index> held_rows(const std::vector<ContactStatus>& statuses,
                                                  const FrictionLaw& law);

/// Makes \f$ \rho A_c^T A_c \f$, which belongs to K, and adds \f$ \rho A_c^T g_c \f$ to p. Where rows c hold, \f$ A_c u = g_c \f$, neither u nor the
/// forces change by it. Where one of them is about to open it resists a little, as a spring that is at rest where it holds.
/// \param rows       c, that should hold
/// \param stiffness  rho >= 0 [force/length]
/// \param[in,out] programme  with p, A, g
/// \return `n x n` to add to K [force/length]
[[nodiscard]] Eigen::SparseMatrix<double> hold_by_pairs(const std::vector<Eigen::Index>& rows,
                                                        double stiffness,
                                                        QuadraticProgramme& programme);

}  // namespace signorini
