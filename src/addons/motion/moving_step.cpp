// # A step of bodies that move
//
// Contact of bodies that slide is no linear problem: gaps and normals depend on where the bodies are. So do forces, if strains
// are not small. Near a place \f$ \hat u \f$ all of it is linear in the way d that is left,
// \f[ (K - B - C)\,d = p - f(\hat u) - A^T\lambda, \qquad A = -N(\hat u), \qquad \text{gap} = g(\hat u) - Ad, \f]
// where B is how normal forces turn, and C how friction does. Both are a load of the linear problem, see
// [corrected_solve.cpp](corrected_solve.cpp), which is solved and certified as any other scene. \f$ \hat u + d \f$ is
// the next place. Josephy showed in 1979 that this is Newton's method for such problems.
//
// Where all strains are small K does not change. Then one factor
// serves all iterations of all steps: what an iteration costs is some searches and the compliance of its rows.
//
// The end has d = 0. So its digits are those of p - f and of g alone: forces of cells and gaps of places, each computed from
// differences of nearby nodes, see [body_answers.cpp](body_answers.cpp).

#include "addons/motion/moving_step.hpp"

#include <utility>

#include "addons/motion/linear_problem.hpp"
#include "addons/motion/linearised_model.hpp"
#include "addons/motion/moved_pairs.hpp"
#include "addons/motion/turns.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/checks.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// More iterations are not waited for. A loop that shrinks an error to a fifth each time needs 18 from 1 to 1e-12; one that
/// needs more than this many is none that ends.
constexpr int most_iterations = 60;

/// The distance of the difference quotient of contact forces, in sizes of the smallest body: its rounding and its truncation error
/// are then about equal.
constexpr double root_of_rounding = 1e-8;

/// Gaps of open pairs and slips of those that move, as they are where the bodies stand: the linear problem has foreseen them.
void read_movements(const VectorXd& movement, ContactState& contact) {
  VectorXd gap = movement.head(contact.gap.size());
  for (const Index pair : contact.active()) gap(pair) = contact.gap(pair);
  contact.gap = std::move(gap);
  for (Index k = 0; k < contact.slip.size(); ++k)
    if (status_of_slip(contact, k) != ContactStatus::Stick)
      contact.slip(k) = movement(contact.gap.size() + k);
}

std::string why_not_ended(const std::string& reason, const std::string& indefinite) {
  if (!indefinite.empty()) return indefinite;
  if (!reason.empty()) return text("the bodies cannot come to stand where the last iteration leads: ", reason);
  return text("the equations of where the bodies come to stand did not hold after ",
              most_iterations,
              " iterations: take shorter steps, and the softer and finer side as the source");
}

/// A step while it is solved.
struct Moving {
  const Displaced& before;
  Model& model;
  Condensed& condensed;
  SolverOptions options;
  Ledger ledger;
  LinearisedModel place;
  Factor factor = condensed.factor;  ///< of K before strain
  std::vector<Index> held = {};      ///< rows that held in the last iteration, see held_rows()
  std::string reason = {};           ///< why a place cannot be gone to
  int iteration = 0;                 ///< that is made
  std::size_t rung = 0;              ///< of the ladder of tangents, that held last

  /// None at rest, where the linear problem is that of the scene, and none while supports still move: that way may be longer than the
  /// sides that it passes, and what forces do at its beginning does not tell what they do at its end.
  [[nodiscard]] TurnedForces turned_forces() const {
    if (place.at_rest() || !place.arrived()) return {};
    return place.turned(root_of_rounding * smallest_size(model));
  }

  /// With the factor of the scene as long as that is the one of K, and of a scene whose supports leave no unknown.
  Solution linear_problem() {
    const bool rest = place.at_rest();
    const TurnedForces turned = turned_forces();
    if (rest || !place.finite() || model.unknowns.count == 0) {
      condensed.factor = factor;
      VectorXd free = rest ? std::exchange(condensed.free_displacement, {})
                           : factor.solve(model.programme.load);
      condensed.problem.law = model.law;
      {
        const Ledger::Phase phase(ledger, "compliance");  // as often as pairs are found
        condensed.problem.compliance = factor.compliance(model.programme.A, ledger);
      }
      move_freely(model, std::move(free), condensed);
      Solution solution =
          corrected_solve(model, turned, options, condensed, std::move(ledger)).solution;
      if (!rest || !held.empty() || solution.contact.unbounded_direction.size() == 0) return solution;
      ledger = std::move(solution.ledger);
    }
    return solve_with_tangent({model, held, turned, options, rung}, condensed, std::move(ledger));
  }

