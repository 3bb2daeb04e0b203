/// \file
/// Complementarity functions side by side, and Newton's method with any of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/problem/complementarity_functions.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// A function that is zero exactly where a >= 0, b >= 0 and a b = 0, here negative where both are
/// positive. \PaperEq{LinEtAl, 12}
struct ComplementarityFunction {
  const char* name;
  double (*value)(double a, double b);
  ComplementaritySlope (*slope)(double a, double b);  ///< at a kink: an element in between
};

// [functions]
inline double least(double a, double b) { return -std::min(a, b); }
inline ComplementaritySlope least_slope(double a, double b) {
  if (a == b) return {-0.5, -0.5};
  return a < b ? ComplementaritySlope{-1, 0} : ComplementaritySlope{0, -1};
}

inline double between(double a, double b) { return std::sqrt(a * a - a * b + b * b) - a - b; }
inline ComplementaritySlope between_slope(double a, double b) {
  const double root = std::sqrt(a * a - a * b + b * b);
  if (root == 0) return {-0.5, -0.5};
  return {(a - b / 2) / root - 1, (b - a / 2) / root - 1};
}

inline double penalised(double a, double b) {
  return 0.5 * fischer_burmeister(a, b) - 0.5 * std::max(a, 0.0) * std::max(b, 0.0);
}
inline ComplementaritySlope penalised_slope(double a, double b) {
  const ComplementaritySlope slope = fischer_burmeister_slope(a, b);
  const bool both = a > 0 && b > 0;
  return {0.5 * slope.a - (both ? 0.5 * b : 0), 0.5 * slope.b - (both ? 0.5 * a : 0)};
}

inline double smooth(double a, double b) {
  return (a - b) * (a - b) - a * std::abs(a) - b * std::abs(b);
}
inline ComplementaritySlope smooth_slope(double a, double b) {
  return {2 * (a - b) - 2 * std::abs(a), 2 * (b - a) - 2 * std::abs(b)};
}
// [functions]

inline const std::vector<ComplementarityFunction> functions = {
    {"Fischer-Burmeister", fischer_burmeister, fischer_burmeister_slope},
    {"minimum", least, least_slope},
    {"between the two", between, between_slope},
    {"penalised", penalised, penalised_slope},
    {"smooth", smooth, smooth_slope}};

/// How a run of Newton's method went.
struct NewtonRun {
  std::vector<Eigen::VectorXd> forces;  ///< of every iterate, the start first
  std::vector<double> residuals;        ///< largest |Phi_i| there
  bool ended = false;                   ///< by its test, not by the limit
  [[nodiscard]] std::size_t steps() const { return forces.size() - 1; }
};

/// When to stop: |Phi| at most `enough`, or at most `part` of the first one.
struct Until {
  double enough = 0;
  double part = 0;
};

/// Newton's method with full steps for phi(gap_i, force_scale * force_i) = 0.
/// \param problem  G and d
/// \param phi      any of the functions
/// \param force    where it starts
/// \param until    when it ends
/// \param force_scale    what a unit of force counts as [length/force]; 1 takes the numbers as they are
/// \return all iterates, 60 steps at most
inline NewtonRun newton(const ContactProblem& problem, const ComplementarityFunction& phi,
                        Eigen::VectorXd force, const Until& until, double force_scale = 1) {
  NewtonRun run;
  for (int k = 0; k <= 60; ++k) {
    const Eigen::VectorXd gap = problem.free_gap + problem.compliance * force;
    Eigen::VectorXd residual = gap;
    Eigen::MatrixXd J = problem.compliance;
    for (Eigen::Index i = 0; i < force.size(); ++i) {
      const ComplementaritySlope slope = phi.slope(gap(i), force_scale * force(i));
      residual(i) = phi.value(gap(i), force_scale * force(i));
      J.row(i) *= slope.a;
      J(i, i) += slope.b * force_scale;
    }
    run.forces.push_back(force);
    run.residuals.push_back(residual.cwiseAbs().maxCoeff());
    run.ended = run.residuals.back() <= until.enough + until.part * run.residuals.front();
    if (run.ended) break;
    force -= LuFactor(J).solve(residual);
  }
  return run;
}

}  // namespace signorini
