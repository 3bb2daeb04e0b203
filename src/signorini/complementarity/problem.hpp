/// \file
/// The frictionless contact problem as pure algebra, in its two forms, and what a solver returns.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <string>
#include <vector>

namespace signorini {

/// Least potential energy without penetration. \PaperEq{XuanLi2002, 11}, \PaperEq{XuanLi2002, 12}
///
/// \f[ \min_u \tfrac12 u^T K u - p^T u \quad\text{subject to}\quad A u \le g. \f]
struct QuadraticProgramme {
  Eigen::SparseMatrix<double> stiffness;           ///< K `n x n`, both triangles [force/length]
  Eigen::VectorXd load;                            ///< p `n` [force]
  Eigen::SparseMatrix<double, Eigen::RowMajor> A;  ///< `n_c x n`: gap = initial_gap - A u [-]
  Eigen::VectorXd initial_gap;                     ///< g `n_c` [length], overlap < 0
};

/// The same problem with the displacements eliminated: find forces >= 0 with
/// gap = free_gap + compliance * force >= 0 and force * gap = 0 pair by pair.
///
/// \PaperEq{XuanLi2002, 6} after condensation: \f$ d = g - A u^0,\ G = A K^{-1} A^T \f$.
struct ContactProblem {
  Eigen::MatrixXd compliance;  ///< G `n_c x n_c`, symmetric positive semidefinite [length/force]
  Eigen::VectorXd free_gap;    ///< d `n_c` [length]: the gap when contact is ignored, overlap < 0
};

/// How a solver ended. Nothing but `Solved` may be called a solution.
enum class Status {
  Solved,          ///< all conditions hold to rounding
  Infeasible,      ///< no forces satisfy the conditions
  Ray,             ///< the method ran off along a ray; a solution may or may not exist
  IterationLimit,  ///< stopped by the limit on iterations
  Breakdown        ///< a system the method needs is singular to working precision
};

/// A status in words.
/// \param status  any
/// \return "solved", "infeasible", "ray", "iteration limit" or "breakdown"
[[nodiscard]] const char* to_string(Status status);

/// One iteration of a solver.
struct Iteration {
  Eigen::Index active;   ///< pairs taken as closed
  Eigen::Index changes;  ///< pairs found on the wrong side, which are candidates for a change
  double penetration;    ///< largest overlap of a pair taken as open [length]
  double tension;        ///< largest tensile force of a pair taken as closed [force]
};

/// What a solver says about its run.
struct Report {
  Status status = Status::Breakdown;  ///< how it ended
  Eigen::Index iterations = 0;        ///< sets of closed pairs that it looked at
  Eigen::Index factorisations = 0;    ///< dense factorisations, none for an empty set
  std::vector<Iteration> history;     ///< one entry per iteration, or empty
};

/// Forces, gaps and status of all pairs. Unless `report.status` is Solved, these are the last ones
/// that the method looked at and no solution.
struct ContactState {
  Eigen::VectorXd force;             ///< lambda `n_c` [force], compression > 0
  Eigen::VectorXd gap;               ///< `n_c` [length], open > 0
  std::vector<Eigen::Index> active;  ///< closed pairs, in increasing order
  Report report;                     ///< how the solver got there
};

/// Choices that every solver understands.
struct SolverOptions {
  Eigen::Index iteration_limit = 0;  ///< 0: the solver's own bound, which grows with the problem
};

/// Checks what every solver relies on.
/// \param problem  G and d
/// \throws std::invalid_argument unless G is square, symmetric to rounding and without a negative
///   diagonal entry, d has its size, and both are finite
void check_problem(const ContactProblem& problem);

}  // namespace signorini
