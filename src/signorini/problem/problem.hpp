/// \file
/// The frictionless contact problem as pure algebra, in its two forms, and what a solver returns.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <string>
#include <vector>

namespace signorini {

/// Least potential energy without penetration, \PaperEq{XuanLi2002, 9} and \PaperEq{XuanLi2002, 10}
/// on a mesh: \PaperEq{XuanLi2002, 11}, \PaperEq{XuanLi2002, 12}
///
/// \f[ \min_u \tfrac12 u^T K u - p^T u \quad\text{subject to}\quad A u \le g. \f]
struct QuadraticProgramme {
  Eigen::SparseMatrix<double> stiffness;           ///< K `n x n`, both triangles [force/length]
  Eigen::VectorXd load;                            ///< p `n` [force]
  Eigen::SparseMatrix<double, Eigen::RowMajor> A;  ///< `n_c x n`: gap = initial_gap - A u [-]
  Eigen::VectorXd initial_gap;                     ///< g `n_c` [length], overlap < 0
};

/// Which pairs rub, and how strongly: \PaperEq{LinEtAl, 6}. Without friction all three are empty.
struct FrictionLaw {
  std::vector<Eigen::Index> pair;  ///< `n_s` pairs whose slips are the last `n_s` rows of A
  Eigen::VectorXd coefficient;     ///< mu `n_s` >= 0 [-]
  Eigen::VectorXd cohesion;        ///< c times the weight `n_s` >= 0 [force], of closed pairs only
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

/// The same problem with the displacements eliminated: find forces >= 0 with
/// gap = free_gap + compliance * force >= 0 and force * gap = 0 pair by pair.
///
/// \PaperEq{XuanLi2002, 6} after condensation: \f$ d = g - A u^0,\ G = A K^{-1} A^T \f$. With any
/// square matrix in the place of G it is the linear complementarity problem w = M z + q; the solvers
/// that do not list Trait::Asymmetric accept that.
struct ContactProblem {
  Eigen::MatrixXd compliance;  ///< G `n_c x n_c`, symmetric positive semidefinite [length/force]
  Eigen::VectorXd free_gap;    ///< d `n_c` [length]: the gap when contact is ignored, overlap < 0
};

/// The condensed problem with G = H^T H left as a product: for many pairs of a small body H is far
/// smaller than G, and only the columns of pairs that close are ever needed.
struct HalfProblem {
  Eigen::MatrixXd half;      ///< H = L^-1 A^T `n x n_c`, where K = L L^T [sqrt(length/force)]
  Eigen::VectorXd free_gap;  ///< d `n_c` [length]: the gap when contact is ignored, overlap < 0
};

/// How a solver ended. Nothing but `Solved` may be called a solution.
enum class Status {
  Solved,          ///< all conditions hold to rounding
  Feasible,        ///< nothing overlaps and forces balance, but the energy is not the least
  Infeasible,      ///< no forces satisfy the conditions
  Ray,             ///< the method ran off along a ray; a solution may or may not exist
  IterationLimit,  ///< stopped by the limit on iterations
  Breakdown        ///< a system the method needs is singular to working precision
};

/// A status in words.
/// \param status  any
/// \return "solved", "feasible, not optimal", "infeasible", "ray", "iteration limit" or "breakdown"
[[nodiscard]] const char* to_string(Status status);

/// One iteration of a solver.
struct Iteration {
  Eigen::Index active;     ///< pairs taken as closed
  Eigen::Index changes;    ///< pairs found on the wrong side, which are candidates for a change
  double penetration;      ///< largest overlap of a pair taken as open [length]
  double tension;          ///< largest tensile force of a pair taken as closed [force]
  double dual_energy = 0;  ///< \f$ -d^T\lambda - \tfrac12\lambda^T G\lambda \f$ [force*length]
  /// Size of what a method drives to zero, over its size without contact forces [-]; 0 if it has none
  double residual = 0;
};

/// What a solver says about its run.
struct Report {
  Status status = Status::Breakdown;  ///< how it ended
  Eigen::Index iterations = 0;        ///< steps of the method, for active sets: sets it looked at
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
  /// Proof that nothing solves the problem, or empty: y `n_c` >= 0 with G y = 0 and d^T y < 0. For any
  /// forces, \f$ y^T(d + G\lambda) = d^T y < 0 \f$, so some gap stays negative.
  Eigen::VectorXd infeasibility = {};
};

/// Choices that every solver understands.
struct SolverOptions {
  Eigen::Index iteration_limit = 0;  ///< 0: the solver's own bound, which grows with the problem
  /// Where a method that only comes closer and closer may stop [-]: its error relative to that of no
  /// contact force at all. Methods that end by themselves do not look at it.
  double tolerance = 1e-12;
};

/// Checks what every solver relies on: sizes and numbers.
/// \param problem  G and d, or any M and q
/// \throws std::invalid_argument unless G is square, d has its size, both are finite, and the numbers
///   of G, its diagonal and d are so far from overflow and underflow (2^-340 to 2^340, or 0; small
///   numbers beside the diagonal do no harm) that forces and energies are too
void check_finite(const ContactProblem& problem);

/// Checks what the solvers for symmetric problems rely on.
/// \param problem  G and d
/// \throws std::invalid_argument unless G is square, symmetric to rounding and without a negative
///   diagonal entry, d has its size, and both are finite
void check_problem(const ContactProblem& problem);

/// Whether G equals its transpose to rounding.
/// \param problem  G and d
/// \return whether \f$ |G_{ij} - G_{ji}| \f$ is at most 1e3 epsilon times \f$ \sqrt{G_{ii}G_{jj}} \f$
[[nodiscard]] bool is_symmetric(const ContactProblem& problem);

/// The scales of the pairs of w = M z + q, whatever the matrix: \f$ s_i = 1 / \sqrt{|M_{ii}|} \f$.
///
/// A pair with M_ii = 0 gets the scale that makes its largest coupling with the pairs that have a
/// diagonal 1; if there is none, as for every pair of a compliance with G_ii = 0, it keeps 1.
/// \param matrix  M `n_c x n_c`
/// \return s `n_c` > 0
[[nodiscard]] Eigen::VectorXd pair_scales(const Eigen::MatrixXd& matrix);

/// Multiplies H^T H out.
/// \param problem  H and d
/// \return G, exactly symmetric, and d
[[nodiscard]] ContactProblem multiplied_out(const HalfProblem& problem);

}  // namespace signorini
