/// \file
/// Dense quadratic programmes: condensation, and the whole way to a certified solution.
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "signorini/complementarity/certificate.hpp"
#include "signorini/complementarity/problem.hpp"
#include "signorini/complementarity/solvers.hpp"

namespace signorini {

/// A dense programme with the displacements eliminated.
struct DenseCondensed {
  Eigen::LLT<Eigen::MatrixXd> factor;  ///< of K `n x n`
  HalfProblem problem;                 ///< H = L^-1 A^T and d = g - A u0, rows of inequalities only
  Eigen::VectorXd free_displacement;   ///< u0 = K^-1 p `n`
};

/// Eliminates the displacements. \PaperEq{XuanLi2002, 20}, \PaperEq{XuanLi2002, 22}
/// \param programme  K, p, A, g
/// \return factor, small problem and u0
/// \throws std::invalid_argument if sizes do not fit or a number is not finite
/// \throws ProblemError if K is not positive definite to rounding
[[nodiscard]] DenseCondensed condense(const DenseProgramme& programme);

/// A solution of a dense programme. Unless `report.status` is Solved, u and lambda are the last ones.
struct DenseSolution {
  PrimalDual refined;                       ///< u in two parts, and lambda `m`
  Eigen::VectorXd gap;                      ///< g - A u `m`, 0 in closed rows
  std::vector<Eigen::Index> active;         ///< closed rows of inequalities, in increasing order
  Eigen::VectorXd infeasibility;            ///< as in ContactState, `m` or empty
  Report report;                            ///< how the solver got there
  Certificate certificate = uncertified();  ///< of `refined`, from the original K, p, A, g
};

/// Condenses, solves, recovers u, refines from the original data, and certifies.
/// \param programme  K, p, A, g
/// \param solver     a member of solvers()
/// \param options    handed to it
/// \return the solution; look at its `report.status` first
/// \throws as condense() and the solver
[[nodiscard]] DenseSolution solve(const DenseProgramme& programme, const Solver& solver,
                                  const SolverOptions& options = {});

/// The same programme with sparse matrices, for those who need that form.
/// \param programme  without equations
/// \return K, p, A, g
/// \throws std::invalid_argument if it has equations
[[nodiscard]] QuadraticProgramme sparse(const DenseProgramme& programme);

}  // namespace signorini
