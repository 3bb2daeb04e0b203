/// \file
/// The one linear system that every method ends with: what all pairs do is known.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "signorini/core/exact_sum.hpp"
#include "signorini/problem/scaled.hpp"

namespace signorini {

/// A friction force at its bound, tau = slope lambda + offset.
struct SlidingPair {
  Eigen::Index gap;   ///< row of its gap
  Eigen::Index slip;  ///< row of its slip
  double slope;       ///< -mu, 0 or mu [-]
  double offset;      ///< -c, 0 or c [force]

  /// \param normal  lambda, rounded [force]
  /// \param low     what rounding took away from it [force]
  /// \return tau in twice the working precision, \PaperEq{LinEtAl, 15}, \PaperEq{LinEtAl, 16}
  [[nodiscard]] ExactSum friction(double normal, double low = 0) const {
    ExactSum tau(offset);
    tau.add_product(slope, normal);
    tau.add(slope * low);
    return tau;
  }
};

/// \param a  a pair \param b  another \return whether all of both is the same
inline bool operator==(const SlidingPair& a, const SlidingPair& b) {
  return std::tie(a.gap, a.slip, a.slope, a.offset) == std::tie(b.gap, b.slip, b.slope, b.offset);
}

/// What follows for the rows of gaps and slips: which of them do not move, and which friction forces are at
/// their bounds. All other forces vanish.
struct ActiveSet {
  std::vector<Eigen::Index> closed;       ///< rows that do not move, the most certain first
  std::vector<SlidingPair> sliding = {};  ///< in increasing order
};

/// The set that the statuses of all pairs make.
/// \param statuses  `n_c`
/// \param law      of the frictional pairs; one whose mu and c vanish slides without a force
/// \return rows `n_c` of gaps, then `n_s` of slips; those that are closed in increasing order
[[nodiscard]] ActiveSet active_set(const std::vector<ContactStatus>& statuses,
                                   const FrictionLaw& law);

/// Makes forces those that a set allows: friction of sliding pairs is at its bound, on the side that the status tells, and rows
/// that are not closed have none. Forces are sums of two parts.
/// \param set         closed rows and sliding pairs
/// \param[in,out] force, low  of all rows, rounded, and what rounding took away [force]
void impose(const ActiveSet& set, Eigen::VectorXd& force, Eigen::VectorXd& low);

/// \param active  closed pairs
/// \param pairs   n_c
/// \return `n_c` statuses: these stick, the others are open
[[nodiscard]] std::vector<ContactStatus> statuses_of(const std::vector<Eigen::Index>& active,
                                                     Eigen::Index pairs);

/// \param state  what a solver says \return forces of gaps, then friction forces `n_c + n_s` [force]
[[nodiscard]] Eigen::VectorXd all_forces(const ContactState& state);

/// \param state  what a solver says \return gaps, then slips `n_c + n_s` [length]
[[nodiscard]] Eigen::VectorXd all_movements(const ContactState& state);

/// The system of a known set, factored once:
///
/// \f[ \begin{pmatrix} F_{WW} + F_{WS}\,\mathrm{slope} & U_W \\ (U_W + U_S\,\mathrm{slope})^T & 0 \end{pmatrix}
///     \begin{pmatrix} f_W \\ b \end{pmatrix} = \dots \f]
///
/// for closed rows W and the slips S of sliding pairs, whose friction forces follow the normal ones. Where it
/// is symmetric and rows of W repeat each other, as many as are independent are kept, the first of the set
/// first; they close the others as well if that can be done. Adding \f$ \rho U_W U_W^T \f$ to the first block
/// changes no solution then, because U^T f is given, and makes that block positive definite. Any other
/// singular system has its least-norm solution. Where F has few entries, \f$ \sqrt\epsilon \f$ on the diagonal makes
/// any system regular, and refinement takes it away again from all that the system determines.
struct ActiveSetSystem {
  std::vector<Eigen::Index> rows;  ///< independent rows of W, all of W if it has no others
  bool reversed =
      false;  ///< whether the determinant has the sign that it cannot have with little friction
  /// Takes what the forces must add to the movements of `rows`, and to U^T f `k` [sqrt(energy)]; returns changes of the
  /// forces of `rows`, and of the amplitudes: where W leaves a mode free, none of it
  std::function<std::pair<Eigen::VectorXd, Eigen::VectorXd>(const Eigen::VectorXd& top,
                                                            const Eigen::VectorXd& bottom)>
      solve = {};
  ActiveSet set = {};  ///< W in the order in which it was given, and S
};

/// Factors the system by one of the three functions below, unless the problem has it already. Rows of W that are all independent
/// may stand there in another order.
/// \param problem  scaled
/// \param set      W and S, with the slopes of scaled forces
/// \return the system
[[nodiscard]] ActiveSetSystem active_set_system(const ScaledProblem& problem, const ActiveSet& set);

/// The system of closed rows without sliding, by two Cholesky factors. \param problem  scaled, F symmetric
/// \param closed  W, the most certain first \return the system, of the first rows of W that are independent
[[nodiscard]] ActiveSetSystem symmetric_system(const ScaledProblem& problem,
                                               const std::vector<Eigen::Index>& closed);

/// The system of any set, by an LU factor. \param problem  scaled \param set  W and S
/// \return the system; where it is singular, of least norm
[[nodiscard]] ActiveSetSystem general_system(const ScaledProblem& problem, const ActiveSet& set);

/// The same where F has few entries. \param problem  scaled, with its entries \param set  W and S
/// \return the system, with \f$ \sqrt\epsilon \f$ on its diagonal
[[nodiscard]] ActiveSetSystem sparse_system(const ScaledProblem& problem, const ActiveSet& set);

/// The matrix of ActiveSetSystem as it is written there.
/// \param problem  scaled
/// \param rows     W `m`
/// \param set      whose sliding pairs have their gaps in W
/// \return `m + k` square, its first m columns those of the forces of W
[[nodiscard]] Eigen::MatrixXd active_set_matrix(const ScaledProblem& problem,
                                             const std::vector<Eigen::Index>& rows,
                                             const ActiveSet& set);

/// Forces and movements when what all pairs do is known; scaled numbers [sqrt(energy)].
struct ActiveSetSolution {
  Eigen::VectorXd force;           ///< of all rows; tension < 0 is possible
  Eigen::VectorXd movement;        ///< of all rows: gaps, then slips; exactly 0 in `rows`
  Eigen::VectorXd amplitude;       ///< b `k`
  std::vector<Eigen::Index> rows;  ///< the independent rows that were closed, in increasing order
  double force_rounding = 0;       ///< what rounding may have done to each force
  Eigen::VectorXd movement_rounding;  ///< and to each movement
  bool solvable = false;              ///< whether `rows` are closed and U^T f = t, to rounding
  bool reversed = false;              ///< as ActiveSetSystem::reversed
  std::shared_ptr<const ActiveSetSystem> system = {};  ///< that it was solved with

