// The judge of the conformance suite, judged: every way of being wrong that it must find out.
#include <stdexcept>

#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "support/floating.hpp"
#include "support/friction.hpp"
#include "support/problem_classes.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::VectorXd;

namespace {

using Solve = ContactState (*)(const ContactProblem&, const SolverOptions&);

/// Two pairs, of which both close: force (2, 1).
Instance solvable() {
  Eigen::Matrix2d G;
  G << 2, 1, 1, 2;
  Instance made{"two pairs", {G, Eigen::Vector2d(-5, -4)}};
  made.force = Eigen::Vector2d(2, 1);
  made.gap = Eigen::Vector2d(0, 0);
  return made;
}

/// Two walls that are too close.
Instance unsolvable() {
  Eigen::Matrix2d G;
  G << 1, -1, -1, 1;
  Instance made{"wedged", {G, Eigen::Vector2d(-1, 0.5)}};
  made.expected = SolveStatus::Infeasible;
  return made;
}

std::string verdict(Solve solve, const Instance& instance, const std::vector<Trait>& excuse = {}) {
  return complaint({"liar", "for this test", solve, 0, excuse}, {Trait::Dependent}, instance);
}

ContactState state(const ContactProblem& problem, const VectorXd& force, SolveStatus status) {
  const Eigen::Index pairs = force.size();
  ContactState made{
      force, problem.compliance.topLeftCorner(pairs, pairs) * force + problem.free_gap, {}, {}};
  made.report.status = status;
  return made;
}

template <SolveStatus status>
ContactState says(const ContactProblem& problem, const SolverOptions& /*options*/) {
  return state(problem, VectorXd::Zero(problem.free_gap.size()), status);
}

/// The right state, but for one error.
template <typename Change>
ContactState changed(const ContactProblem& problem, Change change) {
  ContactState made = enumerate(problem);
  change(made);
  return made;
}

}  // namespace

TEST_CASE("the judge accepts the truth", "[conformance][judge]") {
  CHECK(verdict(enumerate, solvable()).empty());
  CHECK(verdict(enumerate, unsolvable()).empty());
  CHECK(complaints(find_solver("enumerate")).empty());
}

TEST_CASE("the judge finds a wrong success", "[conformance][judge]") {
  CHECK_THAT(verdict(says<SolveStatus::Solved>, solvable()), ContainsSubstring("certificate"));
  CHECK_THAT(verdict(says<SolveStatus::Solved>, unsolvable()), ContainsSubstring("nothing solves"));
  const Solve inexact = [](const ContactProblem& problem, const SolverOptions&) {
    return changed(problem, [](ContactState& made) { made.force *= 1 + 1e-11; });
  };
  CHECK_THAT(verdict(inexact, solvable()), ContainsSubstring("certificate"));
  const Solve negative = [](const ContactProblem& problem, const SolverOptions&) {
    return changed(problem, [](ContactState& made) { made.gap(0) = -1e-300; });
  };
  CHECK_THAT(verdict(negative, solvable()), ContainsSubstring("negative"));
  const Solve open = [](const ContactProblem& problem, const SolverOptions&) {
    return changed(problem, [](ContactState& made) { made.contact_status.pop_back(); });
  };
  CHECK_THAT(verdict(open, solvable()), ContainsSubstring("statuses"));
  const Solve empty = [](const ContactProblem&, const SolverOptions&) {
    return state({Eigen::MatrixXd(0, 0), VectorXd(0)}, VectorXd(0), SolveStatus::Solved);
  };
  CHECK_THAT(verdict(empty, solvable()), ContainsSubstring("0 forces"));
  Instance other = solvable();  // certified, but not what is known
  other.force = Eigen::Vector2d(2, 1.001);
  CHECK_THAT(verdict(enumerate, other), ContainsSubstring("force is wrong"));
  other = solvable();
  other.gap = Eigen::Vector2d(0, 1e-9);
  CHECK_THAT(verdict(enumerate, other), ContainsSubstring("gap is wrong"));
}

TEST_CASE("no trait excuses a wrong success or a wrong refusal", "[conformance][judge]") {
  const std::vector<Trait> all = {Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
                                  Trait::IllConditioned, Trait::Slow};
  CHECK_FALSE(verdict(says<SolveStatus::Solved>, solvable(), all).empty());
  CHECK_FALSE(verdict(says<SolveStatus::Solved>, unsolvable(), all).empty());
  CHECK_FALSE(verdict(says<SolveStatus::Infeasible>, solvable(), all).empty());
  CHECK_THAT(verdict(says<SolveStatus::Infeasible>, unsolvable(), all),
             ContainsSubstring("proves nothing"));
  CHECK_FALSE(verdict(says<SolveStatus::Feasible>, solvable(), all).empty());
  CHECK_FALSE(verdict(says<SolveStatus::Feasible>, unsolvable(), all).empty());
}

TEST_CASE("a trait excuses a failure, and nothing else does", "[conformance][judge]") {
  for (const Solve solve :
       {says<SolveStatus::Breakdown>, says<SolveStatus::IterationLimit>, says<SolveStatus::Ray>})
    for (const Instance& instance : {solvable(), unsolvable()}) {
      CHECK(verdict(solve, instance, {Trait::Dependent}).empty());
      CHECK_THAT(verdict(solve, instance), ContainsSubstring("instead of"));
      CHECK_THAT(verdict(solve, instance, {Trait::Slow}), ContainsSubstring("instead of"));
    }
  const Solve feasible = [](const ContactProblem& problem, const SolverOptions&) {
    return state(problem, Eigen::Vector2d(5, 4), SolveStatus::Feasible);  // pressed too hard
  };
  CHECK(verdict(feasible, solvable(), {Trait::Dependent}).empty());
  CHECK_THAT(verdict(feasible, solvable()), ContainsSubstring("instead of"));
}

