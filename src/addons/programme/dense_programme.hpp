/// \file
/// Dense quadratic programmes: condensation, and the whole way to a certified solution.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/problem.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// What is wrong with a K that is only semidefinite where the equations hold, or less.
struct NotDefinite : ProblemError {
  using ProblemError::ProblemError;
};

/// A dense programme with the displacements, and the forces of the equations, eliminated.
struct DenseCondensed {
  CholeskyFactor factor;              ///< of K `n x n`; with equations of K + rho A_e^T A_e
  Eigen::MatrixXd half;               ///< H = L^-1 A^T `n x n_c`, rows of inequalities only; with
                                      ///< equations, H is orthogonal to theirs
  ContactProblem problem;             ///< G = H^T H and d = g - A u0
  Eigen::VectorXd free_displacement;  ///< u0 `n`: K^-1 p, or the minimiser with equations alone
};

/// Eliminates the displacements. \PaperEq{XuanLi2002, 20}, \PaperEq{XuanLi2002, 22}
/// \param programme  K, p, A, g
/// \return factor, small problem and u0
/// \throws std::invalid_argument if sizes do not fit or a number is not finite
/// \throws NotDefinite if K is not positive definite to rounding where the equations hold
/// \throws ProblemError if the equations contradict each other
[[nodiscard]] DenseCondensed condense(const DenseProgramme& programme);

/// A solution of a dense programme. Unless `report.status` is Solved, u and lambda are the last ones;
/// the forces of the equations then balance the load as well as they can.
struct DenseSolution {
  PrimalDual refined;                       ///< u in two parts, and lambda `m`
  Eigen::VectorXd gap;                      ///< g - A u `m`, 0 in closed rows
  std::vector<Eigen::Index> active;         ///< closed rows of inequalities, in increasing order
  Eigen::VectorXd farkas_certificate;       ///< as for proves_infeasible(), `m` or empty
  Report report;                            ///< how the solver got there
  Certificate certificate = uncertified();  ///< of `refined`, from the original K, p, A, g
};

/// Condenses, solves, recovers u, refines from the original data, and certifies.
///
/// If the refined solution shows that rounding had misplaced a row, the condensed problem is solved
/// again with free gaps from the refined solution. If the certificate refutes it, each system that nothing
/// but rounding connects is solved by itself, see unconnected_systems(). Where K is only semidefinite, see proximal_solution():
/// then the solution is one of several, or the only one.
/// \param programme  K, p, A, g
/// \param solver     a member of solvers()
/// \param options    handed to it
/// \return the solution; look at its `report.status` first. A solution that the certificate does not
///   confirm to 1e-12 is called `Breakdown`
/// \throws std::invalid_argument, ProblemError as condense() and the solver; NotDefinite as proximal_solution()
[[nodiscard]] DenseSolution solve(const DenseProgramme& programme, const Solver& solver,
                                  const SolverOptions& options = {});

/// proves_infeasible() of proofs.hpp for a dense programme with its equations. \param programme  A, g
/// \param y  `m` \param u  `n` \return whether y proves it
/// \throws std::invalid_argument if u has another size
[[nodiscard]] bool proves_infeasible(const DenseProgramme& programme, const Eigen::VectorXd& y,
                                     const Eigen::VectorXd& u);

/// Certificate of (u, lambda) against K, p, A, g, as for a QuadraticProgramme. Of an equation both
/// signs of the gap count as penetration, and no force as tension.
/// \param programme  K, p, A, g as they were posed
/// \param solution   u and lambda, from any solver
/// \return the figures; all infinite if any number, given or claimed, is not finite
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] Certificate certify(const DenseProgramme& programme, const PrimalDual& solution);

/// The same programme with sparse matrices, for those who need that form; equations lose their mark.
/// \param programme  K, p, A, g
/// \return K, p, A, g
[[nodiscard]] QuadraticProgramme sparse(const DenseProgramme& programme);

/// \param half  H `n x n_c`
/// \return G = H^T H `n_c x n_c`, exactly symmetric
[[nodiscard]] Eigen::MatrixXd gram(const Eigen::MatrixXd& half);

}  // namespace signorini
