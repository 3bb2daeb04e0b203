#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/floating.hpp"
#include "signorini/problem/friction.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Every condensed problem: movement = free + F f + R a, R^T f = r. What it has not is empty.
struct Rows {
  const MatrixXd& compliance;
  VectorXd free;
  MatrixXd rigid = {};
  VectorXd resultant = {};
  VectorXd coefficient = {};  // of the pairs whose slips are the last rows: of all, or of none
  VectorXd cohesion = {};
};

struct Claim {
  VectorXd force;
  VectorXd movement;
  VectorXd amplitude = {};
};

/// Movements summed anew, and what they, forces and energies are measured by, scaled to one unit.
struct Recomputed {
  VectorXd movement;
  double length = 0;
  double force = 0;
};

/// The length counts overlaps, given slips, and what forces and rigid motions do in sum. Neither the gaps
/// of pairs that are far apart count nor terms that cancel. With rigid modes, whose load fixes the size of
/// forces, all may cancel and nothing move but by rounding: then the terms are all there is to measure by.
Recomputed recomputed(const Rows& rows, const Claim& claim, Index pairs, const VectorXd& unit) {
  Recomputed now{VectorXd(rows.free.size())};
  double term = 0;
  for (Index i = 0; i < rows.free.size(); ++i) {
    ExactSum moved;
    ExactSum rigid;
    for (Index j = 0; j < claim.force.size(); ++j) {
      moved.add_product(rows.compliance(i, j), claim.force(j));
      term = std::max(term, std::abs(rows.compliance(i, j) * claim.force(j)) / unit(i));
    }
    for (Index j = 0; j < claim.amplitude.size(); ++j)
      rigid.add_product(rows.rigid(i, j), claim.amplitude(j));
    const double given = i < pairs ? -rows.free(i) : std::abs(rows.free(i));
    now.length = std::max({now.length, given / unit(i), std::abs(moved.value()) / unit(i),
                           std::abs(rigid.value()) / unit(i)});
    now.force = std::max(now.force, std::abs(claim.force(i)) * unit(i));
    moved.add(rigid.high());
    moved.add(rigid.low());
    moved.add(rows.free(i));
    now.movement(i) = moved.value();
  }
  const double rounding = static_cast<double>(claim.force.size()) * epsilon * term;
  if (rows.resultant.size() > 0 && now.length <= rounding) now.length = term;
  return now;
}

/// How far forces are from balance: the largest entry of R^T f - r, each over the largest of its terms.
double imbalance(const Rows& rows, const VectorXd& force) {
  double worst = 0;
  for (Index j = 0; j < rows.resultant.size(); ++j) {
    ExactSum sum(-rows.resultant(j));
    double term = std::abs(rows.resultant(j));
    for (Index i = 0; i < force.size(); ++i) {
      sum.add_product(rows.rigid(i, j), force(i));
      term = std::max(term, std::abs(rows.rigid(i, j) * force(i)));
    }
    worst = std::max(worst, ratio(std::abs(sum.value()), term));
  }
  return worst;
}

/// |f^T d + f^T F f + r^T a|, which f^T movement is if R^T f = r, over the size of the energies, or `least`.
double duality_gap(const Rows& rows, const Claim& claim, const VectorXd& movement, double least) {
  ExactSum energy;
  double energies = 0;
  for (Index i = 0; i < claim.force.size(); ++i) {
    energy.add_product(claim.force(i), movement(i));
    energies += std::abs(claim.force(i) * rows.free(i));
    for (Index j = 0; j < claim.amplitude.size(); ++j)
      energy.add_product(-claim.force(i) * rows.rigid(i, j), claim.amplitude(j));
  }
  for (Index j = 0; j < claim.amplitude.size(); ++j) {
    energy.add_product(rows.resultant(j), claim.amplitude(j));
    energies += std::abs(rows.resultant(j) * claim.amplitude(j));
  }
  return ratio(std::abs(energy.value()), std::max(energies, least));
}