TEST_CASE("the judge checks a proof of infeasibility", "[conformance][judge]") {
  const auto proof = [](const ContactProblem& problem, const VectorXd& y) {
    ContactState made = says<SolveStatus::Infeasible>(problem, {});
    made.farkas_certificate = y;
    return made;
  };
  static const auto make = proof;
  const Solve right = [](const ContactProblem& problem, const SolverOptions&) {
    return make(problem, Eigen::Vector2d(3, 3));
  };
  const Solve moves = [](const ContactProblem& problem, const SolverOptions&) {
    return make(problem, Eigen::Vector2d(1, 0.999));
  };
  const Solve negative = [](const ContactProblem& problem, const SolverOptions&) {
    return make(problem, Eigen::Vector2d(-1, -1));
  };
  const Solve nothing = [](const ContactProblem& problem, const SolverOptions&) {
    return make(problem, Eigen::Vector2d(0, 0));
  };
  CHECK(verdict(right, unsolvable()).empty());
  CHECK_THAT(verdict(moves, unsolvable()), ContainsSubstring("moves pair"));
  CHECK_THAT(verdict(negative, unsolvable()), ContainsSubstring("negative weight"));
  CHECK_THAT(verdict(nothing, unsolvable()), ContainsSubstring("d.y"));
}

TEST_CASE("the judge hears exceptions and missing refusals", "[conformance][judge]") {
  const Solve throws = [](const ContactProblem&, const SolverOptions&) -> ContactState {
    throw std::runtime_error("out of ideas");
  };
  CHECK_THAT(verdict(throws, solvable()), ContainsSubstring("out of ideas"));
  Instance turned = solvable();
  turned.problem.compliance(0, 1) = 0.5;
  CHECK_THAT(verdict(says<SolveStatus::Breakdown>, turned, {Trait::Asymmetric}),
             ContainsSubstring("does not refuse"));
  CHECK(verdict(primal_dual_active_set, turned, {Trait::Asymmetric}).empty());
}

TEST_CASE("the judge finds a wrong friction force, motion or claim to be the only solution",
          "[conformance][judge]") {
  Eigen::Matrix2d F;
  F << 1, 2, 2, 9;
  Instance pair{"one node", one_pair(F, 0.1, 3, 0.6)};  // three solutions
  pair.solutions = all_solutions(pair.problem);
  const auto judged = [&](Solve solve, Instance instance) {
    const Solver liar = Solver{"liar", "for this test", solve}.with_friction(Takes::Also);
    return complaint(liar, {Trait::Friction}, instance);
  };
  CHECK(judged(primal_dual_active_set, pair).empty());
  const Solve only = [](const ContactProblem& problem, const SolverOptions&) {
    ContactState made = primal_dual_active_set(problem, {});
    made.uniqueness = Uniqueness::Proved;
    return made;
  };
  CHECK_THAT(judged(only, pair), ContainsSubstring("there are 3"));
  const Solve pulls = [](const ContactProblem& problem, const SolverOptions&) {
    ContactState made = primal_dual_active_set(problem, {});
    made.friction(0) += 1e-3;
    return made;
  };
  CHECK_THAT(judged(pulls, pair), ContainsSubstring("certificate"));
  Instance other = pair;
  for (Eigen::VectorXd& forces : other.solutions) forces.array() += 1e-3;
  CHECK_THAT(judged(primal_dual_active_set, other), ContainsSubstring("none of the 3"));
  other = pair;
  other.contact_status = {ContactStatus::SlipBackward};
  CHECK_THAT(judged(primal_dual_active_set, other), ContainsSubstring("other ways"));
  other = pair;
  other.expected = SolveStatus::Breakdown;
  CHECK_THAT(judged(primal_dual_active_set, other), ContainsSubstring("nothing solves"));
  CHECK(judged(says<SolveStatus::Breakdown>, other).empty());
  const Solver takes_none{"liar", "for this test", primal_dual_active_set};
  CHECK_FALSE(takes_part(takes_none, pair));
  CHECK_FALSE(takes_part(Solver(takes_none).with_friction(Takes::Only), solvable()));
}

TEST_CASE("the judge finds false proofs that a body escapes", "[conformance][judge]") {
  Instance away{"bar",
                bar(Eigen::Vector2d(0, 3), Eigen::Vector2d(1, 1), Eigen::Vector2d(1, 1), -1, 1)};
  away.expected = SolveStatus::Infeasible;
  const auto judged = [&](Solve solve) {
    return complaint(Solver{"liar", "for this test", solve}.with_rigid_modes(), {Trait::Dependent},
                     away);
  };
  static Eigen::Vector2d way;
  const Solve claims = [](const ContactProblem& problem, const SolverOptions&) {
    ContactState made = state(problem, VectorXd::Zero(2), SolveStatus::Infeasible);
    made.unbounded_direction = way;
    return made;
  };
  way << 1, 0;  // upwards, as the load
  CHECK(judged(claims).empty());
  way << 1, -0.5;  // the second end goes down
  CHECK_THAT(judged(claims), ContainsSubstring("pair 1 stops"));
  away.problem.resultant = Eigen::Vector2d(1, 1);
  way << 1, 0;
  CHECK_THAT(judged(claims), ContainsSubstring("its load works"));
}
