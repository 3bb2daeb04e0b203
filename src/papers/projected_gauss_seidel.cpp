// # Sweeps
//
// The oldest idea: close one pair after the other, as if nothing else moved, and begin again. Pair
// i gets the force
// \f[ \lambda_i \leftarrow \max\left(0,\; \lambda_i - \frac{g_i}{G_{ii}}\right), \f]
// where \f$ g_i \f$ is its gap at this moment, and every other gap changes by a column of G. For
// the two pairs with \f$ G = \begin{pmatrix} 2 & 1 \\ 1 & 2 \end{pmatrix} \f$ and overlaps (7, 5)
// the forces are
//
//     sweep 1: 3.5     0.75
//     sweep 2: 3.125   0.9375
//     limit:   3       1
//
// and the error falls to a quarter in each sweep. With many pairs that push each other the factor
// is close to 1. But *which* pairs press is known long before the forces are. In the example the
// set stays the same in sweep 2, and this set, closed exactly, is the solution.

#include "papers/projected_gauss_seidel.hpp"

#include <algorithm>

#include "papers/long_history.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

// Sweeps over all pairs until the set of those with a force can be closed exactly.
// In the loop, the gaps are computed anew after each sweep: a sweep changes them in n small steps,
// and the rounding of all these would add up.
// A set that cannot be closed exactly is tried again after 1, 2, 4, ... sweeps that leave it as it
// is: its pairs are taken by falling force, and if some depend on others, that order decides.
class Sweeps {
 public:
  explicit Sweeps(const ScaledProblem& problem)
      : problem_(problem),
        gap_(problem.free),
        force_(VectorXd::Zero(problem.free.size())),
        closed_(static_cast<std::size_t>(problem.free.size()), false) {}

  ContactState run(const ContactProblem& posed, const SolverOptions& options) {
    const Index n = force_.size();
    const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 1000 + 10 * n;
    Index unchanged = 0;  // sweeps since the set has changed
    while (true) {
      unchanged = sweep() ? 0 : unchanged + 1;
      ++report_.iterations;
      gap_ = problem_.free;  // anew, so that no rounding collects
      gap_.noalias() += problem_.compliance * force_;
      if (n > 0 && is_kept(report_.iterations - 1)) remember();
      const bool last = report_.iterations == limit;
      // A set that could not be closed is tried again now and then: the order of its forces matters.
      const bool power_of_two = (unchanged & (unchanged - 1)) == 0;
      if (!last && (unchanged == 0 || !power_of_two)) continue;
      const std::vector<Index> candidates = by_falling(force_);
      report_.factorisations += candidates.empty() ? 0 : 1;
      if (Confirmed found = confirmed(problem_, candidates)) {
        report_.status = SolveStatus::Solved;
        return finished(posed, problem_, found->first, found->second, std::move(report_));
      }
      if (!last) continue;
      report_.status = SolveStatus::IterationLimit;
      ActiveSetSolution now;
      now.force = force_;
      now.movement = gap_;
      return finished(posed, problem_, now, statuses_of(candidates, n), std::move(report_));
    }
  }

 private:
  /// \return whether the set of pairs with a force has changed
  bool sweep() {
    bool changed = false;
    for (Index i = 0; i < force_.size(); ++i) {
      const double stiffness = problem_.compliance(i, i);
      if (stiffness == 0) continue;  // no force moves it
      const double force = std::max(0.0, force_(i) - gap_(i) / stiffness);
      if (force != force_(i)) gap_ += (force - force_(i)) * problem_.compliance.col(i);
      force_(i) = force;
      const bool closed = force > 0;
      changed = changed || closed != closed_[static_cast<std::size_t>(i)];
      closed_[static_cast<std::size_t>(i)] = closed;
    }
    return changed;
  }

  void remember() {
    const double overlap = std::max(0.0, -gap_.cwiseQuotient(problem_.scale).minCoeff());
    report_.history.push_back({(force_.array() > 0).count(),
                               ((gap_.array() < 0) && (force_.array() == 0)).count(), overlap, 0,
                               -0.5 * force_.dot(problem_.free + gap_)});
  }

  const ScaledProblem& problem_;
  VectorXd gap_;
  VectorXd force_;
  std::vector<bool> closed_;
  Report report_;
};

}  // namespace

// Sweeps ask for nothing but a positive diagonal, so an asymmetric matrix is taken as well. Whether
// they converge then is another matter.
//
// A pair that its own force does not close cannot be swept. It is allowed where no force moves it
// at all: its row and its column are zero.
ContactState projected_gauss_seidel(const ContactProblem& problem, const SolverOptions& options) {
  check_plain(problem, "projected_gauss_seidel");
  const ScaledProblem scaled = equilibrate_any(problem);
  for (Index i = 0; i < problem.free_gap.size(); ++i) {
    const bool zero = problem.compliance.row(i).isZero(0) && problem.compliance.col(i).isZero(0);
    if (problem.compliance(i, i) > 0 || zero) continue;
    ContactState state;  // its force cannot close this pair
    state.force.setZero(problem.free_gap.size());
    state.gap = problem.free_gap;
    return state;
  }
  return Sweeps(scaled).run(problem, options);
}

}  // namespace signorini
