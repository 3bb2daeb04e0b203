#include <cmath>
#include <vector>

#include "exercise.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"

namespace ex1_2 {

using Eigen::Index;

Rest solve_by_trial(const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& load,
                    const Eigen::MatrixXd& A, const Eigen::VectorXd& initial_gap) {
  const Index n_c = initial_gap.size();
  signorini::require_argument(n_c <= largest, "solve_by_trial: accepts at most ", largest,
                              " pairs, got ", n_c);
  // Without contact: u0 and the gaps d it leaves. A unit force on every pair: G.
  const signorini::CholeskyFactor K(stiffness);
  const Eigen::VectorXd u0 = K.solve(load);
  const Eigen::MatrixXd response = K.solve_columns(A.transpose());
  Eigen::MatrixXd G = A * response;
  Eigen::VectorXd d = initial_gap - A * u0;
  // Scaled to a unit diagonal, all gaps and forces have the same unit, whatever the rows of A are.
  const Eigen::VectorXd scale =
      G.diagonal().unaryExpr([](double g) { return g > 0 ? 1 / std::sqrt(g) : 1.0; });
  G = scale.asDiagonal() * G * scale.asDiagonal();
  d = scale.cwiseProduct(d);
  const double rounding = 1e-12;

  for (unsigned set = 0; set < (1U << n_c); ++set) {
    std::vector<Index> closed;
    for (Index i = 0; i < n_c; ++i)
      if ((set >> i & 1U) != 0) closed.push_back(i);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(n_c);
    if (!closed.empty()) {
      const signorini::CholeskyFactor block(G(closed, closed));
      const Eigen::VectorXd overlap = -d(closed);
      if (!block.positive() || block.lower().diagonal().cwiseAbs2().minCoeff() < rounding)
        continue;  // a row repeats others: a smaller set gives the same u
      force(closed) = Eigen::VectorXd(block.solve(overlap));
    }
    const Eigen::VectorXd gap = d + G * force;
    const double size = std::max(d.cwiseAbs().sum(), force.cwiseAbs().sum()) * rounding;
    if ((force.array() >= -size).all() && (gap.array() >= -size).all()) {
      const Eigen::VectorXd contact_force = scale.cwiseProduct(force.cwiseMax(0.0));
      return {u0 - response * contact_force, contact_force};
    }
  }
  throw signorini::ProblemError("solve_by_trial: no set of closed pairs fits; the gaps contradict");
}

}  // namespace ex1_2
