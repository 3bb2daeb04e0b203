/// \file
/// What the program behind table 1 of Xuan and Li may have done: readings of one method, each as a program.
#pragma once
#include <string>
#include <vector>

#include "papers/quasi_active_set_literal.hpp"
#include "papers/surrogate_dual.hpp"

namespace signorini {

/// The forces of weights that are not at their end.
///
/// The weights of all pairs start at start_weights() and take so many steps of their rule, fewer if the rule ends.
/// Pairs are compared in the units of the problem, as in \PaperEq{XuanLi2002, 28}, not after scaling.
/// \param problem  G positive semidefinite and d
/// \param rule     how the weights change
/// \param steps    at most
/// \return \f$ \eta\xi \f$ `n_c` >= 0 [force]
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] Eigen::VectorXd stopped_weights(const ContactProblem& problem, WeightRule rule,
                                              Eigen::Index steps);

/// The outer loop with stopped_weights() in each step: minima are moved as in \PaperEq{XuanLi2002, 36}, all violated
/// pairs are taken, and their weights stop early.
/// \param problem    G positive semidefinite and d
/// \param steps      of the weights in each outer step, by 2/(k+2)
/// \param tolerance  a pair is violated if it overlaps by more than this part of the largest overlap without contact [-]
/// \return sum of the forces of all outer steps `n_c` >= 0 [force], after at most 1000 of them
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] Eigen::VectorXd loop_of_stopped_weights(const ContactProblem& problem,
                                                      Eigen::Index steps, double tolerance);

/// The last step of the paper, where (34) looks only at pairs that do not overlap at u^k: those that the way to
/// u^{k+1} meets. \PaperEq{XuanLi2002, 34}, \PaperEq{XuanLi2002, 35}
/// \param problem  G and d
/// \param run      of run_quasi_active_set_literal() on it
/// \return forces `n_c` at the end of that way [force]; those at u^k if there is no u^{k+1}
[[nodiscard]] Eigen::VectorXd last_step_to_open_pairs(const ContactProblem& problem,
                                                      const QuasiActiveRun& run);

/// A reading of the method: its names, and the forces at its end.
struct MethodReading {
  std::string key;        ///< one word, for names of results
  std::string name;       ///< as in the tables of the book
  Eigen::VectorXd force;  ///< `n_c` [force]
};

/// All readings, in the order of the book: (28) to the letter; the loop with the four choices of pairs; with each pair
/// once, and (34) as printed or for the pairs that are met; with weights that stop early; weights alone that stop early.
/// A loop makes at most 1000 outer steps.
/// \param problem  G positive definite and d
/// \return what each of them ends with
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] std::vector<MethodReading> method_readings(const ContactProblem& problem);

}  // namespace signorini
