/// \file
/// All gap conditions replaced by one weighted sum of them: the surrogate dual and its solver.
///
/// Weights \f$ \xi \ge 0,\ e^T\xi = 1 \f$ and one total contact force \f$ \eta \ge 0 \f$ stand for
/// the forces \f$ \lambda = \eta\xi \f$; \f$ b = -d = A u^0 - g \f$ is the overlap without contact.
#pragma once
#include "signorini/problem/problem.hpp"

namespace signorini {

/// The potential energy, \PaperEq{XuanLi2002, 10} on a mesh, which is \PaperEq{XuanLi2002, 12}
/// \param programme     K and p
/// \param displacement  u `n` [length]
/// \return \f$ \tfrac12 u^T K u - p^T u \f$ [force*length]
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] double potential_energy(const QuadraticProgramme& programme,
                                      const Eigen::VectorXd& displacement);

/// The potential energy with the work of contact forces on the overlaps.
/// \PaperEq{XuanLi2002, 14}, and with \f$ \lambda = \eta\xi \f$ \PaperEq{XuanLi2002, 16}
/// \param programme     K, p, A, g
/// \param displacement  u `n` [length]
/// \param force         lambda `n_c` >= 0 [force]
/// \return \f$ \tfrac12 u^T K u - p^T u + \lambda^T (A u - g) \f$ [force*length]
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] double lagrangian(const QuadraticProgramme& programme,
                                const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

/// The total contact force that closes the weighted gap \PaperEq{XuanLi2002, 15}, or zero if it is
/// open: \PaperEq{XuanLi2002, 17}, \PaperEq{XuanLi2002, 18}, \PaperEq{XuanLi2002, 19},
/// \PaperEq{XuanLi2002, 23}
///
/// \f$ \eta = (b^T\xi)_+ / \xi^T G \xi \f$. In the paper \f$ \eta \ge 0 \f$ shuts out weights with
/// \f$ b^T\xi < 0 \f$; here they get no force, which leaves the maximum of s over the others as it is.
/// \param problem  G and d
/// \param weights  xi `n_c` >= 0 [-]
/// \return eta >= 0 [force]; infinite if \f$ \xi^T G\xi = 0 \f$ and the weighted gap overlaps
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] double total_contact_force(const ContactProblem& problem,
                                         const Eigen::VectorXd& weights);

/// The energy that the best total force for these weights adds. \PaperEq{XuanLi2002, 24}
///
/// \f$ s = \tfrac12 \eta^2 \xi^T G \xi = \tfrac12 (b^T\xi)_+^2 / \xi^T G \xi \f$, without the
/// constant \f$ -\tfrac12 p^T K^{-1} p \f$, the energy without contact. Its maximum over all weights
/// is that of the paper over the weights with \f$ \eta \ge 0 \f$.
/// \param problem  G and d
/// \param weights  xi `n_c` >= 0 [-]
/// \return s >= 0 [force*length], at most the energy that the true contact adds
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] double surrogate_dual_value(const ContactProblem& problem,
                                          const Eigen::VectorXd& weights);

/// How s changes with the weights. \PaperEq{XuanLi2002, 25}
///
/// Since eta is the best one, its own change does not count: \f$ \nabla s = \eta (b - \eta G\xi) =
/// \eta (A u - g) \f$, the overlaps that are left, times the total force.
/// \param problem  G and d
/// \param weights  xi `n_c` >= 0 with \f$ \xi^T G\xi > 0 \f$ [-]
/// \return gradient `n_c` [force*length]; zero where eta = 0
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] Eigen::VectorXd surrogate_dual_gradient(const ContactProblem& problem,
                                                      const Eigen::VectorXd& weights);

/// Whether every pair overlaps without contact: \PaperEq{XuanLi2002, 26}, which is
/// \PaperEq{XuanLi2002, 27}. Then eta > 0 for all weights, and (25) becomes the linear programme (28).
/// \param problem  d
/// \return A u^0 - g > 0 in every row, strictly; true if there is no pair
[[nodiscard]] bool all_overlap(const ContactProblem& problem);

