#include "signorini/complementarity/friction_split.hpp"

#include <algorithm>
#include <utility>

#include "signorini/complementarity/complementarity_functions.hpp"
#include "signorini/complementarity/friction_descent.hpp"
#include "signorini/complementarity/friction_newton.hpp"
#include "signorini/complementarity/friction_proofs.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What is taken off the diagonal of u+ and u-. An entry of a regular Jacobian loses no digit that a
/// Newton step needs; where both entries vanish, 1e-10 still leaves six digits of their difference.
constexpr double shift = 1e-10;

/// phi(u+, b + tau) = 0, phi(u-, b - tau) = 0, slip = u+ - u-.
class SplitEquations : public FrictionEquations {
 public:
  using FrictionEquations::FrictionEquations;
  [[nodiscard]] Index added() const override { return 2 * pairs(); }
  void start(VectorXd& x) override {
    x.segment(forwards(), pairs()) = movement().tail(pairs()).cwiseMax(0.0);
    x.segment(forwards() + pairs(), pairs()) = (-movement().tail(pairs())).cwiseMax(0.0);
  }

 protected:
  void tangential(const VectorXd& x, VectorXd& residual) override {
    const Index n = pairs();
    for (Index i = 0; i < n; ++i) {
      const Index plus = forwards() + i;
      const double b = bound(x, i);
      residual(n + i) = movement()(n + i) - x(plus) + x(plus + n);  // LinEtAl 19
      residual(plus) = fischer_burmeister(x(plus), b + x(n + i));   // LinEtAl 29
      residual(plus + n) = fischer_burmeister(x(plus + n), b - x(n + i));
    }
  }
  void tangential_slopes(const VectorXd& x, Eigen::MatrixXd& J) override {
    const Index n = pairs();
    for (Index i = 0; i < n; ++i) {
      const Index plus = forwards() + i;
      const Index minus = plus + n;
      const double b = bound(x, i);
      J(n + i, plus) = -1;
      J(n + i, minus) = 1;
      const ComplementaritySlope ahead = fischer_burmeister_slope(x(plus), b + x(n + i));
      J(plus, plus) = ahead.a - shift;
      J(plus, n + i) = ahead.b;
      J(plus, i) = ahead.b * bound_slope(x, i);
      const ComplementaritySlope back = fischer_burmeister_slope(x(minus), b - x(n + i));
      J(minus, minus) = back.a - shift;
      J(minus, n + i) = -back.b;
      J(minus, i) = back.b * bound_slope(x, i);
    }
  }

 private:
  [[nodiscard]] Index forwards() const { return 2 * pairs() + modes(); }
};

}  // namespace

FrictionState friction_split(const FrictionProblem& problem, const SolverOptions& options) {
  const ScaledFriction scaled = equilibrate(problem);
  if (VectorXd way = escape(scaled); way.size() > 0)
    return escaping(problem, scaled, std::move(way));
  FrictionPoint point = friction_start(scaled);
  SplitEquations equations(scaled);
  descend(scaled, equations, options.iteration_limit > 0 ? options.iteration_limit : newton_limit,
          point);
  return finished_state(problem, scaled, std::move(point));
}

}  // namespace signorini