Certificate figures(const Rows& rows, const Claim& claim) {
  const Index slips = rows.coefficient.size();
  const Index pairs = rows.free.size() - slips;
  if (!rows.compliance.allFinite() || !rows.free.allFinite() || !rows.rigid.allFinite() ||
      !rows.resultant.allFinite() || !claim.force.allFinite() || !claim.movement.allFinite() ||
      !claim.amplitude.allFinite())
    return uncertified();
  // Rows are compared after scaling: movement / sqrt(F_ii) and force * sqrt(F_ii) have one unit.
  const VectorXd unit = pair_scales(rows.compliance).cwiseInverse();
  const Recomputed now = recomputed(rows, claim, pairs, unit);
  const auto raise = [](double& figure, double value) { figure = std::max(figure, value); };
  Certificate certificate;
  certificate.equilibrium = imbalance(rows, claim.force);
  for (Index i = 0; i < rows.free.size(); ++i) {
    const double moved = now.movement(i) / unit(i);
    raise(certificate.equilibrium, ratio(std::abs(now.movement(i) - claim.movement(i)) / unit(i),
                                         std::max(now.length, std::abs(moved))));
    if (i >= pairs) continue;
    const double push = claim.force(i) * unit(i);
    raise(certificate.penetration, ratio(std::max(0.0, -moved), now.length));
    raise(certificate.tension, ratio(std::max(0.0, -push), now.force));
    raise(certificate.complementarity, ratio(std::abs(moved * push), now.length * now.force));
  }
  for (Index i = 0; i < slips; ++i) {
    const Index slip = pairs + i;
    const double normal = rows.coefficient(i) * std::max(0.0, claim.force(i)) * unit(slip);
    const FrictionViolation violation = friction_violation(
        normal, rows.cohesion(i) * unit(slip), claim.force(slip) * unit(slip),
        now.movement(i) / unit(i), now.movement(slip) / unit(slip), now.length, now.force);
    raise(certificate.cone, violation.cone);
    raise(certificate.sliding, violation.sliding);
  }
  if (slips == 0)
    certificate.duality_gap = duality_gap(rows, claim, now.movement, now.length * now.force);
  return certificate;
}

VectorXd stacked(const VectorXd& top, const VectorXd& bottom) {
  VectorXd both(top.size() + bottom.size());
  both << top, bottom;
  return both;
}

}  // namespace

Certificate certify(const ContactProblem& problem, const ContactState& state) {
  const Index n = problem.free_gap.size();
  require(problem.compliance.rows() == n && problem.compliance.cols() == n &&
              state.force.size() == n && state.gap.size() == n,
          "certify: need a square compliance, ", n, " forces and ", n, " gaps, got ",
          problem.compliance.rows(), " x ", problem.compliance.cols(), ", ", state.force.size(),
          " and ", state.gap.size());
  return figures({problem.compliance, problem.free_gap}, {state.force, state.gap});
}

Certificate certify(const FloatingProblem& problem, const FloatingState& state) {
  check_problem(problem.contact);
  const Index n = problem.contact.free_gap.size();
  const Index modes = problem.resultant.size();
  require(problem.rigid.rows() == n && problem.rigid.cols() == modes, "certify: rigid must be ", n,
          " x ", modes, ", got ", problem.rigid.rows(), " x ", problem.rigid.cols());
  require(state.contact.force.size() == n && state.contact.gap.size() == n &&
              state.amplitude.size() == modes,
          "certify: need ", n, " forces and gaps and ", modes, " amplitudes, got ",
          state.contact.force.size(), ", ", state.contact.gap.size(), " and ",
          state.amplitude.size());
  return figures(
      {problem.contact.compliance, problem.contact.free_gap, problem.rigid, problem.resultant},
      {state.contact.force, state.contact.gap, state.amplitude});
}

Certificate certify(const FrictionProblem& problem, const FrictionState& state) {
  check_problem(problem);
  const Index n = problem.free_gap.size();
  require(state.force.size() == n && state.friction.size() == n && state.gap.size() == n &&
              state.slip.size() == n && state.amplitude.size() == problem.resultant.size(),
          "certify: need ", n, " forces, friction forces, gaps and slips and ",
          problem.resultant.size(), " amplitudes, got ", state.force.size(), ", ",
          state.friction.size(), ", ", state.gap.size(), ", ", state.slip.size(), " and ",
          state.amplitude.size());
  return figures(
      {problem.compliance, stacked(problem.free_gap, problem.free_slip), problem.rigid,
       problem.resultant, problem.coefficient, problem.cohesion},
      {stacked(state.force, state.friction), stacked(state.gap, state.slip), state.amplitude});
}

}  // namespace signorini
