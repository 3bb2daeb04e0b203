/// \file
/// The weights of the surrogate dual, step by step: for the solver, and for looking at its path.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "papers/simplex_face.hpp"
#include "papers/surrogate_dual.hpp"

namespace signorini {

/// Why an iteration of the weights went no further.
enum class WeightEnd {
  None,       ///< it can go on
  Optimal,    ///< no pair overlaps beyond rounding
  Repeats,    ///< the literal rule came back to a vertex
  Unbounded,  ///< \f$ G\xi = 0,\ b^T\xi > 0 \f$: the gaps contradict each other
  Still       ///< no step raises s by more than rounding
};

/// Weights on the simplex that change by one rule. A step costs one column of G, in the pairwise rule
/// two, and a few sums over all pairs; in the last rule a product with G and triangular solves with the
/// vertices in use.
class WeightIteration {
 public:
  /// Starts at start_weights(), or at the vertex with the largest overlap for the last rule.
  /// \param problem  G positive semidefinite and d; must live as long as this object
  /// \param rule     how the weights change
  WeightIteration(const ContactProblem& problem, WeightRule rule);

  /// One update of the weights. \PaperEq{XuanLi2002, 28}
  /// \return false if nothing was changed, for the reason end()
  bool step();

  /// Current weights. \return xi `n_c` [-], summing to 1 to rounding, or all zero if no pair overlaps
  [[nodiscard]] const Eigen::VectorXd& weights() const { return weights_; }
  /// \return overlaps \f$ A u - g \f$ `n_c` [length] under the forces eta xi
  [[nodiscard]] const Eigen::VectorXd& overlap() const { return overlap_; }
  /// \return eta [force]
  [[nodiscard]] double total_force() const { return total_force_; }
  /// \return s [force*length]
  [[nodiscard]] double value() const { return value_; }
  /// How far s may be from its maximum s*: \f$ s^* - s \le \eta^* \max_i (A u - g)_i \f$, with the
  /// total force at hand instead of the unknown \f$ \eta^* \f$, over s.
  /// \return that ratio [-], 0 if there is nothing to gain, infinite if s = 0
  [[nodiscard]] double relative_gap() const;
  /// \return why step() returned false
  [[nodiscard]] WeightEnd end() const { return end_; }
  /// \return if Unbounded: y `n_c` >= 0 with G y = 0 and d^T y < 0
  [[nodiscard]] const Eigen::VectorXd& farkas_certificate() const { return infeasibility_; }
  /// \return factorisations of the last rule
  [[nodiscard]] Eigen::Index factorisations() const { return face_.factorisations(); }

 private:
  /// delta = p e_to - q e_from + r xi, up to a step `largest`.
  struct Direction {
    Eigen::Index to;
    Eigen::Index from;
    double p;
    double q;
    double r;
    double largest;
  };
  [[nodiscard]] Direction direction(Eigen::Index best) const;
  [[nodiscard]] double step_length(const Direction& towards) const;
  void move(const Direction& towards, double step);
  bool stop(WeightEnd why);
  bool jump(Eigen::Index best);
  bool correct(Eigen::Index best);
  bool take_in(Eigen::Index vertex);
  void renew();
  void evaluate();

  const ContactProblem& problem_;
  WeightRule rule_;
  Eigen::VectorXd root_;     // sqrt(G_ii)
  Eigen::VectorXd weights_;  // xi
  Eigen::VectorXd product_;  // G xi
  Eigen::VectorXd overlap_;
  Eigen::VectorXd infeasibility_;
  SimplexFace face_;
  std::vector<bool> visited_;
  Eigen::Index steps_ = 0;
  double compliance_ = 0;  // xi.G xi
  double total_force_ = 0;
  double value_ = 0;
  WeightEnd end_ = WeightEnd::None;
};

/// Which pairs carry weight at the start and after every step.
/// \param problem  G positive semidefinite and d, as they are; other scales of its rows give other steps
/// \param rule     how the weights change
/// \param limit    on the number of steps, for rules that do not end by themselves
/// \return one list of pairs for the start and one per step, each in increasing order
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] std::vector<std::vector<Eigen::Index>> weight_supports(const ContactProblem& problem,
                                                                     WeightRule rule,
                                                                     Eigen::Index limit);

}  // namespace signorini
