#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {
namespace {

/// Largest difference from the transpose, in the units of the diagonal.
double asymmetry(const Eigen::MatrixXd& G) {
  const Eigen::VectorXd scale =
      G.diagonal().unaryExpr([](double g) { return g > 0 ? 1 / std::sqrt(g) : 1.0; });
  double largest = 0;
  for (Eigen::Index j = 0; j < G.cols(); ++j)
    for (Eigen::Index i = 0; i < j; ++i)
      largest = std::max(largest, scale(i) * std::abs(G(i, j) - G(j, i)) * scale(j));
  return largest;
}

const double allowed_asymmetry = 1e3 * epsilon;

void check_sizes(const ContactProblem& problem) {
  const Eigen::MatrixXd& F = problem.compliance;
  const Eigen::Index pairs = problem.free_gap.size();
  const Eigen::Index slips = problem.free_slip.size();
  const Eigen::Index n = pairs + slips;
  const Eigen::Index modes = problem.resultant.size();
  require_argument(F.rows() == n && F.cols() == n, "contact problem: compliance must be ", n, " x ",
                   n, " (one row per gap, then one per slip), got ", F.rows(), " x ", F.cols());
  check_law(problem.law, pairs, slips);
  require_argument(problem.rigid.cols() == modes && (modes == 0 || problem.rigid.rows() == n),
                   "contact problem: rigid must be ", n, " x ", modes,
                   " (one row per gap and slip, one column per entry of resultant), got ",
                   problem.rigid.rows(), " x ", problem.rigid.cols());
}

/// Whether a number is 0, or from 1/most to most in magnitude.
bool within(double number, double most) {
  return number == 0 || (std::abs(number) >= 1 / most && std::abs(number) <= most);
}

/// Forces are quotients of these numbers, and energies products of forces: beyond, they would overflow.
void check_magnitudes(const ContactProblem& problem) {
  const double most = 0x1p340;
  const Eigen::MatrixXd& F = problem.compliance;
  const Eigen::Index pairs = problem.free_gap.size();
  for (Eigen::Index j = 0; j < F.cols(); ++j) {
    const Eigen::Index slip = j - pairs;
    const bool gap = slip < 0;
    require_argument(within(gap ? problem.free_gap(j) : problem.free_slip(slip), most) &&
                         within(F(j, j), most) && F.col(j).cwiseAbs().maxCoeff() <= most &&
                         (gap || (within(problem.law.coefficient(slip), most) &&
                                  within(problem.law.cohesion(slip), most))),
                     "contact problem: ", gap ? "pair " : "slip ", gap ? j + 1 : slip + 1,
                     " has numbers beyond 1e102 or below 1e-102 in magnitude; change the units");
  }
}

/// The quotients of a mode's entries that scale rows (where F_ii = 0) are forces, too.
void check_magnitudes_of_modes(const ContactProblem& problem) {
  const double most = 0x1p170;
  for (Eigen::Index j = 0; j < problem.resultant.size(); ++j) {
    const auto mode = problem.rigid.col(j);
    bool fits = within(largest(mode), most) && within(problem.resultant(j), most);
    for (Eigen::Index i = 0; i < mode.size(); ++i)
      fits = fits && (problem.compliance(i, i) != 0 || within(mode(i), most));
    require_argument(
        fits, "contact problem: rigid mode ", j + 1,
        " has numbers beyond 1e51 or below 1e-51 in magnitude; change its amplitude or the units");
  }
}

}  // namespace

void check_finite(const ContactProblem& problem) {
  check_sizes(problem);
  require_argument(
      problem.compliance.allFinite() && problem.free_gap.allFinite() &&
          problem.free_slip.allFinite() && problem.rigid.allFinite() &&
          problem.resultant.allFinite(),
      "contact problem: compliance, free_gap, free_slip, rigid and resultant must be finite");
  check_magnitudes(problem);
  check_magnitudes_of_modes(problem);
}

void check_law(const FrictionLaw& law, Eigen::Index pairs, Eigen::Index slips) {
  require_argument(static_cast<Eigen::Index>(law.pair.size()) == slips &&
                       law.coefficient.size() == slips && law.cohesion.size() == slips &&
                       slips <= pairs,
                   "friction: need a pair, a coefficient and a cohesion for each of ", slips,
                   " slips of ", pairs, " pairs, got ", law.pair.size(), ", ",
                   law.coefficient.size(), " and ", law.cohesion.size());
  Eigen::Index last = -1;
  for (Eigen::Index k = 0; k < slips; ++k) {
    const Eigen::Index pair = law.pair[static_cast<std::size_t>(k)];
    require_argument(pair > last && pair < pairs,
                     "friction: pairs must be in increasing order and below ", pairs, ", got ",
                     pair, " after ", last);
    require_argument(law.coefficient(k) >= 0 && law.cohesion(k) >= 0 &&
                         std::isfinite(law.coefficient(k)) && std::isfinite(law.cohesion(k)),
                     "friction: pair ", pair + 1, " has the coefficient ", law.coefficient(k),
                     " and the cohesion ", law.cohesion(k), "; both must be finite and >= 0");
    last = pair;
  }
}

bool is_symmetric(const ContactProblem& problem) {
  return asymmetry(problem.compliance) <= allowed_asymmetry;
}

void check_problem(const ContactProblem& problem) {
  check_finite(problem);
  const Eigen::MatrixXd& G = problem.compliance;
  if (G.rows() == 0) return;
  require_argument((G.diagonal().array() >= 0).all(),
                   "contact problem: compliance must be positive semidefinite, but "
                   "has the diagonal entry ",
                   G.diagonal().minCoeff());
  const double difference = asymmetry(G);
  require_argument(
      difference <= allowed_asymmetry,
      "contact problem: compliance must be symmetric, but differs from its transpose by ",
      difference, " of its diagonal");
}

void check_plain(const ContactProblem& problem, const char* solver) {
  require_argument(problem.law.pair.empty() && problem.free_slip.size() == 0, solver,
                   ": takes no friction, but ", problem.free_slip.size(),
                   " pairs rub; primal_dual_active_set, fischer_burmeister and lemke take it");
  require_argument(problem.resultant.size() == 0, solver, ": takes no rigid modes, got ",
                   problem.resultant.size(), "; solve(problem, solver) holds them by springs");
}

}  // namespace signorini
