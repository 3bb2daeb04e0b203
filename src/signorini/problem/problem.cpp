#include "signorini/problem/problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"

namespace signorini {

const char* to_string(Status status) {
  switch (status) {
    case Status::Solved:
      return "solved";
    case Status::Feasible:
      return "feasible, not optimal";
    case Status::Infeasible:
      return "infeasible";
    case Status::Ray:
      return "ray";
    case Status::IterationLimit:
      return "iteration limit";
    case Status::Breakdown:
      return "breakdown";
  }
  return "unknown";
}

namespace {

/// Largest difference from the transpose, in the units of the diagonal.
double asymmetry(const Eigen::MatrixXd& G) {
  const Eigen::VectorXd scale =
      G.diagonal().unaryExpr([](double g) { return g > 0 ? 1 / std::sqrt(g) : 1.0; });
  double largest = 0;
  for (Eigen::Index j = 0; j < G.cols(); ++j)
    for (Eigen::Index i = 0; i < j; ++i)
      largest = std::max(largest, scale(i) * std::abs(G(i, j) - G(j, i)) * scale(j));
  return largest;
}

const double allowed_asymmetry = 1e3 * std::numeric_limits<double>::epsilon();

}  // namespace

void check_finite(const ContactProblem& problem) {
  const Eigen::MatrixXd& G = problem.compliance;
  const Eigen::Index n = problem.free_gap.size();
  require(G.rows() == n && G.cols() == n, "contact problem: compliance must be ", n, " x ", n,
          " (one row per pair), got ", G.rows(), " x ", G.cols());
  require(G.allFinite() && problem.free_gap.allFinite(),
          "contact problem: compliance and free_gap must be finite");
  // Forces are quotients of these numbers and energies products of those: beyond, they would overflow.
  const double largest = 0x1p340;
  const double smallest = 1 / largest;
  const auto fits = [&](double x) {
    return x == 0 || (std::abs(x) >= smallest && std::abs(x) <= largest);
  };
  for (Eigen::Index j = 0; j < n; ++j)
    require(fits(problem.free_gap(j)) && fits(G(j, j)) && G.col(j).cwiseAbs().maxCoeff() <= largest,
            "contact problem: pair ", j + 1,
            " has numbers beyond 1e102 or below 1e-102 in magnitude; "
            "change the units");
}

bool is_symmetric(const ContactProblem& problem) {
  return asymmetry(problem.compliance) <= allowed_asymmetry;
}

void check_problem(const ContactProblem& problem) {
  check_finite(problem);
  const Eigen::MatrixXd& G = problem.compliance;
  if (G.rows() == 0) return;
  require((G.diagonal().array() >= 0).all(),
          "contact problem: compliance must be positive semidefinite, but "
          "has the diagonal entry ",
          G.diagonal().minCoeff());
  const double difference = asymmetry(G);
  require(difference <= allowed_asymmetry,
          "contact problem: compliance must be symmetric, but differs from its transpose by ",
          difference, " of its diagonal");
}

Eigen::VectorXd pair_scales(const Eigen::MatrixXd& M) {
  Eigen::VectorXd scale =
      M.diagonal().unaryExpr([](double m) { return m != 0 ? 1 / std::sqrt(std::abs(m)) : 1; });
  for (Eigen::Index i = 0; i < M.rows(); ++i) {
    if (M(i, i) != 0) continue;
    double coupling = 0;
    for (Eigen::Index j = 0; j < M.rows(); ++j)
      if (M(j, j) != 0)
        coupling = std::max(coupling, scale(j) * std::max(std::abs(M(i, j)), std::abs(M(j, i))));
    if (coupling > 0) scale(i) = 1 / coupling;
  }
  return scale;
}

ContactProblem multiplied_out(const HalfProblem& problem) {
  const Eigen::Index n = problem.free_gap.size();
  require(problem.half.cols() == n, "contact problem: half must have ", n,
          " columns (one per pair), got ", problem.half.cols());
  ContactProblem product{Eigen::MatrixXd::Zero(n, n), problem.free_gap};
  product.compliance.selfadjointView<Eigen::Lower>().rankUpdate(problem.half.transpose());
  product.compliance.triangularView<Eigen::StrictlyUpper>() = product.compliance.transpose();
  return product;
}

}  // namespace signorini
