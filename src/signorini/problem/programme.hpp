/// \file
/// Contact with displacements: quadratic programmes, sparse and dense.
///
/// One body of one unknown, stiffness 2, pulled by 6 towards a stop that is 1 away, is K = 2, p = 6, A = 1, g = 1: without the
/// stop it would go to 3, and the stop holds it at 1 with the force 6 - 2 = 4.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// What had happened until a place that the unknowns of a programme count from, where that is not rest: how large the numbers
/// are whose small remainder the programme is about. Certificates measure by it.
struct Reached {
  Eigen::VectorXd displacement;  ///< `n` how far the unknowns had moved [length]; empty: they count from rest
  Eigen::VectorXd terms;  ///< `n` magnitudes of internal forces there, which p has less, summed [force]
};

/// Least potential energy without penetration, \PaperEq{XuanLi2002, 9} and \PaperEq{XuanLi2002, 10}
/// on a mesh: \PaperEq{XuanLi2002, 11}, \PaperEq{XuanLi2002, 12}
///
/// \f[ \min_u \tfrac12 u^T K u - p^T u \quad\text{subject to}\quad A u \le g. \f]
struct QuadraticProgramme {
  Eigen::SparseMatrix<double> stiffness;           ///< K `n x n`, both triangles [force/length]
  Eigen::VectorXd load;                            ///< p `n` [force]
  Eigen::SparseMatrix<double, Eigen::RowMajor> A;  ///< `n_c x n`: gap = initial_gap - A u [-]
  Eigen::VectorXd initial_gap;                     ///< g `n_c` [length], overlap < 0
  Reached reached = {};                            ///< where u counts from
};

struct ScaledProblem;

/// What the matrices of a programme say, whatever its load and gaps are: where many loads follow, it is found once.
struct KnownMatrices {
  Eigen::VectorXd diagonal;  ///< `n` of K [force/length]; empty: it is not kept
  bool connected = false;  ///< all hangs together, even if entries of K that are rounding connect nothing
  /// The condensed problem, equilibrated for the load before; empty before the first one, null where it is not kept
  std::shared_ptr<ScaledProblem> scaled = {};
};

/// A quadratic programme with dense matrices, as in mathematical programming: the same least energy,
/// where the first rows may be equations.
///
/// \f[ \min_u \tfrac12 u^T K u - p^T u \quad\text{subject to}\quad A_e u = g_e,\ A_i u \le g_i. \f]
struct DenseProgramme {
  Eigen::MatrixXd stiffness;    ///< K `n x n`, symmetric; positive definite where A_e u = 0
  Eigen::VectorXd load;         ///< p `n`
  Eigen::MatrixXd A;            ///< `m x n`: gap = initial_gap - A u
  Eigen::VectorXd initial_gap;  ///< g `m`
  Eigen::Index equations = 0;   ///< so many rows at the top hold with =, their forces have any sign
};

}  // namespace signorini