  /// \param row  any \return whether its movement is what rounding of its terms, or of a force, can make of 0
  [[nodiscard]] bool closes(Eigen::Index row) const {
    return std::abs(movement(row)) <= 4 * (movement_rounding(row) + force_rounding);
  }
};

/// Solves the equations of a known set, refined in twice the working precision: no movement of closed rows,
/// friction forces at their bounds, U^T f = t.
/// \param problem    scaled
/// \param set        what is known
/// \param start      where to start, or null: of rows that repeat others and of amplitudes that nothing holds
///                   this is kept, else it is zero
/// \return forces, movements and amplitudes, of any sign
[[nodiscard]] ActiveSetSolution solve_active_set(const ScaledProblem& problem, const ActiveSet& set,
                                                 const ActiveSetSolution* start = nullptr);

/// The same for statuses of pairs.
/// \param problem  scaled
/// \param statuses  `n_c`
/// \param start    as above
/// \return as above
[[nodiscard]] ActiveSetSolution solve_active_set(const ScaledProblem& problem,
                                                 const std::vector<ContactStatus>& statuses,
                                                 const ActiveSetSolution* start = nullptr);

/// What numbers say of each pair: it is closed if its force exceeds its gap, and then slides if |tau - slip|
/// exceeds the bound of the force less the gap.
///
/// At a solution all this is as it is said; elsewhere it is the guess of a projection
/// [\ref AlartCurnier1991]. Of an active-set solution, what rounding may have done decides nothing.
/// \param problem  scaled
/// \param solution  any numbers; without roundings these count as 0
/// \param force_scale    forces count force_scale times against gaps and slips
/// \param[in,out] statuses  `n_c`: what was assumed, and then what the numbers say
/// \return how many entries of `statuses` changed
Eigen::Index predict(const ScaledProblem& problem, const ActiveSetSolution& solution,
                     double force_scale, std::vector<ContactStatus>& statuses);

/// Whether an active-set solution is a solution: no force is tensile, no pair overlaps, friction keeps its bound and resists,
/// all beyond rounding; and rounding is so small that certify() agrees. It does not where a system passed
/// as regular only because of its rounding: then the forces are huge, and any gap could be rounding.
/// \param problem  scaled
/// \param statuses  `n_c` that were assumed
/// \param solution  from solve_active_set() of them
/// \return whether a solver may say Solved
[[nodiscard]] bool solves(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses,
                          const ActiveSetSolution& solution);

/// A solution of an active set that solves the problem, and the statuses that it belongs to.
using Confirmed = std::optional<std::pair<ActiveSetSolution, std::vector<ContactStatus>>>;

/// Ends a method that only guesses which pairs are closed: takes as many of them as are independent, closes
/// these exactly, and looks whether that is a solution.
/// \param problem     scaled, without friction
/// \param candidates  pairs taken as closed, the most certain first
/// \param start       as of solve_active_set()
/// \return forces and movements if they are a solution, see solves(); otherwise nothing
[[nodiscard]] Confirmed confirmed(const ScaledProblem& problem,
                                  const std::vector<Eigen::Index>& candidates,
                                  const ActiveSetSolution* start = nullptr);

/// Puts numbers into a state; its report and its amplitude stay. Pairs that slide without a friction force get the direction of
/// their slip: a method need not know it. Where there is a friction force it tells the direction, also of a slip that is nothing
/// but rounding.
/// \param law       of the frictional pairs
/// \param statuses  `n_c`
/// \param force     of all rows
/// \param movement  of all rows: gaps, then slips
/// \param[in,out] state  gets forces, gaps, slips and statuses
void fill_state(const FrictionLaw& law, const std::vector<ContactStatus>& statuses,
                const Eigen::VectorXd& force, const Eigen::VectorXd& movement, ContactState& state);

/// One entry of a history, in the units of the problem as it was posed.
/// \param problem  scaled
/// \param statuses  `n_c`
/// \param solution  forces and movements
/// \param changes  pairs that change
/// \return closed pairs, changes, the largest overlap of an open pair and tension of a closed one; the dual energy
///   of held bodies without friction
[[nodiscard]] Iteration summary(const ScaledProblem& problem,
                                const std::vector<ContactStatus>& statuses,
                                const ActiveSetSolution& solution, Eigen::Index changes);

/// \param weight  `n_c` \return the pairs with a positive one, the largest first
[[nodiscard]] std::vector<Eigen::Index> by_falling(const Eigen::VectorXd& weight);

/// Turns scaled numbers into a state of the original problem, and withdraws a claim that the problem as it was
/// posed does not confirm: scaling back is rounded, which dependent pairs with large forces can notice.
/// \param problem  as it was posed
/// \param scaled   the same, equilibrated
/// \param solution  forces, movements and amplitudes; of a solution, negative ones, which may be rounding, become 0
/// \param statuses  `n_c`
/// \param report   how the solver got there
/// \param proof    that nothing solves the problem, in its units, or empty
/// \return the state, `Breakdown` instead of `Solved` if the certificate is worse than 1e-12, and instead of
///   `Infeasible`, without the proof, if that does not hold by verify_farkas()
[[nodiscard]] ContactState finished(const ContactProblem& problem, const ScaledProblem& scaled,
                                    const ActiveSetSolution& solution,
                                    const std::vector<ContactStatus>& statuses, Report report,
                                    Eigen::VectorXd proof = {});

}  // namespace signorini
