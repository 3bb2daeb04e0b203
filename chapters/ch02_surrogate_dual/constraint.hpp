// Chapter 2 - the condition eta >= 0 of the dual problem (Xuan & Li 2002, eqs. 23, 24, 26).
#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "signorini/as_printed/surrogate_dual.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"

namespace ch02 {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using signorini::ContactProblem;
using signorini::Random;
using signorini::Results;

/// The largest s seen: with the condition dropped, kept, and replaced by the positive part.
// [constraint]
struct Highest {
  double dropped = 0;   // s with eta of either sign
  double kept = 0;      // s where eta >= 0
  double positive = 0;  // s with the positive part, everywhere
  void look(const ContactProblem& problem, const VectorXd& xi) {
    const double yield = xi.dot(problem.compliance * xi);
    const double eta = -problem.free_gap.dot(xi) / yield;  // (23)
    const double s = 0.5 * eta * eta * yield;              // (24)
    dropped = std::max(dropped, s);
    if (eta >= 0) kept = std::max(kept, s);
    positive = std::max(positive, signorini::surrogate_dual_value(problem, xi));
  }
};
// [constraint]

/// Three pairs that feel each other, with gaps of both signs.
inline ContactProblem random_three(Random& random) {
  Eigen::Matrix3d B;
  Vector3d gap;
  for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
  for (double& entry : gap) entry = random.uniform(-1, 1);
  return {B * B.transpose() + 0.1 * Eigen::Matrix3d::Identity(), gap};
}

/// Two pairs that do not feel each other, the first open by 2, the second overlapping by 1, for figure 2.2;
/// and a thousand random problems.
inline void constraint_on_weights(const std::filesystem::path& out, Results& results) {
  const ContactProblem pairs{Eigen::Matrix2d::Identity(), Vector2d(2, -1)};
  signorini::Table table({"weight", "without_constraint", "positive_part"});
  for (int step = 0; step <= 120; ++step) {
    const Vector2d xi(1 - step / 120.0, step / 120.0);
    Highest here;
    here.look(pairs, xi);
    table.row({xi(1), here.dropped, here.positive});
  }
  signorini::write_file(out / "fig_2_2.csv", table.csv());
  Random random(3);
  int fails = 0;  // (26)
  int differs = 0;
  for (int sample = 0; sample < 1000; ++sample) {
    const ContactProblem problem = random_three(random);
    Highest found;
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; i + j <= 40; ++j)
        found.look(problem, Vector3d(i / 40.0, j / 40.0, (40 - i - j) / 40.0));
    if (std::abs(found.kept - found.positive) > 1e-12 * found.positive)
      throw signorini::NotSolved("the positive part changes the maximum");
    fails += problem.free_gap.maxCoeff() >= 0 ? 1 : 0;
    differs += found.dropped > (1 + 1e-12) * found.kept ? 1 : 0;
  }
  results.add("random_problems", 1000, "-");
  results.add("random_26_fails", fails, "-");
  results.add("random_dropping_raises", differs, "-");
}

}  // namespace ch02
