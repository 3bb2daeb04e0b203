// # The members of the portfolio
//
// A method says how it goes on, and no method calls another. What a method promises, and who is
// asked where it does not arrive, stands here, for all of them in one place.
//
// A promise is kept by what it leaves out: a member lists the traits of problems on which it may
// end without a solution, and the conformance suite tries it on all others. The order in which
// members are asked decides about time only. Where two rows repeat each other, the exchange of all
// wrong pairs may give up; a method that lets pairs join one after the other leaves the second row
// out, and is asked next.

#include "signorini/solvers/fischer_burmeister.hpp"
#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace signorini {

// The method is fast where it arrives. The three others arrive more surely: quasi_active_set()
// raises an energy with each set, fischer_burmeister() shortens its steps until a residual falls,
// and lemke() follows a path that cannot cycle.
Solver primal_dual_active_set() {
  return Solver{
      "primal_dual_active_set",
      "whole groups of pairs change what they do; another method where that does not arrive",
      primal_dual_active_set}
      .may_fail_on({Trait::Asymmetric})
      .with_friction(Takes::Also)
      .with_rigid_modes()
      .before({quasi_active_set, fischer_burmeister, lemke});
}

// The dual energy belongs to a symmetric matrix. Without symmetry there is nothing that rises.
Solver quasi_active_set() {
  return Solver{"quasi_active_set",
                "whole groups of violated pairs join while the dual energy rises: finite and exact",
                quasi_active_set}
      .may_fail_on({Trait::Asymmetric});
}

// Rows that repeat each other make the Jacobian singular, so it may fail on them. The primal-dual
// active set can leave such rows out, and is asked next.
Solver fischer_burmeister() {
  return Solver{"fischer_burmeister",
                "one equation per pair, solved by Newton's method with a line search",
                fischer_burmeister}
      .may_fail_on({Trait::Dependent, Trait::Infeasible})
      .with_friction(Takes::Also)
      .with_rigid_modes()
      .before({primal_dual_active_set, lemke});
}

// It takes any matrix, and nothing is asked after it: it is the last one.
Solver lemke() {
  return Solver{"lemke",
                "complementary pivoting along a path, ties lexicographic; any square matrix", lemke}
      .may_fail_on({Trait::IllConditioned, Trait::Slow})
      .with_friction(Takes::Also)
      .with_rigid_modes();
}

}  // namespace signorini
