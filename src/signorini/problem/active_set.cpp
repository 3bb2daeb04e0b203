// # What numbers say of a pair
//
// An active set method assumes what each pair does, solves one linear system, and looks at the
// numbers. predict() is this look. A pair is closed if its force exceeds its gap,
// \f[ \lambda > g, \f]
// where forces have a factor that makes them comparable with gaps, see force_scale(). Of a solution
// one of the two is 0, and the other one decides. Elsewhere this is the projection of Alart and
// Curnier: \f$ \lambda = \max(0, \lambda - g) \f$. A closed pair with friction has the bound
// \f$ b = \mu(\lambda - g)^+ + c \f$, and it sticks if \f$ |\tau - s| \le b \f$. With the
// coefficient 0.5, the force 4, no gap and no cohesion, b is 2:
//
// | assumed | friction force | slip | \f$ \tau - s \f$ | the pair would |
// |---|---|---|---|---|
// | stick | 1 | 0 | 1 | stick |
// | stick | 3 | 0 | 3 | slide backward |
// | slide forward | -2 | 3 | -5 | slide forward |
// | slide forward | -2 | -3 | 1 | stick |
//
// In the last row the pair slides with its friction force and not against it. So it has to stop
// first.

#include <algorithm>
#include <optional>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

// The table as a function. Two things keep rounding from deciding. A sticking pair may exceed its
// bound by rounding of its forces. And a slip that is rounding has no sign that means anything. A
// pair that slides as was assumed, or the other way by no more than rounding, keeps its direction:
// its friction force tells which one it is. A pair whose bound is 0 does so too: it slides freely,
// and neither direction is wrong.
ContactStatus closed_pair_status(ContactStatus last, double tau, double slip, double bound,
                                 double slack, double still) {
  const bool slides = friction_sign(last) != 0;
  if (slides && still > 0 && (bound == 0 || friction_sign(last) * slip <= still)) return last;
  const double pulled = tau - slip;
  const double allowed = bound + (last == ContactStatus::Stick ? slack : 0);
  return pulled > allowed    ? ContactStatus::SlipBackward
         : pulled < -allowed ? ContactStatus::SlipForward
                             : ContactStatus::Stick;
}

}  // namespace

// From statuses to equations. A closed pair has no gap. A pair that sticks has no slip either, and
// its friction force is an unknown. A pair that slides has a friction force at its bound, which
// follows its normal force. With the bound 0 there is no friction at all, and the slip is free.
ActiveSet active_set(const std::vector<ContactStatus>& statuses, const FrictionLaw& law) {
  const Index pairs = static_cast<Index>(statuses.size());
  ActiveSet set{closed_pairs(statuses)};
  for (std::size_t k = 0; k < law.pair.size(); ++k) {
    const ContactStatus contact_status = statuses[at(law.pair[k])];
    const Index row = static_cast<Index>(k);
    const double sign = friction_sign(contact_status);
    const bool frictional = law.coefficient(row) > 0 || law.cohesion(row) > 0;
    if (contact_status == ContactStatus::Stick && frictional) set.closed.push_back(pairs + row);
    if (sign != 0 && frictional)
      set.sliding.push_back(
          {law.pair[k], pairs + row, sign * law.coefficient(row), sign * law.cohesion(row)});
  }
  return set;
}

// Without friction a list of closed pairs says the same as statuses.
std::vector<ContactStatus> statuses_of(const std::vector<Index>& active, Index pairs) {
  std::vector<ContactStatus> statuses(at(pairs), ContactStatus::Open);
  for (const Index i : active) statuses[at(i)] = ContactStatus::Stick;
  return statuses;
}

// Friction forces at their bounds are computed from the normal forces of this very step, so that the law of friction holds to
// the last bit of both parts.
void impose(const ActiveSet& set, VectorXd& force, VectorXd& low) {
  const VectorXd given = std::exchange(force, VectorXd::Zero(force.size()));
  const VectorXd given_low = std::exchange(low, VectorXd::Zero(low.size()));
  force(set.closed) = given(set.closed);
  low(set.closed) = given_low(set.closed);
  for (const SlidingPair& pair : set.sliding) {
    ExactSum tau = pair.friction(force(pair.gap), low(pair.gap));
    force(pair.slip) = tau.value();
    tau.add(-force(pair.slip));
    low(pair.slip) = tau.value();
  }
}

// All rows stand in one vector where equations treat gaps and slips alike.
VectorXd all_forces(const ContactState& state) {
  return (VectorXd(state.force.size() + state.friction.size()) << state.force, state.friction)
      .finished();
}

