// # Friction as a linear complementarity problem
//
// Friction acts both ways, and complementarity knows one sign only. So the friction force and the
// slip of a pair are split. With the bound \f$ b = \mu\lambda + c \f$ and slip = \f$ v^+ - v^- \f$
// the law of Coulomb is two conditions,
// \f[ 0 \le v^+ \perp b + \tau \ge 0, \qquad 0 \le v^- \perp b - \tau \ge 0. \f]
// \f$ \perp \f$ says that the product is zero. A pair that slides forwards has \f$ v^+ > 0 \f$ and
// \f$ \tau = -b \f$; one that sticks has both parts zero and a force between the bounds. With
// \f$ p = b + \tau \f$ as an unknown in place of \f$ \tau \f$, the problem for
// \f$ z = (\lambda, p, v^-) \f$ is \f$ w = Mz + q \f$ with gaps, parts \f$ v^+ \f$ and
// \f$ b - \tau \f$ as w. Klarbring (1986) solved contact with friction in this way.
//
// One pair by hand: G = T = 1, no coupling, \f$ \mu = 0.5 \f$, c = 0, free gap -2, free slip 3. The
// gap closes with \f$ \lambda = 2 \f$, so b = 1. The tangential force that would hold the pair is
// -3, beyond the bound. So \f$ \tau = -1 \f$, p = 0, and the slip is 3 - 1 = 2 forwards.
//
// The amplitudes of rigid motions have any sign. Each becomes a difference \f$ a^+ - a^- \f$ of two
// numbers that are not negative, as the slip did.
//
// Cohesion ends where contact ends, and that is no linear condition: in the equations above an open
// pair carries c like a closed one. So c is given to a set of pairs, and the set is changed until
// it is that of the closed pairs.

#include "signorini/solvers/lemke_path.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// M and q of the linear complementarity problem for (lambda, p, v-, a+, a-), with given cohesion.
// The forces are \f$ f = E\,(\lambda, p) - (0, c) \f$ where E takes \f$ \mu\lambda \f$ away from p.
// So the movements are \f$ d - F\,(0, c) + FE\,(\lambda, p) \f$, and \f$ b - \tau \f$ is
// \f$ 2\mu\lambda + 2c - p \f$. The balance of forces along a rigid motion is an equation; it
// stands here as two inequalities, one for each part of the amplitude.
ContactProblem complementarity(const ScaledProblem& problem, const VectorXd& cohesion) {
  const Index rows = problem.free.size();
  const Index pairs = problem.pairs();
  const Index slips = rows - pairs;
  const Index k = problem.rigid.cols();
  const Index size = rows + slips + 2 * k;
  // f = E (lambda, p) - (0, c) with tau = p - mu lambda - c.
  MatrixXd E = MatrixXd::Identity(rows, rows);
  VectorXd minus_c = VectorXd::Zero(rows);
  minus_c.tail(slips) = -cohesion;
  ContactProblem lcp{MatrixXd::Zero(size, size), VectorXd(size)};
  MatrixXd& M = lcp.compliance;
  for (Index j = 0; j < slips; ++j) {
    const Index pair = problem.law.pair[at(j)];
    E(pairs + j, pair) = -problem.law.coefficient(j);
    M(rows + j, pair) = 2 * problem.law.coefficient(j);
  }
  M.topLeftCorner(rows, rows) = problem.compliance * E;
  M.block(pairs, rows, slips, slips).setIdentity();
  M.block(rows, pairs, slips, slips) = -MatrixXd::Identity(slips, slips);
  lcp.free_gap.head(rows) = problem.free + problem.compliance * minus_c;
  lcp.free_gap.segment(rows, slips) = 2 * cohesion;
  if (k == 0) return lcp;
  // a = a+ - a-; r - R^T f >= 0 belongs to a+ and R^T f - r >= 0 to a-.
  const Index plus = rows + slips;
  M.block(0, plus, rows, k) = problem.rigid;
  M.block(0, plus + k, rows, k) = -problem.rigid;
  M.block(plus, 0, k, rows) = -problem.rigid.transpose() * E;
  M.block(plus + k, 0, k, rows) = problem.rigid.transpose() * E;
  lcp.free_gap.segment(plus, k) = problem.resultant - problem.rigid.transpose() * minus_c;
  lcp.free_gap.tail(k) = -lcp.free_gap.segment(plus, k);
  return lcp;
}

