// # What a method says of itself
//
// All methods for contact have one signature: a problem goes in, and a state comes out. They differ
// in what they can do. Enumeration accepts 12 pairs; the dual active set needs a symmetric matrix;
// some take friction, and some take bodies that only contact holds. A `Solver` is the function
// together with these facts.
//
// The facts are data and not code, because others read them. A portfolio passes over a member that
// does not take a problem. The conformance suite runs every member on every kind of problem, and
// allows a failure only on the traits that the member names in `may_fail`. A member that claims too
// much is found out there.
//
// Most members have most facts in common. So a member starts with three arguments, the name, one
// line of text and the function, and names only what is different:
//
//     Solver{"fischer_burmeister", "one equation per pair, ...", fischer_burmeister}
//         .may_fail_on({Trait::Dependent, Trait::Infeasible})
//         .with_friction(Takes::Also)
//         .with_rigid_modes()

#include "signorini/solvers/solvers.hpp"

#include <algorithm>
#include <iterator>

#include "signorini/core/errors.hpp"

namespace signorini {

// Traits are printed where a test says on which kind of problem a member failed.
const char* to_string(Trait trait) {
  constexpr const char* words[] = {"ordinary",   "asymmetric",    "dependent",
                                   "infeasible", "degenerate",    "ill-conditioned",
                                   "slow",       "several pairs", "friction"};
  static_assert(std::size(words) == static_cast<std::size_t>(Trait::Friction) + 1);
  return words[static_cast<std::size_t>(trait)];
}

// Lists of traits have a few entries, so a search from the front is fast enough.
bool may_fail(const Solver& solver, Trait trait) {
  return std::find(solver.may_fail.begin(), solver.may_fail.end(), trait) != solver.may_fail.end();
}

// The bound is a fact of the method: enumeration would need \f$ 2^{40} \f$ sets for 40 pairs. The
// reason is returned as text, so that a message can name the bound.
std::string too_many(const Solver& solver, Eigen::Index pairs) {
  if (solver.largest == 0 || pairs <= solver.largest) return "";
  return text("takes at most ", solver.largest, " pairs, here are ", pairs);
}

// Without friction a member must take the matrix as it is. With friction no one asks for symmetry:
// a sliding pair makes the equations unsymmetric in any case.
bool takes(const Solver& solver, const ContactProblem& problem) {
  const bool frictional = !problem.law.pair.empty();
  return too_many(solver, problem.free_gap.size()).empty() &&
         solver.friction != (frictional ? Takes::No : Takes::Only) &&
         (frictional || !may_fail(solver, Trait::Asymmetric) || is_symmetric(problem));
}

}  // namespace signorini