  /// Goes where a solution has the bodies, or on the way there as far as pairs can be found and no cell inverts.
  bool goes_to(const Solution& solution) {
    double share = 1;
    for (int halved = 0; halved <= model.path.halvings; ++halved, share /= 2) try {
        place.move(place.ahead(solution.refined, share), ledger);
        reason.clear();
        return true;
      } catch (const ProblemError& error) {
        reason = error.what();
      }
    return false;
  }

  /// Whether what was solved, with these pairs, holds of the equations that are found where it leads to.
  bool holds_here(Solution& solution, const std::vector<PairName>& names,
                  const std::vector<Index>& frictional) const {
    if (names_of_pairs(model) != names || model.law.pair != frictional) return false;
    const Certificate here = place.certificate(solution);
    if (!here.holds()) return false;
    solution.certificate = here;
    read_movements(model.programme.initial_gap, solution.contact);
    solution.pressure = solution.contact.force.cwiseQuotient(model.pairs.weight);
    return true;
  }

  /// What is known of the pairs that were, for those that are now.
  void hand_on(const std::vector<PairName>& names, const std::vector<ContactStatus>& statuses) {
    const std::vector<Index> same = numbers_among(names, names_of_pairs(model));
    options.start.assign(same.size(), ContactStatus::Open);
    for (std::size_t k = 0; k < same.size(); ++k)
      if (same[k] >= 0) options.start[k] = statuses[static_cast<std::size_t>(same[k])];
    held = held_rows(options.start, model.law);
  }

  /// Goes to where the unknowns are expected, if pairs can be found there and no cell inverts; else the step begins where the last one
  /// ended.
  void begin(const VectorXd& expected) {
    if (expected.size() > 0) try {
        const std::vector<PairName> names = names_of_pairs(model);
        place.move(place.ahead({expected, {}, {}}, 1), ledger);
        return hand_on(names, std::vector<ContactStatus>(options.start));
      } catch (const ProblemError&) {
      }
    place.move(before, ledger);
  }

  /// Iterations until one holds. \return whether one did
  bool ends(Solution& solution) {
    while (++iteration <= most_iterations) {
      const std::vector<PairName> names = names_of_pairs(model);
      const std::vector<Index> frictional = model.law.pair;
      solution = linear_problem();
      ledger = std::move(solution.ledger);
      if (solution.contact.report.status != SolveStatus::Solved) return false;
      if (!goes_to(solution)) {
        held = held_rows(solution.contact.contact_status, model.law);
        break;
      }
      if (holds_here(solution, names, frictional)) return true;
      hand_on(names, solution.contact.contact_status);
    }
    solution.contact.report.status = SolveStatus::IterationLimit;
    solution.contact.reason = why_not_ended(reason, why_indefinite(model, held, rung));
    return false;
  }

  /// The first step may be tried again, from rest, and any step after it failed.
  void restore() const {
    condensed.factor = factor;
    place.restore();
  }

  Solution solved(const VectorXd& expected) {
    Solution solution;
    try {
      begin(expected);
      if (ends(solution)) {
        place.conclude(solution);
        check_rotations(model, solution);
        if (solution.contact.active().empty() && model.modes.empty() && rung >= weak_springs)
          solution.notes.push_back("the equilibrium is unstable, a small push leads elsewhere: the tangent is indefinite, where " + most_shortened(model));
        if (solution.contact.report.status == SolveStatus::Solved)
          check_solution(model, condensed, solution);
      }
    } catch (const ProblemError&) {
      restore();
      throw;
    }
    restore();
    solution.ledger = std::move(ledger);
    return solution;
  }
};

}  // namespace

StepLoop moving_step(PlacePairs place) {
  StepLoop loop;
  loop.place = [place](const Displaced& displacement, const Displaced& before, Model& model) {
    place(displacement, before, model);
    count_from_the_scene(displacement, model);
  };
  loop.solve = [place](const Displaced& before, const VectorXd& expected, const SolverOptions& options,
                       Model& model, Condensed& condensed, Ledger ledger) {
    return Moving{before, model, condensed, options, std::move(ledger), {place, before, model}}
        .solved(expected);
  };
  loop.certify = certificate_where_it_stands;
  return loop;
}

}  // namespace signorini
