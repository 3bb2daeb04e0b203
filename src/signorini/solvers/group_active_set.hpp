/// \file
/// The quasi-active-set method itself, independent of how the gap rows are known.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "signorini/closing/closed_basis.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// What the method asks of the rows of a problem.
struct GapRows {
  Eigen::Index count = 0;  ///< number of rows m
  Eigen::Index equations =
      0;                  ///< so many of the first are always closed, their forces have any sign
  Eigen::Index rank = 0;  ///< most rows that can be independent
  const Eigen::VectorXd* weight = nullptr;  ///< `m` about 1 / |h_i|, to compare overlaps with
  /// Sets the gaps of all rows `m` and what rounding may have done to each.
  std::function<void(const ClosedBasis&, Eigen::VectorXd& gap, Eigen::VectorXd& rounding)> gaps;
  /// Condenses rows, named by `candidates.rows`: \f$ h_i / |h_i| \f$ or the same in products.
  std::function<void(const ClosedBasis&, const Eigen::VectorXd& gap,
                     const Eigen::VectorXd& rounding, ClosedBasis::Candidates& candidates)>
      fetch;
};

/// One run of the method, which may be taken up again. See quasi_active_set() for its steps.
class GroupActiveSet {
 public:
  /// Starts with no row closed.
  /// \param rows    must outlive this
  /// \param basis   empty, with room for the rank of the rows
  /// \param report  takes iterations, factorisations and history; must outlive this
  /// \param limit   most iterations
  GroupActiveSet(const GapRows& rows, ClosedBasis basis, Report& report, Eigen::Index limit);

  /// Closes the equations, leaving out those that follow from others.
  /// \return Solved, or Infeasible if they contradict each other
  Status close_equations();
  /// Goes on until no row overlaps beyond rounding.
  /// \return Solved, Infeasible, IterationLimit or Breakdown
  Status run();
  /// Goes on after an Infeasible whose proof does not hold: the overlap of the row that could not be closed
  /// counts as rounding until the energy rises.
  void pass_over();
  /// Opens rows that a refinement has found in tension, and goes back to forces that are the best for
  /// the others. \param tension  `size` of the basis, > 0 where it pulls
  void release(const Eigen::VectorXd& tension);

  /// \return the closed rows
  [[nodiscard]] ClosedBasis& basis() { return basis_; }
  /// \return after Infeasible: numbers y of normalised rows `m`, >= 0 but for equations, with
  ///   \f$ \sum y_i h_i = 0 \f$ while the same sum of gaps is negative
  [[nodiscard]] const Eigen::VectorXd& proof() const { return proof_; }
  /// \return after Infeasible: the row that could not be closed
  [[nodiscard]] Eigen::Index pressed() const { return pressed_; }

 private:
  /// Fruitless rows have joined, or left for others, without a rise of the energy: their overlap is rounding.
  enum class Row : char { Open, Closed, Fruitless };

  void forget_fruitless();
  void mark_fruitless(const std::vector<Eigen::Index>& rows);
  void find_most_violated();
  void fetch(Eigen::Index row);
  void open_vanished(const std::vector<Eigen::Index>& positions);
  void settle(Eigen::Index before);
  void step_by_step();
  Status exchange(Eigen::Index row);
  [[nodiscard]] double grazing(Eigen::Index row, const Eigen::VectorXd& response) const;
  [[nodiscard]] std::pair<Eigen::Index, double> first_to_open(
      const Eigen::VectorXd& response) const;
  void drop(const std::vector<Eigen::Index>& positions);
  void solve();
  [[nodiscard]] std::vector<Eigen::Index> pulling() const;

  const GapRows& rows_;
  ClosedBasis basis_;
  ClosedBasis saved_;
  Report& report_;
  Eigen::Index limit_;
  Eigen::Index group_;
  Eigen::Index pressed_ = -1;
  Eigen::VectorXd gap_;
  Eigen::VectorXd rounding_;
  Eigen::VectorXd force_;
  Eigen::VectorXd target_;
  Eigen::VectorXd proof_;
  ClosedBasis::Candidates candidates_;
  std::vector<Row> state_;
  bool any_fruitless_ = false;
};

}  // namespace signorini
