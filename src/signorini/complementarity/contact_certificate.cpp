#include <algorithm>
#include <cmath>

#include "signorini/complementarity/certificate.hpp"
#include "signorini/complementarity/closed_pairs.hpp"
#include "signorini/complementarity/rounding.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Gaps summed anew, and what they, forces and energies are measured by.
struct Recomputed {
  VectorXd gap;
  double length = 0;
  double force = 0;
  double duality_gap = 0;
};

Recomputed recomputed(const ContactProblem& problem, const VectorXd& force, const VectorXd& scale) {
  const Index n = problem.free_gap.size();
  Recomputed now{VectorXd(n)};
  ExactSum gap_energy;
  double energies = 0;
  for (Index i = 0; i < n; ++i) {
    ExactSum moved;
    for (Index j = 0; j < n; ++j) moved.add_product(problem.compliance(i, j), force(j));
    // The length counts overlaps and what forces do in sum, not the gaps of pairs that are far apart.
    now.length =
        std::max({now.length, -problem.free_gap(i) / scale(i), std::abs(moved.value()) / scale(i)});
    now.force = std::max(now.force, std::abs(force(i)) * scale(i));
    moved.add(problem.free_gap(i));
    now.gap(i) = moved.value();
    gap_energy.add_product(force(i), now.gap(i));
    energies += std::abs(force(i) * problem.free_gap(i));
  }
  now.duality_gap = ratio(std::abs(gap_energy.value()), std::max(energies, now.length * now.force));
  return now;
}

}  // namespace

Certificate certify(const ContactProblem& problem, const ContactState& state) {
  const Index n = problem.free_gap.size();
  require(problem.compliance.rows() == n && problem.compliance.cols() == n &&
              state.force.size() == n && state.gap.size() == n,
          "certify: need a square compliance, ", n, " forces and ", n, " gaps, got ",
          problem.compliance.rows(), " x ", problem.compliance.cols(), ", ", state.force.size(),
          " and ", state.gap.size());
  Certificate certificate;
  if (n == 0) return certificate;
  if (!problem.compliance.allFinite() || !problem.free_gap.allFinite() ||
      !state.force.allFinite() || !state.gap.allFinite())
    return uncertified();
  // Pairs are compared after scaling: gap / sqrt(G_ii) and force * sqrt(G_ii) have one unit.
  const VectorXd scale = pair_scales(problem.compliance).cwiseInverse();
  const Recomputed now = recomputed(problem, state.force, scale);
  const auto raise = [](double& figure, double value) { figure = std::max(figure, value); };
  for (Index i = 0; i < n; ++i) {
    const double open = now.gap(i) / scale(i);
    const double push = state.force(i) * scale(i);
    raise(certificate.penetration, ratio(std::max(0.0, -open), now.length));
    raise(certificate.tension, ratio(std::max(0.0, -push), now.force));
    raise(certificate.complementarity, ratio(std::abs(open * push), now.length * now.force));
    raise(certificate.equilibrium, ratio(std::abs(now.gap(i) - state.gap(i)) / scale(i),
                                         std::max(now.length, std::abs(open))));
  }
  certificate.duality_gap = now.duality_gap;
  return certificate;
}

}  // namespace signorini
