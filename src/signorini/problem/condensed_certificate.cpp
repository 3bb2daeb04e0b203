#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/exact_sum.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Movements summed anew, and what they, forces and energies are measured by, scaled to one unit.
struct Recomputed {
  VectorXd movement;
  double length = 0;
  double force = 0;
};

/// What a mode can do per unit of force, at most, scaled.
double lever(const ProblemBlocks& problem, Index mode, const VectorXd& unit) {
  return largest(problem.rigid.col(mode).cwiseQuotient(unit));
}

/// The length counts overlaps, given slips, and what forces and rigid motions do in sum. Neither the gaps
/// of pairs that are far apart count nor terms that cancel. With rigid modes, whose load fixes the size of
/// forces, all may cancel and nothing move but by rounding: then the terms are all there is to measure by, but no
/// more than forces of that size make.
Recomputed recomputed(const ProblemBlocks& problem, const Claim& claim, const VectorXd& unit) {
  const VectorXd& free = problem.free;
  const Index pairs = free.size() - static_cast<Index>(problem.law.pair.size());
  Recomputed now{VectorXd(free.size())};
  std::vector<ExactSum> pushed(static_cast<std::size_t>(free.size()));
  double term = 0;
  for (Index j = 0; j < claim.force.size(); ++j) {
    if (claim.force(j) == 0) continue;
    for (Index i = 0; i < free.size(); ++i) {
      if (problem.compliance(i, j) == 0) continue;
      pushed[static_cast<std::size_t>(i)].add_product(problem.compliance(i, j), claim.force(j));
      term = std::max(term, std::abs(problem.compliance(i, j) * claim.force(j)) / unit(i));
    }
  }
  for (Index i = 0; i < free.size(); ++i) {
    ExactSum& moved = pushed[static_cast<std::size_t>(i)];
    ExactSum rigid;
    for (Index j = 0; j < claim.amplitude.size(); ++j)
      rigid.add_product(problem.rigid(i, j), claim.amplitude(j));
    const double given = i < pairs ? -free(i) : std::abs(free(i));
    now.length = std::max({now.length, given / unit(i), std::abs(moved.value()) / unit(i),
                           std::abs(rigid.value()) / unit(i)});
    now.force = std::max(now.force, std::abs(claim.force(i)) * unit(i));
    moved.add(rigid.high());
    moved.add(rigid.low());
    moved.add(free(i));
    now.movement(i) = moved.value();
  }
  const double rounding = static_cast<double>(claim.force.size()) * epsilon * term;
  double load = 0;  // forces that it fixes; one on a row of F alone moves it by as much, scaled
  for (Index j = 0; j < problem.resultant.size(); ++j)
    load = std::max(load, ratio(std::abs(problem.resultant(j)), lever(problem, j, unit)));
  if (now.length <= rounding) now.length = std::max(now.length, std::min(term, load));
  return now;
}

/// How far forces are from balance: the largest entry of R^T f - r, each over r or what the largest force could
/// add to it. A pair on the axis of a rotation has no part in it, and forces elsewhere may all but vanish.
double imbalance(const ProblemBlocks& problem, const VectorXd& force, const VectorXd& unit,
                 double largest_force) {
  double worst = 0;
  for (Index j = 0; j < problem.resultant.size(); ++j) {
    ExactSum sum(-problem.resultant(j));
    for (Index i = 0; i < force.size(); ++i) sum.add_product(problem.rigid(i, j), force(i));
    const double size =
        std::max(std::abs(problem.resultant(j)), lever(problem, j, unit) * largest_force);
    worst = std::max(worst, ratio(std::abs(sum.value()), size));
  }
  return worst;
}

/// |f^T d + f^T F f + r^T a|, which f^T movement is if R^T f = r, over the size of the energies, or `least`.
double duality_gap(const ProblemBlocks& problem, const Claim& claim, const VectorXd& movement,
                   double least) {
  ExactSum energy;
  double energies = 0;
  for (Index i = 0; i < claim.force.size(); ++i) {
    energy.add_product(claim.force(i), movement(i));
    energies += std::abs(claim.force(i) * problem.free(i));
    for (Index j = 0; j < claim.amplitude.size(); ++j)
      energy.add_product(-claim.force(i) * problem.rigid(i, j), claim.amplitude(j));
  }
  for (Index j = 0; j < claim.amplitude.size(); ++j) {
    energy.add_product(problem.resultant(j), claim.amplitude(j));
    energies += std::abs(problem.resultant(j) * claim.amplitude(j));
  }
  return ratio(std::abs(energy.value()), std::max(energies, least));
}

