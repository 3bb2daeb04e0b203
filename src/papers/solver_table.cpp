// # All solvers in one list
//
// A solver is a function from a problem to a state, with a name, a line for lists, and a promise.
// Every member promises to say `Solved` only if the conditions of contact hold. What it need not
// solve it lists as *traits*: a member that lists `IllConditioned` may end without a solution if
// rows are nearly dependent, and then says so. The conformance suite takes this list, makes
// problems with every trait, and tests each member on all that it promises.
//
// The list is the place where a new member enters. It stands with the papers and not with the
// library, because most of its members are here to be compared.

#include "papers/solver_table.hpp"

#include <utility>

#include "papers/friction_split.hpp"
#include "papers/linear_programme.hpp"
#include "papers/projected_gauss_seidel.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/family.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"
#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace signorini {
namespace {

// Most members need no more than these three.
Solver member(const char* name, const char* summary,
              ContactState (*solve)(const ContactProblem&, const SolverOptions&)) {
  return {name, summary, solve};
}

/// What no method for the weights of the surrogate dual promises but the one that ends by itself.
// Two lists of traits: the first is shared by several members, the second is that of one. `Several`, more than one closed pair, is hard
// only for the rule that jumps from vertex to vertex.
const std::vector<Trait> all_but_several = {
    Trait::Ordinary,   Trait::Asymmetric,     Trait::Dependent, Trait::Infeasible,
    Trait::Degenerate, Trait::IllConditioned, Trait::Slow};
const std::vector<Trait> everything = {Trait::Ordinary,   Trait::Asymmetric, Trait::Dependent,
                                       Trait::Infeasible, Trait::Degenerate, Trait::IllConditioned,
                                       Trait::Slow,       Trait::Several};

// One weighted gap in the place of all, with a rule for the weights.
// The six rules of the surrogate dual are one function with a fixed rule each. Only the fully
// corrective rule ends by itself, so only it promises to solve ordinary problems.
template <WeightRule rule>
Solver one_gap(const char* name, const char* summary, std::vector<Trait> traits = all_but_several) {
  return member(name, summary, surrogate_dual<rule>).may_fail_on(std::move(traits));
}

// The literal method and the printed split are kept as they are. That they fail is a result of the
// chapters, so they promise next to nothing.
Solver literal() {
  return member("quasi_active_set_literal",
                "the paper's equations (30)-(39): minimum moved, one last step; often not optimal",
                quasi_active_set_literal)
      .may_fail_on(all_but_several);
}

// `enumerate` tries every set, so it takes only few pairs.
Solver oracle() {
  Solver every =
      member("enumerate", "tries every set of closed pairs; the oracle of the tests", enumerate)
          .may_fail_on({Trait::Infeasible});
  every.largest = largest_enumeration;
  return every;
}

// One pair at a time is the textbook's way. Groups, as in the quasi-active set, need fewer steps, each of
// which costs more.
Solver one_at_a_time() {
  return member("goldfarb_idnani", "dual active set: one pair joins or leaves at a time",
                goldfarb_idnani)
      .may_fail_on({Trait::Asymmetric, Trait::IllConditioned});
}

// Projected Gauss-Seidel is the method of engines for games. Each sweep closes every pair once, in
// order. Sweeps alone come closer and closer; this member closes the set of pairs exactly as soon as
// sweeps leave it alone.
Solver sweeps() {
  return member("projected_gauss_seidel", "sweeps: each pair in turn gets the force that closes it",
                projected_gauss_seidel)
      .may_fail_on({Trait::Ordinary, Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
                    Trait::IllConditioned, Trait::Slow});
}

// Linear programming without the energy: it can only meet the conditions, one after the other.
Solver simplex() {
  return member("linear_programme",
                "simplex steps to the least sum of artificial gaps, one pair at a time",
                linear_programme)
      .may_fail_on({Trait::Asymmetric, Trait::Dependent, Trait::Infeasible});
}

// The slip as the difference of two positive numbers. Both forms take bodies that only contact holds.
Solver split(const char* name, const char* summary,
             ContactState (*solve)(const ContactProblem&, const SolverOptions&)) {
  return member(name, summary, solve)
      .may_fail_on({Trait::Friction})
      .with_friction(Takes::Only)
      .with_rigid_modes();
}

// The members that do not say `no` of friction.
// A member takes friction always, never or only: the two lists below are parts of the one above.
std::vector<Solver> without(Takes no) {
  std::vector<Solver> members;
  for (const Solver& solver : all_solvers())
    if (solver.friction != no) members.push_back(solver);
  return members;
}

}  // namespace

// Methods that the library itself uses come with their traits, as a function of their name. The
// others get theirs above. The order of the list is that of tables and messages.
// Nothing here is asked by the library itself: its own portfolio names its members by function.
// To add a member, write one line here:
//
//     member("my_method", "what it does in a line", my_method).may_fail_on({Trait::Slow}),
const std::vector<Solver>& all_solvers() {
  static const std::vector<Solver> family = {
      quasi_active_set(),
      literal(),
      primal_dual_active_set(),
      oracle(),
      lemke(),
      one_at_a_time(),
      sweeps(),
      one_gap<WeightRule::FullyCorrective>(
          "surrogate_dual", "one weighted gap; weights best on the face of all vertices in use",
          {Trait::Asymmetric, Trait::Infeasible, Trait::IllConditioned}),
      one_gap<WeightRule::LiteralVertex>(
          "surrogate_dual_vertex",
          "one weighted gap; all weight to the most violated pair, which hops", everything),
      one_gap<WeightRule::Harmonic>(
          "surrogate_dual_harmonic",
          "one weighted gap; weights move 2/(k+2) of the way to that pair"),
      one_gap<WeightRule::LineSearch>(
          "surrogate_dual_line_search",
          "one weighted gap; weights move to that pair by a line search"),
      one_gap<WeightRule::AwaySteps>("surrogate_dual_away_steps",
                                     "one weighted gap; or away from the worst pair in use"),
      one_gap<WeightRule::Pairwise>(
          "surrogate_dual_pairwise",
          "one weighted gap; weight moves from the worst pair to the best"),
      fischer_burmeister(),
      simplex(),
      split("friction_split", "the slip split in u+ and u-, repaired", friction_split),
      split("friction_split_literal", "the slip split in u+ and u-, as printed but for a sign",
            friction_split_literal),
  };
  return family;
}

// A scene without friction is offered these.
// Members that are made for friction alone are left out.
const std::vector<Solver>& solvers() {
  static const std::vector<Solver> members = without(Takes::Only);
  return members;
}

// A scene with friction is offered these, the one to use first.
// Members without friction would refuse its problems.
const std::vector<Solver>& friction_solvers() {
  static const std::vector<Solver> members = without(Takes::No);
  return members;
}

// A name that is not in the list is answered with the nearest one.
//
//     unknown solver 'lemk'; did you mean 'lemke'? There are: quasi_active_set, ...
const Solver& find_solver(const std::string& name) {
  return find_member(all_solvers(), name, "solver");
}

}  // namespace signorini
