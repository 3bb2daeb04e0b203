#include "papers/solver_table.hpp"

#include "addons/certified/active_set_programme.hpp"
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

Solver member(const char* name, const char* summary,
              ContactState (*solve)(const ContactProblem&, const SolverOptions&)) {
  return {name, summary, solve};
}

/// What no method for the weights of the surrogate dual promises but the one that ends by itself.
const std::vector<Trait> all_but_several = {
    Trait::Ordinary,   Trait::Asymmetric,     Trait::Dependent, Trait::Infeasible,
    Trait::Degenerate, Trait::IllConditioned, Trait::Slow};
const std::vector<Trait> everything = {Trait::Ordinary,   Trait::Asymmetric, Trait::Dependent,
                                       Trait::Infeasible, Trait::Degenerate, Trait::IllConditioned,
                                       Trait::Slow,       Trait::Several};

/// One weighted gap in the place of all.
std::vector<Solver> weight_rules() {
  return {
      member("surrogate_dual", "one weighted gap; weights best on the face of all vertices in use",
             surrogate_dual<WeightRule::FullyCorrective>)
          .may_fail_on({Trait::Asymmetric, Trait::Infeasible, Trait::IllConditioned}),
      member("surrogate_dual_vertex",
             "one weighted gap; all weight to the most violated pair, which hops",
             surrogate_dual<WeightRule::LiteralVertex>)
          .may_fail_on(everything),
      member("surrogate_dual_harmonic",
             "one weighted gap; weights move 2/(k+2) of the way to that pair",
             surrogate_dual<WeightRule::Harmonic>)
          .may_fail_on(all_but_several),
      member("surrogate_dual_line_search",
             "one weighted gap; weights move to that pair by a line search",
             surrogate_dual<WeightRule::LineSearch>)
          .may_fail_on(all_but_several),
      member("surrogate_dual_away_steps", "one weighted gap; or away from the worst pair in use",
             surrogate_dual<WeightRule::AwaySteps>)
          .may_fail_on(all_but_several),
      member("surrogate_dual_pairwise",
             "one weighted gap; weight moves from the worst pair to the best",
             surrogate_dual<WeightRule::Pairwise>)
          .may_fail_on(all_but_several)};
}

std::vector<Solver> joined(const std::vector<Solver>& first, const std::vector<Solver>& second,
                           const std::vector<Solver>& third) {
  std::vector<Solver> all = first;
  all.insert(all.end(), second.begin(), second.end());
  all.insert(all.end(), third.begin(), third.end());
  return all;
}

/// The members that do not say `no` of friction.
std::vector<Solver> without(Takes no) {
  std::vector<Solver> members;
  for (const Solver& solver : all_solvers())
    if (solver.friction != no) members.push_back(solver);
  return members;
}

}  // namespace

const std::vector<Solver>& all_solvers() {
  static const std::vector<Solver> family = joined(
      {quasi_active_set().on_programmes(quasi_active_set),
       member("quasi_active_set_literal",
              "the paper's equations (30)-(39): minimum moved, one last step; often not optimal",
              quasi_active_set_literal)
           .may_fail_on(all_but_several),
       primal_dual_active_set(),
       member("enumerate", "tries every set of closed pairs; the oracle of the tests", enumerate)
           .up_to(largest_enumeration)
           .may_fail_on({Trait::Infeasible}),
       lemke(),
       member("goldfarb_idnani", "dual active set: one pair joins or leaves at a time",
              goldfarb_idnani)
           .may_fail_on({Trait::Asymmetric, Trait::IllConditioned})
           .on_programmes(goldfarb_idnani),
       member("projected_gauss_seidel", "sweeps: each pair in turn gets the force that closes it",
              projected_gauss_seidel)
           .may_fail_on({Trait::Ordinary, Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
                         Trait::IllConditioned, Trait::Slow})},
      weight_rules(),
      {fischer_burmeister(),
       member("linear_programme",
              "simplex steps to the least sum of artificial gaps, one pair at a time",
              linear_programme)
           .may_fail_on({Trait::Asymmetric, Trait::Dependent, Trait::Infeasible}),
       member("friction_split", "the slip split in u+ and u-, repaired", friction_split)
           .may_fail_on({Trait::Friction})
           .with_friction(Takes::Only)
           .with_rigid_modes(),
       member("friction_split_literal", "the slip split in u+ and u-, as printed but for a sign",
              friction_split_literal)
           .may_fail_on({Trait::Friction})
           .with_friction(Takes::Only)
           .with_rigid_modes()});
  return family;
}

const std::vector<Solver>& solvers() {
  static const std::vector<Solver> members = without(Takes::Only);
  return members;
}

const std::vector<Solver>& friction_solvers() {
  static const std::vector<Solver> members = without(Takes::No);
  return members;
}

const Solver& find_solver(const std::string& name) {
  return find_member(all_solvers(), name, "solver");
}

}  // namespace signorini
