/// \file
/// The quasi-active-set method as the paper prints it, with a truthful status.
#pragma once
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// Which of the pairs that overlap make up the quasi-active set, \PaperEq{XuanLi2002, 37}.
///
/// The paper asks for rows of full rank, more than one in a step, and leaves open which: the first and the last
/// member are limiting cases of ours. Overlaps are compared in the energy norm,
/// \f$ -w_i / \sqrt{G_{ii}} \f$, so that the units of a row do not matter; of equal ones the first counts.
enum class QuasiActiveRows {
  AllViolated,             ///< all of them, independent or not
  IndependentByIndex,      ///< in their order, without those that depend on the ones before
  IndependentByViolation,  ///< the same, the largest overlap first
  MostViolated             ///< the one with the largest overlap
};

/// Among which violated pairs a step looks for its quasi-active set: the paper says, in those outside of
/// \f$ U^0 \f$, and repeats this. \PaperEq{XuanLi2002, 32}
enum class QuasiActivePool {
  AllPairs,    ///< all; those of the last set are satisfied anyway
  UnusedPairs  ///< those that no earlier set has had: a pair is taken at most once
};

/// One step of the outer loop; pairs in increasing order.
struct QuasiActiveStep {
  std::vector<Eigen::Index> violated;      ///< VIO(u^k)
  std::vector<Eigen::Index> quasi_active;  ///< QAS(u^k), a part of it
  std::vector<Eigen::Index> closed;        ///< pairs of QAS that the step presses
};

/// Which way a run took through the flow chart of chapter 4.
struct QuasiActiveRun {
  ContactState state;                   ///< what the run returns
  Eigen::Index outer_steps = 0;         ///< how often the minimum was moved, k
  std::vector<QuasiActiveStep> steps;   ///< `k`, what each of them did
  std::vector<Eigen::Index> tight;      ///< pairs without gap at u^k: the rows of the problem (33)
  bool optimal = false;                 ///< whether u^k is the solution already, before (33)
  std::vector<Eigen::Index> left_over;  ///< pairs that its solution u^{k+1} violates
  double fraction = 1;                  ///< delta of (34), 1 if none is left over
  Eigen::VectorXd moved;                ///< `n_c` forces at u^k, the sum over all steps [force]
  Eigen::VectorXd next;  ///< `n_c` forces at u^{k+1} of (33); empty if it was not reached
};

/// Solves a contact problem by the equations of the paper, one after the other.
///
/// \PaperEq{XuanLi2002, 30} to \PaperEq{XuanLi2002, 39}. Pairs that overlap are chosen as the
/// quasi-active set; \f$ \xi^k, \eta^k \f$ solve the problem with these pairs alone, exactly; the minimum
/// is moved to its solution, and the objective with it; this is repeated until no pair overlaps. Then the
/// problem is solved once with the first objective and the pairs that are tight, and the last step
/// goes as far towards its solution as no pair overlaps.
///
/// Where the paper leaves a choice: `rows` says which pairs that overlap are taken, `pool` whether they may have
/// been taken before; pairs of (33) may have \f$ b_i \le 0 \f$.
///
/// With `UnusedPairs` the loop ends at the latest when every pair was taken once, and u^k may overlap. A pair that
/// overlaps there and at u^{k+1} can make delta of (34) negative, and a force of the end as well.
///
/// An end after one step is the solution, whatever `rows`. If a step takes *all* pairs that overlap and
/// leaves an overlap, so does the next one. With `AllViolated` the loop therefore ends after one step or
/// only comes closer to a limit; with the others it may also end later, where it need not be optimal. So
/// that a limit ends it too, it stops when no overlap exceeds `options.tolerance` of the largest one
/// without contact, and a pair is tight if its gap is below the square root of that.
///
/// The forces \f$ \Lambda = \sum_k \eta^k\xi^k \f$ of the moved minima, and with `AllPairs` their mixture in the
/// last step, are never negative and balance the load. So energy_gap() bounds what is lost.
/// \param problem  G positive semidefinite, and d
/// \param options  `iteration_limit` on k, 0 stands for 100 n_c + 1000; `tolerance` as above
/// \param rows     which pairs make up the quasi-active set
/// \param pool     among which violated pairs they are looked for
/// \return `Solved` if the end is the solution, then with its forces; `Feasible` if there is less
///   energy elsewhere; `IterationLimit`, which is also how a run ends that has used up the pairs that overlap;
///   `Infeasible` with its proof if the pairs of one set contradict each other; `Breakdown` if a set cannot be
///   solved to rounding. The history has an entry for u^0, ..., u^k and for the end; `Iteration::changes` counts the pairs that overlap
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] QuasiActiveRun run_quasi_active_set_literal(
    const ContactProblem& problem, const SolverOptions& options = {},
    QuasiActiveRows rows = QuasiActiveRows::AllViolated,
    QuasiActivePool pool = QuasiActivePool::AllPairs);

/// The same with all pairs that overlap and without the way, for the table of solvers.
/// \param problem  as above
/// \param options  as above
/// \return as above
[[nodiscard]] ContactState quasi_active_set_literal(const ContactProblem& problem,
                                                    const SolverOptions& options = {});

/// How far the potential energy is from its least value, at most.
///
/// If K u + A^T lambda = p with lambda >= 0, potential energy minus dual energy is exactly
/// \f$ \lambda^T (g - A u) \f$, and no dual energy exceeds the least potential energy.
/// \param state  with lambda >= 0 and the gaps that belong to it
/// \return the bound [force*length]; negative only if a pair overlaps
[[nodiscard]] double energy_gap(const ContactState& state);

}  // namespace signorini
