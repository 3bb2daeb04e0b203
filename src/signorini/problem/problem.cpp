#include "signorini/problem/problem.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

const char* to_string(ContactStatus contact_status) {
  switch (contact_status) {
    case ContactStatus::Open:
      return "open";
    case ContactStatus::Stick:
      return "stick";
    case ContactStatus::SlipForward:
      return "forward";
    case ContactStatus::SlipBackward:
      return "backward";
  }
  return "unknown";
}

const char* to_string(SolveStatus status) {
  switch (status) {
    case SolveStatus::Solved:
      return "solved";
    case SolveStatus::Feasible:
      return "feasible, not optimal";
    case SolveStatus::Infeasible:
      return "infeasible";
    case SolveStatus::Ray:
      return "ray";
    case SolveStatus::Jump:
      return "jump";
    case SolveStatus::IterationLimit:
      return "iteration limit";
    case SolveStatus::Breakdown:
      return "breakdown";
    case SolveStatus::SlidTooFar:
      return "slid too far";
  }
  return "unknown";
}

namespace {

/// The scales of rows that no other is coupled with, where those of the others are known: by rigid modes, whose
/// units make them 1 where they move the others most, else by the free movement.
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

Eigen::VectorXd row_scales(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& rigid,
                           const Eigen::VectorXd& free) {
  const Eigen::Index n = matrix.rows();
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(n);  // 0: none yet
  for (Eigen::Index i = 0; i < n; ++i)
    if (matrix(i, i) != 0) scale(i) = 1 / std::sqrt(std::abs(matrix(i, i)));
  const Eigen::VectorXd diagonal = scale;
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
  if (apart.empty()) return scale;
  scale_apart(rigid, free, apart, scale);
  return scale;
}

FrictionLaw law_of_all(const Eigen::VectorXd& coefficient, const Eigen::VectorXd& cohesion) {
  FrictionLaw law{{}, coefficient, cohesion};
  for (Eigen::Index i = 0; i < coefficient.size(); ++i) law.pair.push_back(i);
  return law;
}

Eigen::VectorXd free_movement(const ContactProblem& problem) {
  Eigen::VectorXd free(problem.free_gap.size() + problem.free_slip.size());
  free << problem.free_gap, problem.free_slip;
  return free;
}

Eigen::MatrixXd gram(const Eigen::MatrixXd& half) {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(half.cols(), half.cols());
  product.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose());
  product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
  return product;
}

void append(Report& total, const Report& run) {
  total.status = run.status;
  total.iterations += run.iterations;
  total.factorisations += run.factorisations;
  total.history.insert(total.history.end(), run.history.begin(), run.history.end());
}

}  // namespace signorini
