#include "signorini/as_printed/quasi_active_set_literal.hpp"
#include "signorini/as_printed/surrogate_dual.hpp"
#include "signorini/programme/quasi_active_set_programme.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"
#include "signorini/solvers/floating_newton.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"
#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/linear_programme.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "signorini/solvers/projected_gauss_seidel.hpp"
#include "signorini/solvers/quasi_active_set.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini {

const std::vector<Solver>& solvers() {
  static const std::vector<Solver> family = {
      {"quasi_active_set",
       "whole groups of violated pairs join while the dual energy rises: finite and exact",
       quasi_active_set,
       0,
       {Trait::Asymmetric},
       nullptr,
       quasi_active_set},
      {"quasi_active_set_literal",
       "the paper's equations (30)-(39): minimum moved, one last step; often not optimal",
       quasi_active_set_literal,
       0,
       {Trait::Ordinary, Trait::Asymmetric, Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
        Trait::IllConditioned, Trait::Slow}},
      {"primal_dual_active_set",
       "whole groups of pairs change sides; quasi_active_set where that does not arrive",
       primal_dual_active_set,
       0,
       {Trait::Asymmetric},
       nullptr,
       nullptr,
       primal_dual_active_set},
      {"enumerate",
       "tries every set of closed pairs; the oracle of the tests",
       enumerate,
       largest_enumeration,
       {Trait::Infeasible}},
      {"lemke",
       "complementary pivoting along a path, ties lexicographic; any square matrix",
       lemke,
       0,
       {Trait::IllConditioned, Trait::Slow}},
      {"goldfarb_idnani",
       "dual active set: one pair joins or leaves at a time",
       goldfarb_idnani,
       0,
       {Trait::Asymmetric, Trait::IllConditioned},
       goldfarb_idnani},
      {"projected_gauss_seidel",
       "sweeps: each pair in turn gets the force that closes it",
       projected_gauss_seidel,
       0,
       {Trait::Ordinary, Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
        Trait::IllConditioned, Trait::Slow},
       projected_gauss_seidel},
      {"surrogate_dual",
       "one weighted gap; weights best on the face of all vertices in use",
       surrogate_dual<WeightRule::FullyCorrective>,
       0,
       {Trait::Asymmetric, Trait::Infeasible, Trait::IllConditioned}},
      {"surrogate_dual_vertex",
       "one weighted gap; all weight to the most violated pair, which hops",
       surrogate_dual<WeightRule::LiteralVertex>,
       0,
       {Trait::Asymmetric, Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
        Trait::IllConditioned, Trait::Slow, Trait::Several}},
      {"surrogate_dual_harmonic",
       "one weighted gap; weights move 2/(k+2) of the way to that pair",
       surrogate_dual<WeightRule::Harmonic>,
       0,
       {Trait::Asymmetric, Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
        Trait::IllConditioned, Trait::Slow}},
      {"surrogate_dual_line_search",
       "one weighted gap; weights move to that pair by a line search",
       surrogate_dual<WeightRule::LineSearch>,
       0,
       {Trait::Asymmetric, Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
        Trait::IllConditioned, Trait::Slow}},
      {"surrogate_dual_away_steps",
       "one weighted gap; or away from the worst pair in use",
       surrogate_dual<WeightRule::AwaySteps>,
       0,
       {Trait::Asymmetric, Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
        Trait::IllConditioned, Trait::Slow}},
      {"surrogate_dual_pairwise",
       "one weighted gap; weight moves from the worst pair to the best",
       surrogate_dual<WeightRule::Pairwise>,
       0,
       {Trait::Asymmetric, Trait::Dependent, Trait::Infeasible, Trait::Degenerate,
        Trait::IllConditioned, Trait::Slow}},
      {"fischer_burmeister",
       "one equation per pair, solved by Newton's method with a line search",
       fischer_burmeister,
       0,
       {Trait::Dependent, Trait::Infeasible},
       nullptr,
       nullptr,
       fischer_burmeister},
      {"linear_programme",
       "simplex steps to the least sum of artificial gaps, one pair at a time",
       linear_programme,
       0,
       {Trait::Asymmetric, Trait::Dependent, Trait::Infeasible}},
  };
  return family;
}

}  // namespace signorini
