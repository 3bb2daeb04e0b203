#include "signorini/solvers/solvers.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/errors.hpp"

namespace signorini {

const char* to_string(Trait trait) {
  switch (trait) {
    case Trait::Ordinary:
      return "ordinary";
    case Trait::Asymmetric:
      return "asymmetric";
    case Trait::Dependent:
      return "dependent";
    case Trait::Infeasible:
      return "infeasible";
    case Trait::Degenerate:
      return "degenerate";
    case Trait::IllConditioned:
      return "ill-conditioned";
    case Trait::Slow:
      return "slow";
    case Trait::Several:
      return "several pairs";
    case Trait::Friction:
      return "friction";
  }
  return "unknown";
}

bool may_fail(const Solver& solver, Trait trait) {
  return std::find(solver.may_fail.begin(), solver.may_fail.end(), trait) != solver.may_fail.end();
}

std::string too_many(const Solver& solver, Eigen::Index pairs) {
  if (solver.largest == 0 || pairs <= solver.largest) return "";
  return text("takes at most ", solver.largest, " pairs, here are ", pairs);
}

bool takes(const Solver& solver, const ContactProblem& problem) {
  const bool frictional = !problem.law.pair.empty();
  return too_many(solver, problem.free_gap.size()).empty() &&
         solver.friction != (frictional ? Takes::No : Takes::Only) &&
         (frictional || !may_fail(solver, Trait::Asymmetric) || is_symmetric(problem));
}

Solver Solver::up_to(Eigen::Index pairs) const {
  Solver member = *this;
  member.largest = pairs;
  return member;
}

Solver Solver::may_fail_on(std::vector<Trait> traits) const {
  Solver member = *this;
  member.may_fail = std::move(traits);
  return member;
}

Solver Solver::with_friction(Takes takes) const {
  Solver member = *this;
  member.friction = takes;
  return member;
}

Solver Solver::with_rigid_modes() const {
  Solver member = *this;
  member.rigid_modes = true;
  return member;
}

Solver Solver::before(std::vector<Solver (*)()> members) const {
  Solver member = *this;
  member.others = std::move(members);
  return member;
}

Solver Solver::on_programmes(decltype(solve_programme) function) const {
  Solver member = *this;
  member.solve_programme = function;
  return member;
}

}  // namespace signorini