VectorXd all_movements(const ContactState& state) {
  return (VectorXd(state.gap.size() + state.slip.size()) << state.gap, state.slip).finished();
}

std::vector<Index> closed_pairs(const std::vector<ContactStatus>& statuses) {
  std::vector<Index> closed;
  for (std::size_t i = 0; i < statuses.size(); ++i)
    if (statuses[i] != ContactStatus::Open) closed.push_back(static_cast<Index>(i));
  return closed;
}

// The first loop compares forces with gaps, the second one friction forces with bounds. Numbers of
// iterations that solve no system, as Newton's, come without roundings, and then every comparison
// is exact.
//
// Else a pair that was open closes if it overlaps by more than rounding, and one that was closed
// opens if it pulls by more than rounding. The status that was assumed wins where the numbers
// cannot decide. Without that two pairs could change places for ever.
Index predict(const ScaledProblem& problem, const ActiveSetSolution& solution, double force_scale,
              std::vector<ContactStatus>& statuses) {
  const Index pairs = problem.pairs();
  const std::vector<ContactStatus> last = statuses;
  const bool exact = solution.movement_rounding.size() == 0;
  const auto rounding = [&](Index row) { return exact ? 0 : solution.movement_rounding(row); };
  const double force_rounding = exact ? 0 : force_scale * solution.force_rounding;
  const auto pressed = [&](Index i) {
    return force_scale * solution.force(i) - solution.movement(i);
  };
  for (Index i = 0; i < pairs; ++i) {
    const bool closed = exact || last[at(i)] == ContactStatus::Open ? pressed(i) > rounding(i)
                                                                    : pressed(i) >= -force_rounding;
    statuses[at(i)] = closed ? ContactStatus::Stick : ContactStatus::Open;
  }
  for (std::size_t k = 0; k < problem.law.pair.size(); ++k) {
    const Index i = problem.law.pair[k];
    if (statuses[at(i)] == ContactStatus::Open) continue;
    const Index row = static_cast<Index>(k);
    const double mu = problem.law.coefficient(row);
    const double bound = mu * std::max(pressed(i), 0.0) + force_scale * problem.law.cohesion(row);
    statuses[at(i)] = closed_pair_status(last[at(i)], force_scale * solution.force(pairs + row),
                                         solution.movement(pairs + row), bound,
                                         (1 + mu) * force_rounding, rounding(pairs + row));
  }
  Index changes = 0;
  for (std::size_t i = 0; i < statuses.size(); ++i) changes += statuses[i] != last[i] ? 1 : 0;
  return changes;
}

// A set that predicts itself is not yet a solution. An almost singular system may pass with huge
// forces, whose rounding is larger than any gap: then nothing is wrong beyond rounding, and
// everything is wrong. The certificate measures by lengths and forces of the problem, and sees
// that.
//
// A quarter of its tolerance leaves room for the rounding of scaling back.
bool solves(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses,
            const ActiveSetSolution& solution) {
  std::vector<ContactStatus> next = statuses;
  if (!solution.solvable || predict(problem, solution, 1, next) != 0) return false;
  for (const Index row : active_set(statuses, problem.law).closed)
    if (!solution.closes(row)) return false;
  Claim claim{solution.force, solution.movement, solution.amplitude};
  const Index pairs = problem.pairs();
  claim.force.head(pairs) = solution.force.head(pairs).cwiseMax(0.0);
  claim.movement.head(pairs) = solution.movement.head(pairs).cwiseMax(0.0);
  // In the units of the problem every number is rounded once more.
  const ProblemBlocks blocks{problem.compliance, problem.free, problem.law, problem.rigid,
                             problem.resultant};
  return certify(blocks, claim).holds(0.25 * certificate_tolerance);
}

// Methods that converge in the limit only, such as weights or projections, come near a solution.
// The pairs that they have closed are often right. So these are closed exactly, and the method ends
// with an exact solution or goes on.
Confirmed confirmed(const ScaledProblem& problem, const std::vector<Index>& candidates,
                    const ActiveSetSolution* start) {
  ActiveSetSolution solution = solve_active_set(problem, ActiveSet{candidates}, start);
  std::vector<ContactStatus> statuses = statuses_of(solution.rows, problem.pairs());
  if (!solves(problem, statuses, solution)) return std::nullopt;
  return std::make_pair(std::move(solution), std::move(statuses));
}

}  // namespace signorini
