// How many solutions a problem with friction has, as far as its matrices tell.
#include <algorithm>
#include <cmath>
#include <utility>

#include "addons/certified/proofs.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// 1 - mu |C_ii| / G_ii of pair k of the law; 1 of a body that floats: there G and C depend on what grounds it.
double own_determinant(const ScaledProblem& problem, Index k) {
  const Index pair = problem.law.pair[at(k)];
  const MatrixXd& rigid = problem.rigid;
  const bool floats = rigid.cols() > 0;
  if (floats && !(rigid.row(pair).isZero(0) && rigid.row(problem.pairs() + k).isZero(0))) return 1;
  return 1 - problem.law.coefficient(k) * std::abs(problem.compliance(pair, problem.pairs() + k)) /
                 problem.compliance(pair, pair);
}

/// The warning that a determinant of the wrong sign gives. If the friction of pair i is multiplied by k, column i of the
/// matrix M loses (1 - k) b, and by Cramer's rule its determinant is 1 - (1 - k) (M^-1 b)_i times what it was.
UniquenessWarning warning_of_set(const ScaledProblem& problem, const ActiveSet& set) {
  const std::vector<Index>& rows = set.closed;
  const MatrixXd M = active_set_matrix(problem, rows, set);
  const MatrixXd smooth = active_set_matrix(problem, rows, ActiveSet{rows});
  const LuFactor factor(M);
  UniquenessWarning most;
  double largest_share = 1;
  for (const SlidingPair& pair : set.sliding) {
    const Index column = std::find(rows.begin(), rows.end(), pair.gap) - rows.begin();
    const double share = factor.solve(M.col(column) - smooth.col(column))(column);
    if (share > largest_share) {
      largest_share = share;
      most = {pair.gap, 1 / (1 - share)};
    }
  }
  if (most.pair >= 0) return most;
  const LuFactor plain(smooth);
  const VectorXd ratio = factor.pivots().cwiseQuotient(plain.pivots());
  most.determinant = ratio.prod() * factor.permutation_sign() * plain.permutation_sign();
  return most;
}

/// Whether pairs whose forces are no rounding let no body move rigidly.
bool holds_modes(const ScaledProblem& problem, const ActiveSetSolution& solution) {
  if (problem.inverse.rows() > problem.rigid.cols()) return false;  // a motion that moves no pair
  if (problem.rigid.cols() == 0) return true;
  std::vector<Index> pressed;
  for (Index i = 0; i < problem.pairs(); ++i)
    if (solution.force(i) > solution.force_rounding) pressed.push_back(i);
  if (pressed.empty()) return false;
  const MatrixXd held = problem.rigid(pressed, Eigen::all).transpose();
  return column_span(held).rank == problem.rigid.cols();
}

/// Whether an active-set solution is a solution whose forces or movements are others, beyond rounding.
bool is_another(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses,
                const ActiveSetSolution& other, const ActiveSetSolution& solution) {
  const double known = 1e3 * proof_rounding;  // a thousand roundings of what a proof allows
  const auto differ = [known](const VectorXd& a, const VectorXd& b) {
    return largest(a - b) > known * std::max(largest(a), largest(b));
  };
  return (differ(other.force, solution.force) || differ(other.movement, solution.movement)) &&
         solves(problem, statuses, other);
}

/// Looks for another solution where one pair does something else: the others follow it by predict() while fewer and
/// fewer change.
/// \param[in,out] sets  that may still be closed
bool is_another_with(const ScaledProblem& problem, Index pair, std::vector<ContactStatus> statuses,
                     const ActiveSetSolution& solution, Index& sets) {
  const ContactStatus kept = statuses[at(pair)];
  for (Index last = problem.pairs() + 1; last > 0 && sets > 0; --sets) {
    const ActiveSetSolution now = solve_active_set(problem, statuses);
    if (is_another(problem, statuses, now, solution)) return true;
    Index changes = predict(problem, now, force_scale(problem.compliance), statuses);
    if (std::exchange(statuses[at(pair)], kept) != kept) --changes;
    if (changes >= last) return false;
    last = changes;
  }
  return false;
}

