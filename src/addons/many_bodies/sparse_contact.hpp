// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Contact of many bodies by the entries that are there: a cost that grows with the pairs and not with their cube.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// Contact with few entries, of displacements or of amplitudes of rigid motions:
/// \f[ H x + B^T f = p,\qquad w = g - B x + F f, \f]
/// gaps first in f and w, then slips. A programme is K, A and no F; a condensed problem is no H, B = -R, p = -r and F.
struct SparseContact {
  Eigen::SparseMatrix<double> stiffness;               ///< H `n x n`, symmetric, semidefinite
  Eigen::VectorXd load;                                ///< p `n` [force]
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows;   ///< B `m x n`
  Eigen::SparseMatrix<double> compliance;              ///< F `m x m`
  Eigen::VectorXd free;                                ///< g `m` [length]
  FrictionLaw law;                                     ///< of the frictional pairs
  Eigen::VectorXd scale;  ///< `m` > 0: force / scale and movement * scale are in one unit
};

/// Where every pair does what it was taken to do.
struct SparseContactSolution {
  Eigen::VectorXd position;             ///< x `n`, rounded to double
  Eigen::VectorXd position_low;         ///< what rounding took away from x `n`
  Eigen::VectorXd force;                ///< f `m` [force]
  Eigen::VectorXd movement;             ///< w `m` [length], 0 of closed rows
  std::vector<ContactStatus> statuses;  ///< of the pairs
  Eigen::Index sets = 0;                ///< how many were looked at, each with one factor
  Eigen::Index steps = 0;               ///< along the central path, each with one factor
  Eigen::Index sweeps = 0;              ///< over the pairs, before and between
};

/// Newton's method for the projections of contact, as primal_dual_active_set(), on the whole system with a sparse factor.
///
/// The first set is what soft pairs do: all are closed, and each gives way by as much as it is scaled by. Where there is no x, as
/// of rigid bodies, it is where a CentralPath ends; if that leads nowhere, what sweep_pairs() lead to, and where the sets run
/// in circles, what more sweeps do. Sweeps that have ended by themselves are a claim as well.
///
/// Every set is solved with a factor of a matrix that is regular by \f$ \epsilon^{3/4} \f$ on its diagonal, and refined from the
/// entries themselves in twice the working precision, so that nothing of that is left; where something is, the bodies are not
/// held by the pairs that are closed, or these depend on each other, and there is no answer. Without x redundant forces may
/// remain, the diagonal gets \f$ \sqrt\epsilon \f$, and a set is solved where its rows have moved by rounding only.
/// \param problem  sizes fit
/// \param start    `n_c` statuses to begin with, or empty
/// \return a claim, which a certificate has to confirm; nothing if the sets run in circles, or one has no regular system
[[nodiscard]] std::optional<SparseContactSolution> solve_sparse_contact(
    const SparseContact& problem, const std::vector<ContactStatus>& start);

}  // namespace signorini
