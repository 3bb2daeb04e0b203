#include "signorini/complementarity/problem.hpp"

#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"

namespace signorini {

const char* to_string(Status status) {
  switch (status) {
    case Status::Solved:
      return "solved";
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

void check_problem(const ContactProblem& problem) {
  const Eigen::MatrixXd& G = problem.compliance;
  const Eigen::Index n = problem.free_gap.size();
  require(G.rows() == n && G.cols() == n, "contact problem: compliance must be ", n, " x ", n,
          " (one row per pair), got ", G.rows(), " x ", G.cols());
  require(G.allFinite() && problem.free_gap.allFinite(),
          "contact problem: compliance and free_gap must be finite");
  if (n == 0) return;
  require((G.diagonal().array() >= 0).all(),
          "contact problem: compliance must be positive semidefinite, but "
          "has the diagonal entry ",
          G.diagonal().minCoeff());
  const Eigen::VectorXd scale =
      G.diagonal().unaryExpr([](double g) { return g > 0 ? 1 / std::sqrt(g) : 1.0; });
  const double asymmetry =
      (scale.asDiagonal() * (G - G.transpose()).eval() * scale.asDiagonal()).cwiseAbs().maxCoeff();
  require(asymmetry <= 1e3 * std::numeric_limits<double>::epsilon(),
          "contact problem: compliance must be symmetric, but differs from its transpose by ",
          asymmetry, " of its diagonal");
}

}  // namespace signorini