/// The weights that the paper starts with, and what is done where they are of no use.
/// \PaperEq{XuanLi2002, 29}
/// \param problem  G and d
/// \return e / n_c if the mean overlap without contact is positive; otherwise equal weights of the
///   pairs that overlap, so that eta > 0; all zero if none does
[[nodiscard]] Eigen::VectorXd start_weights(const ContactProblem& problem);

/// The five numbers that say how s varies along weights \f$ \xi + t\,\delta \f$.
struct WeightLine {
  double overlap;           ///< \f$ b^T\xi \f$, positive
  double overlap_slope;     ///< \f$ b^T\delta \f$
  double compliance;        ///< \f$ \xi^T G\xi \f$, positive
  double compliance_slope;  ///< \f$ \xi^T G\delta \f$
  double compliance_bend;   ///< \f$ \delta^T G\delta \f$
};

/// The best step along a line, in closed form.
///
/// With the numbers \f$ b_0, b_1, c_0, c_1, c_2 \f$ of the line the terms in t^2 of the derivative of
/// \f$ s(t) \f$ cancel, and it vanishes at \f$ t = (b_0 c_1 - b_1 c_0) / (b_1 c_1 - b_0 c_2) \f$.
/// \param line     from weights with a positive overlap
/// \param largest  step that keeps all weights >= 0
/// \return the step in [0, largest] with the largest s; 0 if s does not rise at its beginning
[[nodiscard]] double best_step(const WeightLine& line, double largest);

/// How the weights change from one iteration to the next. All look for the vertex of the most violated
/// pair, which solves the linear programme \PaperEq{XuanLi2002, 28}. Away steps may leave another vertex
/// instead; the last rule takes that vertex into the face and goes to the best point there.
enum class WeightRule {
  LiteralVertex,   ///< jump to that vertex, as the paper says
  Harmonic,        ///< go 2/(k+2) of the way in iteration k = 0, 1, ...
  LineSearch,      ///< go as far as best_step() [\ref FrankWolfe1956]
  AwaySteps,       ///< or away from the worst vertex in use [\ref LacosteJulienJaggi2015]
  Pairwise,        ///< move weight from the worst vertex in use to the best one, same source
  FullyCorrective  ///< the best point of the face of all vertices in use
};

/// Solves a contact problem through the surrogate dual.
///
/// The weights of the equilibrated problem start at start_weights(), in the last rule at the vertex
/// with the largest overlap, and change by the rule. That rule ends by itself. With the others, after
/// 1, 2, 4, 8, ... iterations and at the end, the pairs in use whose force exceeds their gap, both
/// scaled, are taken as closed, and this guess is confirmed() exactly or dropped; at the end pairs
/// that would have to pull are left out.
/// \param problem  G positive semidefinite
/// \param rule     how the weights change
/// \param options  `iteration_limit` 0 stands for 100 n_c + 1000; with `tolerance` of
///   WeightIteration::relative_gap() the iteration ends
/// \return `Solved`; `Infeasible` with its proof, weights with \f$ G\xi = 0,\ b^T\xi > 0 \f$, which
///   only the last rule is sure to find, or `Breakdown` if they hold only nearly; else
///   `IterationLimit`, which is also how the literal rule ends when a vertex comes back. The history
///   keeps iterations 0 to 31 and then 16 per doubling; `Iteration::dual_energy` is s
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ContactState surrogate_dual(const ContactProblem& problem, WeightRule rule,
                                          const SolverOptions& options = {});

/// The same with a fixed rule. \param problem  as above \param options  as above \return as above
template <WeightRule rule>
[[nodiscard]] ContactState surrogate_dual(const ContactProblem& problem,
                                          const SolverOptions& options) {
  return surrogate_dual(problem, rule, options);
}

}  // namespace signorini
