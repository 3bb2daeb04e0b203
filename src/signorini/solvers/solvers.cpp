#include "signorini/solvers/solvers.hpp"

#include <algorithm>

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
  }
  return "unknown";
}

bool may_fail(const Solver& solver, Trait trait) {
  return std::find(solver.may_fail.begin(), solver.may_fail.end(), trait) != solver.may_fail.end();
}

const Solver& find_solver(const std::string& name) {
  std::string known;
  for (const Solver& solver : solvers()) {
    if (solver.name == name) return solver;
    known += (known.empty() ? "" : ", ") + std::string(solver.name);
  }
  throw ProblemError(text("unknown solver '", name, "'; known solvers: ", known));
}

}  // namespace signorini
