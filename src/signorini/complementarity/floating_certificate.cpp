#include <algorithm>
#include <cmath>

#include "signorini/complementarity/floating.hpp"
#include "signorini/complementarity/rounding.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Gaps of a state, and for each pair the largest of the three parts that they are made of.
struct Recomputed {
  VectorXd gap;
  VectorXd part;
};

Recomputed recomputed(const FloatingProblem& problem, const FloatingState& state) {
  const Index n = problem.contact.free_gap.size();
  Recomputed result{VectorXd(n), VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    double largest_term = 0;  // terms count one by one: their sum may cancel
    ExactSum rigid;
    ExactSum gap(problem.contact.free_gap(i));
    for (Index j = 0; j < n; ++j) {
      largest_term = std::max(largest_term,
                              std::abs(problem.contact.compliance(i, j) * state.contact.force(j)));
      gap.add_product(problem.contact.compliance(i, j), state.contact.force(j));
    }
    for (Index j = 0; j < state.amplitude.size(); ++j) {
      rigid.add_product(problem.rigid(i, j), state.amplitude(j));
      gap.add_product(problem.rigid(i, j), state.amplitude(j));
    }
    result.gap(i) = gap.value();
    result.part(i) =
        std::max({-problem.contact.free_gap(i), largest_term, std::abs(rigid.value())});
  }
  return result;
}

void check_sizes(const FloatingProblem& problem, const FloatingState& state) {
  const Index n = problem.contact.free_gap.size();
  const Index modes = problem.resultant.size();
  require(problem.rigid.rows() == n && problem.rigid.cols() == modes, "certify: rigid must be ", n,
          " x ", modes, ", got ", problem.rigid.rows(), " x ", problem.rigid.cols());
  require(state.contact.force.size() == n && state.contact.gap.size() == n &&
              state.amplitude.size() == modes,
          "certify: need ", n, " forces and gaps and ", modes, " amplitudes, got ",
          state.contact.force.size(), ", ", state.contact.gap.size(), " and ",
          state.amplitude.size());
}

/// |lambda^T d + lambda^T G lambda + r^T a|, which lambda^T gap is if R^T lambda = r, over the largest
/// energy or `least`.
double duality_gap(const FloatingProblem& problem, const FloatingState& state, const VectorXd& gap,
                   double least) {
  const VectorXd& force = state.contact.force;
  ExactSum energy;
  double energies = least;
  for (Index i = 0; i < force.size(); ++i) {
    energies = std::max(energies, std::abs(force(i) * problem.contact.free_gap(i)));
    energy.add_product(force(i), gap(i));
    for (Index j = 0; j < state.amplitude.size(); ++j)
      energy.add_product(-force(i) * problem.rigid(i, j), state.amplitude(j));
  }
  for (Index j = 0; j < state.amplitude.size(); ++j) {
    energy.add_product(problem.resultant(j), state.amplitude(j));
    energies = std::max(energies, std::abs(problem.resultant(j) * state.amplitude(j)));
  }
  return ratio(std::abs(energy.value()), energies);
}

}  // namespace

double imbalance(const Eigen::MatrixXd& rigid, const VectorXd& resultant, const VectorXd& force) {
  double worst = 0;
  for (Index j = 0; j < resultant.size(); ++j) {
    ExactSum sum(-resultant(j));
    double term = std::abs(resultant(j));
    for (Index i = 0; i < force.size(); ++i) {
      sum.add_product(rigid(i, j), force(i));
      term = std::max(term, std::abs(rigid(i, j) * force(i)));
    }
    worst = std::max(worst, ratio(std::abs(sum.value()), term));
  }
  return worst;
}

Certificate certify(const FloatingProblem& problem, const FloatingState& state) {
  check_problem(problem.contact);
  const Index n = problem.contact.free_gap.size();
  const VectorXd& force = state.contact.force;
  check_sizes(problem, state);
  if (!force.allFinite() || !state.contact.gap.allFinite() || !state.amplitude.allFinite() ||
      !problem.rigid.allFinite() || !problem.resultant.allFinite())
    return uncertified();
  const Recomputed now = recomputed(problem, state);
  const VectorXd scale = problem.contact.compliance.diagonal().unaryExpr(
      [](double g) { return g > 0 ? std::sqrt(g) : 1.0; });
  double length = 0;
  double push = 0;
  for (Index i = 0; i < n; ++i) {
    length = std::max(length, now.part(i) / scale(i));
    push = std::max(push, std::abs(force(i)) * scale(i));
  }
  Certificate certificate;
  certificate.equilibrium = imbalance(problem.rigid, problem.resultant, force);
  for (Index i = 0; i < n; ++i) {
    const double open = now.gap(i) / scale(i);
    const double pressed = force(i) * scale(i);
    const auto raise = [](double& figure, double value) { figure = std::max(figure, value); };
    raise(certificate.penetration, ratio(std::max(0.0, -open), length));
    raise(certificate.tension, ratio(std::max(0.0, -pressed), push));
    raise(certificate.complementarity, ratio(std::abs(open * pressed), length * push));
    raise(certificate.equilibrium, ratio(std::abs(now.gap(i) - state.contact.gap(i)) / scale(i),
                                         std::max(length, std::abs(open))));
  }
  certificate.duality_gap = duality_gap(problem, state, now.gap, length * push);
  return certificate;
}

}  // namespace signorini
