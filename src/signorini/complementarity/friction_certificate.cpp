#include <algorithm>
#include <cmath>

#include "signorini/complementarity/floating.hpp"
#include "signorini/complementarity/friction.hpp"
#include "signorini/complementarity/rounding.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

void raise(double& figure, double value) { figure = std::max(figure, value); }

/// Gaps and slips of a state, in units of sqrt(F_ii), and the largest term of each.
struct Recomputed {
  VectorXd moved;
  VectorXd part;
};

Recomputed recomputed(const FrictionProblem& problem, const VectorXd& force,
                      const VectorXd& amplitude, const VectorXd& unit) {
  const Index n = problem.free_gap.size();
  Recomputed result{VectorXd(2 * n), VectorXd(2 * n)};
  for (Index i = 0; i < 2 * n; ++i) {
    const double free = i < n ? problem.free_gap(i) : problem.free_slip(i - n);
    // An open gap is no measure: it may be as large as it likes.
    double term = i < n ? std::max(0.0, -free) : std::abs(free);
    ExactSum sum(free);
    ExactSum rigid;
    for (Index j = 0; j < 2 * n; ++j) {
      sum.add_product(problem.compliance(i, j), force(j));
      term = std::max(term, std::abs(problem.compliance(i, j) * force(j)));
    }
    for (Index j = 0; j < amplitude.size(); ++j) {
      sum.add_product(problem.rigid(i, j), amplitude(j));
      rigid.add_product(problem.rigid(i, j), amplitude(j));
    }
    result.moved(i) = sum.value() / unit(i);
    result.part(i) = std::max(term, std::abs(rigid.value())) / unit(i);
  }
  return result;
}

VectorXd stacked(const VectorXd& top, const VectorXd& bottom) {
  VectorXd both(top.size() + bottom.size());
  both << top, bottom;
  return both;
}

void check_sizes(const FrictionProblem& problem, const FrictionState& state) {
  const Index n = problem.free_gap.size();
  require(state.force.size() == n && state.friction.size() == n && state.gap.size() == n &&
              state.slip.size() == n && state.amplitude.size() == problem.resultant.size(),
          "certify: need ", n, " forces, friction forces, gaps and slips and ",
          problem.resultant.size(), " amplitudes, got ", state.force.size(), ", ",
          state.friction.size(), ", ", state.gap.size(), ", ", state.slip.size(), " and ",
          state.amplitude.size());
}

}  // namespace

Certificate certify(const FrictionProblem& problem, const FrictionState& state) {
  check_problem(problem);
  const Index n = problem.free_gap.size();
  check_sizes(problem, state);
  const VectorXd force = stacked(state.force, state.friction);
  const VectorXd claimed = stacked(state.gap, state.slip);
  if (!force.allFinite() || !claimed.allFinite() || !state.amplitude.allFinite())
    return uncertified();
  const VectorXd unit =
      problem.compliance.diagonal().unaryExpr([](double f) { return f > 0 ? std::sqrt(f) : 1.0; });
  const Recomputed now = recomputed(problem, force, state.amplitude, unit);
  const VectorXd pushed = force.cwiseProduct(unit);
  const double length = n == 0 ? 0 : now.part.maxCoeff();
  const double push = n == 0 ? 0 : pushed.cwiseAbs().maxCoeff();

  Certificate certificate;
  certificate.equilibrium = imbalance(problem.rigid, problem.resultant, force);
  for (Index i = 0; i < 2 * n; ++i)
    raise(certificate.equilibrium, ratio(std::abs(now.moved(i) - claimed(i) / unit(i)),
                                         std::max(length, std::abs(now.moved(i)))));
  for (Index i = 0; i < n; ++i) {
    const double open = now.moved(i);
    const double slip = now.moved(n + i);
    raise(certificate.penetration, ratio(std::max(0.0, -open), length));
    raise(certificate.tension, ratio(std::max(0.0, -pushed(i)), push));
    raise(certificate.complementarity, ratio(std::abs(open * pushed(i)), length * push));
    const double normal = problem.coefficient(i) * std::max(0.0, state.force(i)) * unit(n + i);
    const FrictionViolation violation = friction_violation(
        normal, problem.cohesion(i) * unit(n + i), pushed(n + i), open, slip, length, push);
    raise(certificate.cone, violation.cone);
    raise(certificate.sliding, violation.sliding);
  }
  return certificate;
}

}  // namespace signorini