/// Whether another solution was found beside one: a pair whose own determinant is negative does something else there.
/// The most negative one begins.
bool found_another(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses,
                   const ActiveSetSolution& solution, double work) {
  std::vector<std::pair<double, Index>> doubtful;
  for (Index k = 0; k < problem.law.coefficient.size(); ++k)
    if (const double own = own_determinant(problem, k); own < 0)
      doubtful.emplace_back(own, problem.law.pair[at(k)]);
  std::sort(doubtful.begin(), doubtful.end());
  const double most = work / std::pow(static_cast<double>(problem.free.size()), 3);
  Index sets = static_cast<Index>(std::clamp(most, 3.0, 1e6));
  for (const auto& [own, pair] : doubtful)
    for (const ContactStatus contact_status :
         {ContactStatus::Open, ContactStatus::Stick, ContactStatus::SlipForward,
          ContactStatus::SlipBackward}) {
      std::vector<ContactStatus> others = statuses;
      if (std::exchange(others[at(pair)], contact_status) == contact_status) continue;
      if (is_another_with(problem, pair, std::move(others), solution, sets)) return true;
    }
  return false;
}

}  // namespace

// The eigenvalues that say |T| cost most: a bound of it from above may be enough to show that it is, and one from below that
// it is not.
bool excludes_others(const ScaledProblem& problem) {
  const MatrixXd& F = problem.compliance;
  const Index pairs = problem.pairs();
  const Index slips = F.rows() - pairs;
  MatrixXd S = F.topLeftCorner(pairs, pairs);
  if (pairs == 0) return true;
  // Rounding of the entries, which are at most 1, must not decide.
  S.diagonal().array() -= static_cast<double>(pairs) * proof_rounding;
  const auto excludes = [&](double norm) {
    MatrixXd less = S;
    for (Index k = 0; norm > 0 && k < slips; ++k) {
      const Index pair = problem.law.pair[at(k)];
      less(pair, pair) -= 0.25 * norm * std::pow(problem.law.coefficient(k), 2);
    }
    return CholeskyFactor(less).positive();
  };
  if (slips == 0) return excludes(0);
  const MatrixXd T = F.bottomRightCorner(slips, slips);
  const MatrixXd C = F.topRightCorner(pairs, slips);
  const bool coupled = !C.isZero(0);
  const VectorXd answer = T.rowwise().sum();
  const double least = coupled ? answer.dot(T * answer) / answer.squaredNorm() : 0;
  if (!excludes(least)) return false;  // already without what C takes, as with redundant forces
  const CholeskyFactor tangential(T);
  if (!tangential.positive() || !coupled) return tangential.positive();
  S.noalias() -= C * tangential.solve_columns(C.transpose());
  return excludes(T.cwiseAbs().rowwise().sum().maxCoeff()) ||
         (excludes(least) && excludes(symmetric_eigenvalues(T).maxCoeff()));
}

Uniqueness uniqueness(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses,
                      const ActiveSetSolution& solution, double work) {
  const bool floats = problem.rigid.cols() > 0;
  const bool coheres = !problem.law.cohesion.isZero(0);
  if ((solution.reversed && !floats && !coheres) ||
      found_another(problem, statuses, solution, work))
    return Uniqueness::Doubtful;
  const bool excluded = coheres || (floats && !problem.law.coefficient.isZero(0));
  const auto bound = [&] {
    return problem.excludes_others ? *problem.excludes_others : excludes_others(problem);
  };
  const bool only = !excluded && bound() && holds_modes(problem, solution);
  return only ? Uniqueness::Proved : Uniqueness::Unknown;
}

UniquenessWarning uniqueness_warning(const ScaledProblem& problem,
                                     const std::vector<ContactStatus>& statuses,
                                     const ActiveSetSolution& solution) {
  if (solution.reversed) return warning_of_set(problem, active_set(statuses, problem.law));
  UniquenessWarning least;
  for (Index k = 0; k < problem.law.coefficient.size(); ++k)
    if (const double own = own_determinant(problem, k); own < least.determinant)
      least = {problem.law.pair[at(k)], own};
  return least;
}

}  // namespace signorini
