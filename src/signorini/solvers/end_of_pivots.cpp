// # What the last basis says
//
// Lemke's method ends with a basis and with rounding: each pivot rounds the numbers of the one before. So of a
// dictionary only this is taken over: which forces are in the basis, or along which forces may grow for ever. All numbers
// are found anew from M and q, and all conditions are looked at again. Without that a wrong basis would be claimed as a
// solution.
//
// With M = [2 1; 1 2] and q = (-7, -5) both forces are in the last basis: the pairs 1 and 2 are closed, and
// \f$ Mz = -q \f$ gives z = (3, 1).
//
// If M is symmetric and positive semidefinite, an end that is no solution is a proof that there is none. With
// M = [1 -1; -1 1] and q = (-2, 1) both forces grow together along a ray, y = (1, 1) moves nothing, and the sum of
// both gaps is -1, whatever the forces are.

#include "signorini/solvers/end_of_pivots.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/farkas.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

// The proof that nothing solves a problem, if forces in a ratio of these give one; otherwise empty.
// A ray is a direction along which the forces may grow for ever. If M is symmetric and positive
// semidefinite, these forces y move nothing, \f$ My = 0 \f$, and \f$ q^Ty < 0 \f$. Then the sum of
// the gaps with the weights y is negative, whatever the forces are: a Farkas certificate. Small
// entries of y may be rounding, and a proof with them does not hold. The bound below which they are
// is not known, so it grows tenfold until the proof holds.
VectorXd proof(const ScaledProblem& scaled, const VectorXd& direction) {
  for (double small = epsilon; small < 1; small *= 10) {
    const double least = small * direction.maxCoeff();
    std::vector<Index> support =
        by_falling(direction.unaryExpr([=](double x) { return x > least ? x : 0; }));
    if (support.empty()) break;
    const Index pair = support.front();
    support.erase(support.begin());
    VectorXd y = farkas_certificate(scaled, support, pair);
    if (y.size() > 0) return y;
  }
  return {};
}

// The end with a proof, if there is one. For a matrix that is not symmetric nothing is proved: a solution may exist
// that this path does not lead to.
EndOfPivots with_proof(const ScaledProblem& scaled, const VectorXd& direction, EndOfPivots end) {
  if (scaled.symmetric) end.proof = proof(scaled, direction);
  if (end.proof.size() > 0) end.report.status = SolveStatus::Infeasible;
  return end;
}

// Numbers of the basic variables, taken as numbers of their forces. Gaps and \f$ z_0 \f$ of the basis are passed over.
VectorXd of_forces(const Dictionary& dictionary, Index n, const VectorXd& basic) {
  VectorXd all = VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i)
    if (const Index force = dictionary.basic(i) - n; force >= 0 && force < n) all(force) = basic(i);
  return all;
}

}  // namespace

// Rounding may have taken a pair that touches without force into the basis, or one that depends on the others. Then
// as many pairs are closed as are independent, those with the largest forces first.
EndOfPivots last_basis(const ScaledProblem& scaled, const Dictionary& dictionary, Report report) {
  const Index n = scaled.free.size();
  std::vector<Index> active;
  for (Index i = 0; i < n; ++i)
    if (dictionary.basic(i) >= n) active.push_back(dictionary.basic(i) - n);
  std::sort(active.begin(), active.end());
  EndOfPivots end{solve_active_set(scaled, ActiveSet{active}), statuses_of(active, n),
                  std::move(report)};
  end.report.factorisations = active.empty() ? 0 : 1;
  const bool solved = solves(scaled, end.statuses, end.solution);
  end.report.status = solved ? SolveStatus::Solved : SolveStatus::Breakdown;
  if (solved || !scaled.symmetric) return end;
  const bool all = end.solution.solvable && end.solution.rows.size() == active.size();
  const VectorXd force = all ? end.solution.force : of_forces(dictionary, n, dictionary.value());
  if (auto found = confirmed(scaled, by_falling(force))) {
    end.report.status = SolveStatus::Solved;
    std::tie(end.solution, end.statuses) = std::move(*found);
    return end;
  }
  return with_proof(scaled, force, std::move(end));
}

// The forces of the basis grow with the entering variable, which may be a force itself.
EndOfPivots ray(const ScaledProblem& scaled, const Dictionary& dictionary, Index entering,
                Report report) {
  const Index n = scaled.free.size();
  report.status = SolveStatus::Ray;
  VectorXd direction = of_forces(dictionary, n, dictionary.column(entering));
  if (entering >= n) direction(entering - n) = 1;
  return with_proof(scaled, direction, last_point(scaled, dictionary, std::move(report)));
}

// The gaps are those of the forces, without \f$ z_0 \f$.
EndOfPivots last_point(const ScaledProblem& scaled, const Dictionary& dictionary, Report report) {
  const Index n = scaled.free.size();
  EndOfPivots last{{}, {}, std::move(report)};
  last.solution.force = of_forces(dictionary, n, dictionary.value()).cwiseMax(0.0);
  last.solution.movement = scaled.free + scaled.compliance * last.solution.force;
  last.statuses = statuses_of(by_falling(last.solution.force), n);
  return last;
}

}  // namespace signorini
