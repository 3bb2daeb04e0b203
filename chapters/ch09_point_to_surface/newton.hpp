/// \file
/// Newton's method for the condensed equations, every step whole, to compare it with the uncondensed one.
#pragma once
#include <vector>

#include "signorini/closing/complementarity_functions.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/problem/problem.hpp"

namespace ch09 {

/// What happened on the way.
struct Way {
  Eigen::VectorXd force;
  std::vector<double>
      residuals;  ///< |Phi| at the start and after each step, over that at the start
};

/// phi(d + G lambda, reach lambda) = 0 from no force, where `reach` is the gap that forces 1 on all
/// pairs make. \PaperEq{LinEtAl, 28}
/// \param problem  G and d
/// \return the way until |Phi| is 1e-12 of its start, 60 steps at most
// [condensed]
inline Way condensed_newton(const signorini::ContactProblem& problem) {
  const Eigen::MatrixXd& G = problem.compliance;
  const double reach = G.cwiseAbs().rowwise().sum().maxCoeff();
  Way way{Eigen::VectorXd::Zero(problem.free_gap.size()), {}};
  double first = 0;
  for (int k = 0; k <= 60; ++k) {
    const Eigen::VectorXd gap = problem.free_gap + G * way.force;
    Eigen::VectorXd phi = gap;
    Eigen::MatrixXd J = G;
    for (Eigen::Index i = 0; i < gap.size(); ++i) {
      const auto slope = signorini::fischer_burmeister_slope(gap(i), reach * way.force(i));
      phi(i) = signorini::fischer_burmeister(gap(i), reach * way.force(i));
      J.row(i) *= slope.a;
      J(i, i) += slope.b * reach;
    }
    if (k == 0) first = phi.norm();
    way.residuals.push_back(phi.norm() / first);
    if (way.residuals.back() <= 1e-12) break;
    way.force -= signorini::LuFactor(J).solve(phi);
  }
  return way;
}
// [condensed]

}  // namespace ch09
