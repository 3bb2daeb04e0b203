#include "signorini/complementarity/solvers.hpp"

#include <algorithm>

#include "signorini/complementarity/enumerate.hpp"
#include "signorini/complementarity/primal_dual_active_set.hpp"
#include "signorini/complementarity/quasi_active_set.hpp"
#include "signorini/core/errors.hpp"

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
      {"primal_dual_active_set",
       "whole groups of pairs change sides; single exchanges if a set repeats",
       primal_dual_active_set,
       0,
       {Trait::Asymmetric, Trait::Dependent, Trait::Infeasible, Trait::IllConditioned}},
      {"enumerate",
       "tries every set of closed pairs; the oracle of the tests",
       enumerate,
       largest_enumeration,
       {Trait::Asymmetric}},
  };
  return family;
}

const char* to_string(Trait trait) {
  switch (trait) {
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
