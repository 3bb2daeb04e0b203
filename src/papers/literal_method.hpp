// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The run of the literal quasi-active-set method: its state, its sets of pairs, its problems with some pairs alone.
#pragma once
#include <vector>

#include "papers/quasi_active_set_literal.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {

/// One run on the equilibrated problem: forces >= 0 and the gaps that belong to them.
class LiteralMethod {
 public:
  /// \param problem  G positive semidefinite and d; must outlive this
  /// \param options  as of run_quasi_active_set_literal() \param rows  which pairs make up the quasi-active set
  /// \param pool     among which they are looked for
  LiteralMethod(const ContactProblem& problem, const SolverOptions& options, QuasiActiveRows rows,
                QuasiActivePool pool);
  /// \return the run, once
  QuasiActiveRun run();

 private:
  /// Whether a pair overlaps, beyond rounding and the tolerance.
  [[nodiscard]] bool overlaps(const ActiveSetSolution& point, Eigen::Index row) const;
  /// VIO: pairs that overlap.
  [[nodiscard]] std::vector<Eigen::Index> violated(const ActiveSetSolution& point) const;
  /// Those of them that may be taken.
  [[nodiscard]] std::vector<Eigen::Index> unused(std::vector<Eigen::Index> rows) const;
  /// QAS, chosen among these. \PaperEq{XuanLi2002, 37}
  [[nodiscard]] std::vector<Eigen::Index> quasi_active(std::vector<Eigen::Index> rows) const;
  /// Puts the largest overlap first; overlaps that differ by rounding only keep their order.
  void sort_by_violation(std::vector<Eigen::Index>& rows) const;
  /// Pairs without gap.
  [[nodiscard]] std::vector<Eigen::Index> tight(const ActiveSetSolution& point) const;
  /// Gaps that belong to the forces.
  void place(ActiveSetSolution& point) const;
  /// One entry of the history.
  void note(const ActiveSetSolution& point, Eigen::Index overlapping);
  /// The problem with some rows alone and given gaps of them: forces that are never tensile.
  /// The paper's (28) does not converge, so the weights are found exactly.
  /// \PaperEq{XuanLi2002, 38}, \PaperEq{XuanLi2002, 39}
  bool solve(const std::vector<Eigen::Index>& rows, const Eigen::VectorXd& gap,
             ActiveSetSolution& best);
  /// u^0, u^1, ..., u^k: \PaperEq{XuanLi2002, 30} to \PaperEq{XuanLi2002, 32}, moved by
  /// \PaperEq{XuanLi2002, 36}.
  bool outer_loop();
  /// Whether the present point is the best one for the pairs that are tight at it.
  [[nodiscard]] bool close_to(const ActiveSetSolution& best) const;
  /// The tight pairs alone and the way there. \PaperEq{XuanLi2002, 33} to \PaperEq{XuanLi2002, 35}
  bool last_step();
  /// The end is the solution if the rows that are tight there have no better one.
  void judge();

  const ContactProblem& problem_;
  ScaledProblem scaled_;
  QuasiActiveRows choice_;
  QuasiActivePool pool_;
  std::vector<bool> used_;  // pairs that a set has had
  double tolerance_;
  double largest_overlap_;  // without contact
  Eigen::Index limit_;
  ActiveSetSolution now_;
  QuasiActiveRun way_;
  Report report_;
};

}  // namespace signorini
