#include "signorini/complementarity/solvers.hpp"

#include "signorini/complementarity/enumerate.hpp"
#include "signorini/complementarity/primal_dual_active_set.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {

const std::vector<Solver>& solvers() {
  static const std::vector<Solver> family = {
      {"primal_dual_active_set",
       "whole groups of pairs change sides; single exchanges if a set repeats",
       primal_dual_active_set, 0},
      {"enumerate", "tries every set of closed pairs; the oracle of the tests", enumerate,
       largest_enumeration},
  };
  return family;
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
