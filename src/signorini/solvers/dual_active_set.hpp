// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Dual active sets, in groups or one pair at a time, independent of how the gap rows are known.
#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "signorini/problem/constraint_rows.hpp"

namespace signorini {

/// One run of the method, which may be taken up again. See quasi_active_set() and goldfarb_idnani() for the steps.
class DualActiveSet {
 public:
  /// How many rows join at a time.
  enum class Step {
    Block,  ///< violated rows join together
    Single  ///< the most violated row is pressed until it closes
  };
  /// Starts with the rows of a basis closed; if there are any, release() finds their forces.
  /// \param rows    must outlive this
  /// \param basis   with room for the rank of the rows
  /// \param report  takes iterations, factorisations and history; must outlive this
  /// \param limit   most iterations
  /// \param kind    how many rows join at a time
  DualActiveSet(const ConstraintRows& rows, ActiveSetFactor basis, Report& report,
                Eigen::Index limit, Step kind);

  /// Closes the equations, leaving out those that follow from others.
  /// \return Solved, or Infeasible if they contradict each other
  SolveStatus close_equations();
  /// Goes on until no row overlaps beyond rounding.
  /// \return Solved, Infeasible, IterationLimit or Breakdown
  SolveStatus run();
  /// Presses one row until it closes, as a step of Step::Single does.
  /// \param row  that overlaps
  /// \return Solved, Infeasible, IterationLimit or Breakdown
  SolveStatus take_in(Eigen::Index row);
  /// Goes on after an Infeasible whose proof does not hold: the overlap of the row that could not be closed
  /// counts as rounding until the energy rises.
  void pass_over();
  /// Opens rows that a refinement has found in tension, and goes back to forces that are the best for
  /// the others. \param tension  `size` of the basis, > 0 where it pulls
  void release(const Eigen::VectorXd& tension);

  /// \return the closed rows
  [[nodiscard]] ActiveSetFactor& basis() { return basis_; }
  /// \return the closed rows
  [[nodiscard]] const ActiveSetFactor& basis() const { return basis_; }
  /// \return after Infeasible: numbers y of normalised rows `m`, >= 0 but for equations, with
  ///   \f$ \sum y_i h_i = 0 \f$ while the same sum of gaps is negative
  [[nodiscard]] const Eigen::VectorXd& proof() const { return proof_; }
  /// \return after Infeasible: the row that could not be closed
  [[nodiscard]] Eigen::Index pressed() const { return pressed_; }

 private:
  /// Stalled rows have joined, or left for others, without a rise of the energy: their overlap is rounding.
  enum class Row : char { Open, Closed, Stalled };

  bool close_block();
  [[nodiscard]] bool energy_exceeds(double energy) const;
  void forget_stalled();
  void mark_stalled(const std::vector<Eigen::Index>& rows);
  void find_most_violated();
  void fetch(Eigen::Index row);
  void open_vanished(const std::vector<Eigen::Index>& positions);
  void settle(Eigen::Index before);
  void step_by_step();
  SolveStatus press(Eigen::Index row);
  SolveStatus cannot_close(Eigen::Index row, const Eigen::VectorXd& response);
  bool join(Eigen::Index row, double force);
  void yield(const Eigen::VectorXd& response, double step);
  [[nodiscard]] double grazing(Eigen::Index row, const Eigen::VectorXd& response) const;
  [[nodiscard]] std::pair<Eigen::Index, double> first_to_open(
      const Eigen::VectorXd& response) const;
  void drop(const std::vector<Eigen::Index>& positions);
  void solve();
  [[nodiscard]] std::vector<Eigen::Index> pulling() const;

  const ConstraintRows& rows_;
  ActiveSetFactor basis_;
  ActiveSetFactor saved_{0, 0};
  Report& report_;
  Eigen::Index limit_;
  Step kind_;
  Eigen::Index group_ = (rows_.rank + 1) / 2;  ///< most rows of a block
  Eigen::Index pressed_ = -1;
  Eigen::VectorXd gap_;
  Eigen::VectorXd rounding_;
  Eigen::VectorXd force_ = Eigen::VectorXd(basis_.capacity());
  Eigen::VectorXd target_;
  Eigen::VectorXd proof_;
  ActiveSetFactor::Candidates candidates_;
  std::vector<Row> state_;
};

/// \param basis      closed rows
/// \param equations  so many of the first rows are not wanted
/// \return the others, in increasing order
[[nodiscard]] std::vector<Eigen::Index> sorted_rows(const ActiveSetFactor& basis,
                                                    Eigen::Index equations = 0);

}  // namespace signorini