// Runs lemke(), again with other covering vectors if it does not arrive: in exact numbers it would,
// but where friction coefficients are huge, rounding can let it leave its path. Another covering
// vector leads along another path, with other roundings. A path that arrives is short: a limit of
// 100 pivots per unknown finds out early about one that is lost.
ContactState arrived(const ContactProblem& lcp, const SolverOptions& options, Report& report) {
  ContactState state;
  const Index m = lcp.free_gap.size();
  SolverOptions path = options;  // a path that arrives is about as long as the problem is large
  if (path.iteration_limit == 0) path.iteration_limit = 100 * m;
  for (Index trial = 0; trial < 4 && state.report.status != SolveStatus::Solved; ++trial) {
    const VectorXd covering = VectorXd::LinSpaced(m, 1, static_cast<double>(1 + trial));
    state = trial == 0 ? lemke(lcp, path) : lemke(lcp, covering, path);
    append(report, state.report);
  }
  return state;
}

// Takes the forces of a linear complementarity problem over, and what they say of each pair. Of two
// complementary numbers one is zero but for rounding. So they are compared with each other and not
// with a tolerance: a pair is closed if its force exceeds its gap, and slides forwards if its slip
// exceeds p. Backwards the two numbers are minus the slip and \f$ b - \tau \f$.
void take(const ScaledProblem& problem, const VectorXd& cohesion, const VectorXd& z,
          Iterate& iterate) {
  const Index rows = problem.free.size();
  const Index pairs = problem.pairs();
  const Index slips = rows - pairs;
  const Index k = problem.rigid.cols();
  ActiveSetSolution& now = iterate.solution;
  now.force = z.head(rows);
  now.amplitude = z.segment(rows + slips, k) - z.tail(k);
  const auto bound = [&](Index j) {
    return problem.law.coefficient(j) * z(problem.law.pair[at(j)]) + cohesion(j);
  };
  for (Index j = 0; j < slips; ++j) now.force(pairs + j) -= bound(j);
  now.movement = problem.free + problem.compliance * now.force;
  if (k > 0) now.movement += problem.rigid * now.amplitude;
  for (Index i = 0; i < pairs; ++i)
    iterate.statuses[at(i)] = z(i) > now.movement(i) ? ContactStatus::Stick : ContactStatus::Open;
  for (Index j = 0; j < slips; ++j) {
    ContactStatus& contact_status = iterate.statuses[at(problem.law.pair[at(j)])];
    const double slip = now.movement(pairs + j);
    const double forward = z(pairs + j);
    if (contact_status == ContactStatus::Open) continue;
    if (slip > std::max(forward, 0.0))
      contact_status = ContactStatus::SlipForward;
    else if (-slip > std::max(2 * bound(j) - forward, 0.0))
      contact_status = ContactStatus::SlipBackward;
  }
}

// The cohesion of a set of pairs: those that came out closed. The others get zero, so that an open
// pair drags nothing along.
VectorXd carried(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses) {
  VectorXd cohesion = problem.law.cohesion;
  for (Index j = 0; j < cohesion.size(); ++j)
    if (statuses[at(problem.law.pair[at(j)])] == ContactStatus::Open) cohesion(j) = 0;
  return cohesion;
}

