// # What a problem must be
//
// A solver divides by numbers of the problem and multiplies forces with each other. If one of them
// is not finite, or so large that a product overflows, the solver need not fail: it may return
// nonsense, or never end. So every solver begins with these checks, and a message says what to
// change.
//
// Magnitudes are limited to \f$ 2^{340} \f$, which is 2e102. A product of three such numbers is
// \f$ 2^{1020} \f$, and the largest double is just below \f$ 2^{1024} \f$. Small numbers are
// limited in the same way, because quotients of them are large.

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {
namespace {

// How far G is from its transpose. The difference is measured by \f$ \sqrt{G_{ii}G_{jj}} \f$, which
// no entry of a semidefinite matrix exceeds. So the answer does not change with the units of the
// pairs. With the diagonal entries 4 and 9 and the entries 3 and 3.6 beside them, the difference
// 0.6 is measured by 6, and the answer is 0.1.
double asymmetry(const Eigen::MatrixXd& G) {
  const Eigen::VectorXd scale =
      G.diagonal().unaryExpr([](double g) { return g > 0 ? 1 / std::sqrt(g) : 1.0; });
  double largest = 0;
  for (Eigen::Index j = 0; j < G.cols(); ++j)
    for (Eigen::Index i = 0; i < j; ++i)
      largest = std::max(largest, scale(i) * std::abs(G(i, j) - G(j, i)) * scale(j));
  return largest;
}

// A condensed matrix is symmetric only to rounding, which grows with the number of operations. 1000
// times \f$ \varepsilon \f$ is 2.2e-13.
const double allowed_asymmetry = 1e3 * epsilon;

// 0 is allowed everywhere, because nothing becomes large by it except where it is divided by, and
// that case is treated.
bool within(double number, double most) {
  return number == 0 || (std::abs(number) >= 1 / most && std::abs(number) <= most);
}

// Of F the diagonal has both limits, as the scales of the rows are made of it. Entries beside the
// diagonal may be small: they are added to others, and nothing is divided by them. So may gaps and
// slips beside larger ones: a body that was lifted off and comes to rest slips by less in every step.
void check_magnitudes(const ContactProblem& problem, bool of_matrix) {
  const double most = 0x1p340;
  const Eigen::MatrixXd& F = problem.compliance;
  const Eigen::Index pairs = problem.free_gap.size();
  const double longest = std::max(largest(problem.free_gap), largest(problem.free_slip));
  const bool tiny = longest > 0 && longest < 1 / most;
  for (Eigen::Index j = 0; j < F.cols(); ++j) {
    // Rows of gaps come first, so a row below `pairs` is a gap.
    const Eigen::Index slip = j - pairs;
    const bool gap = slip < 0;
    const double movement = std::abs(gap ? problem.free_gap(j) : problem.free_slip(slip));
    require_argument(movement <= most && !(tiny && movement == longest) &&
                         (!of_matrix ||
                          (within(F(j, j), most) && F.col(j).cwiseAbs().maxCoeff() <= most)) &&
                         (gap || (within(problem.law.coefficient(slip), most) &&
                                  within(problem.law.cohesion(slip), most))),
                     "contact problem: ", gap ? "pair " : "slip ", gap ? j + 1 : slip + 1,
                     " has numbers beyond 1e102 or below 1e-102 in magnitude; change the units");
  }
}

// Rows whose diagonal entry is 0 are scaled by quotients of the entries of modes. Forces are then
// quotients of quotients, and the limit is the square root of the other one, \f$ 2^{170} \f$, which
// is 1.5e51.
void check_magnitudes_of_modes(const ContactProblem& problem) {
  const double most = 0x1p170;
  for (Eigen::Index j = 0; j < problem.resultant.size(); ++j) {
    const auto mode = problem.rigid.col(j);
    bool fits = within(largest(mode), most) && within(problem.resultant(j), most);
    // A row with a diagonal entry has its scale from there, and small entries of it do no harm.
    for (Eigen::Index i = 0; i < mode.size(); ++i)
      fits = fits && (problem.compliance(i, i) != 0 || within(mode(i), most));
    require_argument(
        fits, "contact problem: rigid mode ", j + 1,
        " has numbers beyond 1e51 or below 1e-51 in magnitude; change its amplitude or the units");
  }
}

}  // namespace

// Sizes come first. All later checks would read beyond the end of a vector that is too short.
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

// What all solvers rely on, also those that take any matrix. NaN and infinity are looked for before
// the magnitudes, because the largest of a list with NaN may be any number. A hundred load steps have one matrix,
// of a million numbers for a thousand pairs: the first of them has looked at it, and the others look at what is new.
void check_finite(const ContactProblem& problem, bool of_matrix) {
  check_sizes(problem);
  require_argument(
      (!of_matrix || problem.compliance.allFinite()) && problem.free_gap.allFinite() &&
          problem.free_slip.allFinite() && problem.rigid.allFinite() &&
          problem.resultant.allFinite(),
      "contact problem: compliance, free_gap, free_slip, rigid and resultant must be finite");
  check_magnitudes(problem, of_matrix);
  check_magnitudes_of_modes(problem);
}

// Pairs in increasing order are easy to compare, and no pair can appear twice: it would have two
// friction forces. A negative coefficient would let friction push a pair on, and energy would come
// from nowhere.
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

// Solvers ask this where it decides how they factor, and not to refuse anything.
bool is_symmetric(const ContactProblem& problem) {
  return asymmetry(problem.compliance) <= allowed_asymmetry;
}

// What solvers for symmetric problems rely on besides. A negative diagonal entry means a pair that
// a force closes instead of opening it. Whether F is semidefinite is not tested, as it costs a
// factorisation. A method finds out, and its claim is certified anyway.
void check_problem(const ContactProblem& problem) {
  check_finite(problem);
  const Eigen::MatrixXd& G = problem.compliance;
  // A problem without pairs is right, and it has no least diagonal entry to look at.
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

// A solver without friction would overlook slips and return a solution of another problem. So it
// refuses, and names those that do not. Rigid modes it would overlook too: F alone is then the
// compliance of grounded bodies, and its springs would carry what contact has to carry.
void check_plain(const ContactProblem& problem, const char* solver) {
  require_argument(problem.law.pair.empty() && problem.free_slip.size() == 0, solver,
                   ": takes no friction, but ", problem.free_slip.size(),
                   " pairs rub; primal_dual_active_set, fischer_burmeister and lemke take it");
  require_argument(problem.resultant.size() == 0, solver, ": takes no rigid modes, got ",
                   problem.resultant.size(), "; solve(problem, solver) holds them by springs");
}

}  // namespace signorini
