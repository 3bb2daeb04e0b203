// # A step of bodies that move
//
// Contact of bodies that slide is no linear problem: gaps and normals depend on where the bodies are. Near a place
// \f$ \hat u \f$ it is one,
// \f[ Ku = p - A^T\lambda, \qquad A = -N(\hat u), \qquad \text{gap} = g(\hat u) + N(\hat u)(u - \hat u), \f]
// and that is solved exactly, with complementarity, friction and certificate, by the road of all scenes. Its u is the next
// place. Josephy showed in 1979 that this is Newton's method for such problems. K does not change, so that its one
// factor serves all iterations of all steps: what an iteration costs is a search and the compliance of its rows.

#include "addons/motion/moving_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "addons/motion/moved_pairs.hpp"
#include "addons/motion/turns.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/residual.hpp"
#include "signorini/scene/balance.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// More iterations are not waited for. A loop that shrinks an error to a fifth each time needs 18 from 1 to 1e-12; one that
/// needs more than this many is none that ends.
constexpr int most_iterations = 60;

/// The problem that an iteration has solved.
struct Linearised {
  std::vector<PairName> names;
  FrictionLaw law;
  VectorXd pushed;  ///< `n` what its forces do to the unknowns [force]
};

/// A step while it is solved.
struct Moving {
  const decltype(StepLoop::place)& place;
  const NodeArray& before;
  Model& model;
  Condensed& condensed;
  SolverOptions options;
  Ledger ledger;

  Solution linear_problem();
  bool goes_to(const Solution& solution, std::string& reason);
  [[nodiscard]] bool holds_here(Solution& solution, const Linearised& solved) const;
  Solution solved();
};

/// Solves the contact problem of the pairs as they are placed. That of a plan, in the phase `condensation`, is made once more
/// for each.
Solution Moving::linear_problem() {
  condensed.problem.law = model.law;
  {
    const Ledger::Phase phase(ledger, "compliance");  // as often as pairs are found
    condensed.problem.compliance = condensed.factor.compliance(model.programme.A, ledger);
  }
  move_freely(model, std::exchange(condensed.free_displacement, {}), condensed);
  return solve(model, condensed, model.solver, std::exchange(ledger, {}), options);
}

/// Places the bodies where a solution has them, or on the way there as far as pairs can be found.
bool Moving::goes_to(const Solution& solution, std::string& reason) {
  const Ledger::Phase phase(ledger, "pairs");
  const NodeArray from = model.standing->displacement;
  const NodeArray there = expand(model.unknowns, solution.refined.displacement);
  for (int halved = 0; halved <= model.path.halvings; ++halved) try {
      ledger.count("searches", 1);
      place(halved == 0 ? there : from + std::ldexp(1.0, -halved) * (there - from), before, model);
      return true;
    } catch (const ProblemError& error) {
      reason = error.what();
    }
  return false;
}

/// Gaps of open pairs and slips of those that move, as they are where the bodies stand: the linear problem has foreseen them.
void read_movements(const VectorXd& movement, ContactState& contact) {
  const Index pairs = contact.gap.size();
  VectorXd gap = movement.head(pairs);
  for (const Index pair : contact.active) gap(pair) = contact.gap(pair);
  contact.gap = std::move(gap);
  for (Index k = 0; k < contact.slip.size(); ++k)
    if (contact.contact_status[static_cast<std::size_t>(k)] != ContactStatus::Stick)
      contact.slip(k) = movement(pairs + k);
}

/// Whether what was solved holds of the pairs that are found where it leads to. The certificate measures what is out of balance by
/// loads too, and given displacements that carry a body far are large ones: so the same forces must also push the same way. What
/// changes there is of first order in the way that is left, and what gaps lack is of second order.
bool Moving::holds_here(Solution& solution, const Linearised& solved) const {
  if (names_of_pairs(model) != solved.names || model.law.pair != solved.law.pair) return false;
  Certificate here = certify(model.programme, solution.refined, model.law);
  here.balance = imbalance(model, solution.contact, solution.refined.force);
  const VectorXd movement = gaps(model.programme, solution.refined);
  const VectorXd pushes = model.programme.A.transpose() * solution.refined.force;
  if (!here.holds() || largest(pushes - solved.pushed) > certificate_tolerance * largest(pushes))
    return false;
  solution.certificate = here;
  read_movements(movement, solution.contact);
  solution.pressure = solution.contact.force.cwiseQuotient(model.pairs.weight);
  return true;
}

Solution Moving::solved() {
  Solution solution;
  std::string reason;
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    Linearised problem{names_of_pairs(model), model.law, {}};
    solution = linear_problem();
    if (solution.contact.report.status != SolveStatus::Solved) return solution;
    problem.pushed = model.programme.A.transpose() * solution.refined.force;
    ledger = std::move(solution.ledger);
    if (!goes_to(solution, reason)) break;
    if (holds_here(solution, problem)) {
      judge_turns(model, solution);
      solution.ledger = std::move(ledger);
      return solution;
    }
    options.start = handed_on(problem.names, all_statuses(solution.contact), model);
  }
  solution.ledger = std::move(ledger);
  solution.contact.report.status = SolveStatus::IterationLimit;
  solution.contact.reason =
      reason.empty()
          ? text("where the bodies come to stand other pairs are found each time, after ",
                 most_iterations,
                 " searches: take shorter steps, and the softer and finer "
                 "side as the source")
          : text("where the bodies come to stand no pairs are found: ", reason);
  return solution;
}

}  // namespace

StepLoop moving_step(decltype(StepLoop::place) place) {
  StepLoop loop;
  loop.place = place;
  loop.solve = [place = std::move(place)](const NodeArray& before, const SolverOptions& options,
                                          Model& model, Condensed& condensed, Ledger ledger) {
    return Moving{place, before, model, condensed, options, std::move(ledger)}.solved();
  };
  return loop;
}

}  // namespace signorini