// Which pairs carry cohesion: first all, then those that came out closed, until both are the same.
// Each set asks for the next one, and a set may come back. One that comes back would come back for
// ever. So from there on one pair changes at a time. It must not be the last one again, unless it
// is the only wrong one: then the pair opens with its cohesion and closes without it, and the
// method ends with the status `Jump`. There is no state of rest near such a point. If the load
// grows slowly, the bodies jump to a state far away.
class CohesiveSets {
 public:
  enum class Next {
    Try,      ///< now() is a new set
    Settled,  ///< what came out is what was assumed
    Jump,     ///< pair() closes only without its cohesion and opens only with it
    Circle    ///< all that follows was tried
  };

  explicit CohesiveSets(const VectorXd& all) : now_(all), seen_{all} {}

  [[nodiscard]] const VectorXd& now() const { return now_; }
  /// \return the slip that changed last, if it was the only one
  [[nodiscard]] Index changed() const { return changed_; }

  /// Takes what came out, all at once, and one pair at a time from where a set comes back.
  Next follow(const VectorXd& next) {
    const Index change = first_change(next);
    if (change < 0) return Next::Settled;
    if (one_at_a_time_ && change == changed_) return Next::Jump;
    if (one_at_a_time_)
      now_(change) = next(change);
    else
      now_ = next;
    changed_ = one_at_a_time_ ? change : -1;
    const bool known = std::find(seen_.begin(), seen_.end(), now_) != seen_.end();
    if (known && one_at_a_time_) return Next::Circle;
    if (known) seen_.clear();
    one_at_a_time_ = one_at_a_time_ || known;
    seen_.push_back(now_);
    return Next::Try;
  }

 private:
  /// The first slip of which two sets do not say the same, other than the last one if there is one; -1 if they agree.
  [[nodiscard]] Index first_change(const VectorXd& next) const {
    Index found = -1;
    for (Index j = 0; j < now_.size() && (found < 0 || found == changed_); ++j)
      if (now_(j) != next(j)) found = j;
    return found;
  }

  VectorXd now_;
  std::vector<VectorXd> seen_;
  bool one_at_a_time_ = false;
  Index changed_ = -1;
};

// Why no set of cohesive pairs is left to try. The reason names a pair where one is at fault, and
// what the user can change.
std::string in_words(CohesiveSets::Next end, Index pair) {
  if (end == CohesiveSets::Next::Settled)
    return "rounding hides what the pairs do where Lemke's method arrived";
  if (end == CohesiveSets::Next::Circle)
    return "no set of pairs that was tried stays closed with the cohesion it is given, and no "
           "other; change the load or the cohesion";
  return text("pair ", pair,
              " closes only without its cohesion and opens only with it: cohesion that ends "
              "with contact leaves no equilibrium here; change the load or the cohesion");
}

}  // namespace

// The pivots decide on the pairs with the rounding of a long path. So their statuses are only a
// start: up to three exchanges of the primal-dual active set put right those that barely touch, and
// confirm the result from the data. If no exchange confirms it, the next set of cohesive pairs is
// tried.
void follow_pivots(const ScaledProblem& problem, const SolverOptions& options, Iterate& iterate) {
  using Next = CohesiveSets::Next;
  CohesiveSets sets(problem.law.cohesion);
  Next end = Next::Try;
  while (end == Next::Try) {
    const ContactState state =
        arrived(complementarity(problem, sets.now()), options, iterate.report);
    const std::string ended =
        text("Lemke's method ended with '", to_string(state.report.status), "'");
    iterate.reason = ended;
    if (!state.force.allFinite()) return;
    take(problem, sets.now(), state.force, iterate);
    const VectorXd next = carried(problem, iterate.statuses);
    // Rounding may have the say over pairs that barely touch.
    primal_dual_iterations(problem, 3, iterate);
    if (iterate.confirmed) return;
    iterate.stop(state.report.status, ended.c_str());
    if (state.report.status != SolveStatus::Solved) return;
    end = sets.follow(next);
  }
  const Index pair = sets.changed() < 0 ? -1 : problem.law.pair[at(sets.changed())];
  iterate.stop(end == Next::Settled ? SolveStatus::Breakdown : SolveStatus::Jump,
               in_words(end, pair).c_str());
}

}  // namespace signorini
