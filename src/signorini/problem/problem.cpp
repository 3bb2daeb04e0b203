// # Contact as algebra
//
// Once a mesh has become matrices, contact is a statement about numbers: gaps \f$ d + F\lambda \f$,
// forces \f$ \lambda \f$, and which of both vanish. problem.hpp states it. This file has what all
// users of such a problem need: words for statuses, the scale of each row, and small helpers.
//
// The scale makes rows comparable that have different units or stiffnesses. A row with the diagonal
// entry 4 has the scale \f$ 1/\sqrt 4 = 0.5 \f$, and behind it the entry is 1, see
// [scaled.cpp](scaled.cpp). A row with the diagonal entry 0 belongs to bodies that no force
// deforms. It has to look elsewhere: first at the rows that it is coupled with, then at rigid
// motions, at last at its own gap.

#include "signorini/problem/problem.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace signorini {

// In the order of the statuses.
const char* to_string(ContactStatus contact_status) {
  constexpr const char* words[] = {"open", "stick", "forward", "backward"};
  static_assert(std::size(words) == static_cast<std::size_t>(ContactStatus::SlipBackward) + 1);
  return words[static_cast<std::size_t>(contact_status)];
}

// Messages and tables print these words. Only the first one may be called a solution.
const char* to_string(SolveStatus status) {
  constexpr const char* words[] = {"solved", "feasible, not optimal", "infeasible",
                                   "ray",    "iteration limit",       "breakdown",
                                   "jump",   "slid too far",          "turned too far"};
  static_assert(std::size(words) == static_cast<std::size_t>(SolveStatus::TurnedTooFar) + 1);
  return words[static_cast<std::size_t>(status)];
}

namespace {

// The scales of rows that no other row is coupled with. Rigid motions come first. Their unit is
// chosen so that each moves the rows with a known scale by at most 1. A row that the motion moves
// three times as far then gets the scale 1/3.
//
// A row that no motion moves has only its own free movement. Its scale makes that as large as the
// largest free movement of the rows with a known scale. If it does not move, any scale will do, and
// it is 1. A scale from the units of the input would not do: the same problem in millimetres would
// take another course.
void scale_apart(const Eigen::MatrixXd& rigid, const Eigen::VectorXd& free,
                 const std::vector<Eigen::Index>& apart, Eigen::VectorXd& scale) {
  const Eigen::VectorXd known = scale;
  const double moved = known.cwiseProduct(free).cwiseAbs().maxCoeff();
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(rigid.cols());
  for (Eigen::Index j = 0; j < rigid.cols(); ++j) {
    const double most = known.cwiseProduct(rigid.col(j)).cwiseAbs().maxCoeff();
    if (most > 0) unit(j) = 1 / most;
  }
  const auto largest_part = [&](Eigen::Index i, const Eigen::VectorXd& of_modes) {
    return rigid.cols() == 0
               ? 0
               : rigid.row(i).transpose().cwiseProduct(of_modes).cwiseAbs().maxCoeff();
  };
  for (const Eigen::Index i : apart) {
    double size = largest_part(i, unit);
    // No row with a scale knows these modes.
    if (size == 0) size = largest_part(i, Eigen::VectorXd::Ones(rigid.cols()));
    if (size == 0) size = std::abs(free(i)) / (moved > 0 ? moved : 1);
    scale(i) = size > 0 ? 1 / size : 1;
  }
}

}  // namespace

// Let F have the entries 4 and 0 on the diagonal and 2 beside it. The first scale is 0.5. The
// second row is coupled with the first one by \f$ 0.5 \cdot 2 = 1 \f$, so its scale is 1. A matrix
// that is symmetric and semidefinite has no such coupling, but methods for linear complementarity
// problems take any matrix. So a negative diagonal entry counts by its magnitude. A coupling among
// rows that both have no diagonal entry scales neither: they keep 1.
Eigen::VectorXd row_scales(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& rigid,
                           const Eigen::VectorXd& free) {
  const Eigen::Index n = matrix.rows();
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(n);  // 0: none yet
  for (Eigen::Index i = 0; i < n; ++i)
    if (matrix(i, i) != 0) scale(i) = 1 / std::sqrt(std::abs(matrix(i, i)));
  const Eigen::VectorXd diagonal = scale;
  // Couplings are measured by rows with a diagonal only, so the order of the rows does not matter.
  std::vector<Eigen::Index> apart;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (diagonal(i) != 0) continue;
    const double coupling =
        std::max(diagonal.cwiseProduct(matrix.col(i)).cwiseAbs().maxCoeff(),
                 diagonal.cwiseProduct(matrix.row(i).transpose()).cwiseAbs().maxCoeff());
    const bool alone = matrix.col(i).isZero(0) && matrix.row(i).isZero(0);
    if (alone) apart.push_back(i);
    if (!alone) scale(i) = coupling > 0 ? 1 / coupling : 1;
  }
  // Rows that nothing couples come last: the rigid motions and movements that scale them are
  // measured by the rows that have a scale already.
  if (apart.empty()) return scale;
  scale_apart(rigid, free, apart, scale);
  return scale;
}

// The common case: all pairs have friction.
FrictionLaw law_of_all(const Eigen::VectorXd& coefficient, const Eigen::VectorXd& cohesion) {
  FrictionLaw law{{}, coefficient, cohesion};
  for (Eigen::Index i = 0; i < coefficient.size(); ++i) law.pair.push_back(i);
  return law;
}

// Rows of gaps come first, then those of slips. All formulas with F use this order. A problem keeps
// the two apart, because without friction the second one is empty, and its gaps alone are what most
// methods ask for.
Eigen::VectorXd free_movement(const ContactProblem& problem) {
  Eigen::VectorXd free(problem.free_gap.size() + problem.free_slip.size());
  free << problem.free_gap, problem.free_slip;
  return free;
}

// A solver that begins again, or a portfolio that tries several, reports the work of all runs.
void append(Report& total, const Report& run) {
  total.status = run.status;
  total.iterations += run.iterations;
  total.factorisations += run.factorisations;
  total.history.insert(total.history.end(), run.history.begin(), run.history.end());
}

}  // namespace signorini