Certificate figures(const ProblemBlocks& problem, const Claim& claim) {
  // Rows are compared after scaling: movement / sqrt(F_ii) and force * sqrt(F_ii) have one unit.
  const VectorXd unit = row_scales(problem.compliance, problem.rigid, problem.free).cwiseInverse();
  const Recomputed now = recomputed(problem, claim, unit);
  Certificate certificate =
      pair_figures({claim.force, now.movement, unit, now.force, now.length}, problem.law);
  certificate.equilibrium = imbalance(problem, claim.force, unit, now.force);
  for (Index i = 0; i < claim.force.size(); ++i)
    certificate.equilibrium = std::max(
        certificate.equilibrium, ratio(std::abs(now.movement(i) - claim.movement(i)) / unit(i),
                                       std::max(now.length, std::abs(now.movement(i) / unit(i)))));
  if (problem.law.pair.empty())
    certificate.duality_gap = duality_gap(problem, claim, now.movement, now.length * now.force);
  return certificate;
}

/// A^T y for the first rows of A.
VectorXd combined(const MatrixXd& A, const VectorXd& y) {
  ExactVector sums(VectorXd::Zero(A.cols()));
  sums.add_products(A, y);
  return sums.value();
}

VectorXd stacked(const VectorXd& top, const VectorXd& bottom) {
  VectorXd both(top.size() + bottom.size());
  both << top, bottom;
  return both;
}

}  // namespace

Certificate certify(const ProblemBlocks& problem, const Claim& claim) {
  const Index rows = problem.free.size();
  const Index modes = problem.resultant.size();
  const Index slips = static_cast<Index>(problem.law.pair.size());
  check_law(problem.law, rows - slips, slips);
  require_argument(problem.compliance.rows() == rows && problem.compliance.cols() == rows,
                   "certify: compliance must be ", rows, " x ", rows, ", got ",
                   problem.compliance.rows(), " x ", problem.compliance.cols());
  require_argument(problem.rigid.cols() == modes && (modes == 0 || problem.rigid.rows() == rows),
                   "certify: rigid must be ", rows, " x ", modes, ", got ", problem.rigid.rows(),
                   " x ", problem.rigid.cols());
  require_argument(claim.force.size() == rows && claim.movement.size() == rows &&
                       claim.amplitude.size() == modes,
                   "certify: need ", rows, " forces and movements and ", modes, " amplitudes, got ",
                   claim.force.size(), ", ", claim.movement.size(), " and ",
                   claim.amplitude.size());
  if (!problem.compliance.allFinite() || !problem.free.allFinite() || !problem.rigid.allFinite() ||
      !problem.resultant.allFinite() || !claim.force.allFinite() || !claim.movement.allFinite() ||
      !claim.amplitude.allFinite())
    return uncertified();
  return figures(problem, claim);
}

Certificate certify(const ContactProblem& problem, const ContactState& state) {
  const Index pairs = problem.free_gap.size();
  const Index slips = problem.free_slip.size();
  check_law(problem.law, pairs, slips);
  require_argument(state.force.size() == pairs && state.gap.size() == pairs &&
                       state.friction.size() == slips && state.slip.size() == slips,
                   "certify: need ", pairs, " forces and gaps and ", slips,
                   " friction forces and slips, got ", state.force.size(), ", ", state.gap.size(),
                   ", ", state.friction.size(), " and ", state.slip.size());
  return certify(
      ProblemBlocks{problem.compliance, free_movement(problem), problem.law, problem.rigid,
                    problem.resultant},
      Claim{stacked(state.force, state.friction), stacked(state.gap, state.slip), state.amplitude});
}

bool verify_farkas(const ContactProblem& problem, const VectorXd& y) {
  const VectorXd& d = problem.free_gap;
  if (y.size() != d.size() || y.size() == 0 || !y.allFinite() || (y.array() < 0).any())
    return false;
  ExactSum overlap;
  for (Index i = 0; i < y.size(); ++i) overlap.add_product(-d(i), y(i));
  const double lost = static_cast<double>(y.size()) * proof_rounding * d.cwiseAbs().dot(y);
  if (!(overlap.value() > lost)) return false;
  const VectorXd scale = row_scales(problem.compliance, problem.rigid, free_movement(problem));
  const VectorXd scaled = y.cwiseQuotient(scale.head(y.size()));
  if (problem.rigid.cols() > 0) {
    const VectorXd terms = problem.rigid.topRows(y.size()).cwiseAbs().transpose() * y;
    const VectorXd moved = combined(problem.rigid, y).cwiseAbs();
    if ((moved.array() > proof_rounding * terms.array()).any()) return false;
  }
  const double deepest = -d.cwiseProduct(scale.head(y.size())).minCoeff();
  VectorXd moved = combined(problem.compliance, y).cwiseProduct(scale);
  // Friction pushes either way, contact only one; but what is symmetric is semidefinite, to rounding.
  const Index signless = is_symmetric(problem) ? moved.size() : moved.size() - y.size();
  moved.tail(signless) = moved.tail(signless).cwiseAbs();
  const double most = std::max(0.0, moved.maxCoeff());
  return most <= proof_rounding * scaled.sum() &&
         most * deepest < overlap.value() * std::sqrt(epsilon);
}

}  // namespace signorini
