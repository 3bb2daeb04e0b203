#include "signorini/as_printed/friction_split.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/solvers/friction_active_set.hpp"
#include "signorini/solvers/friction_lemke.hpp"
#include "signorini/solvers/friction_newton.hpp"
#include "signorini/solvers/friction_solvers.hpp"

namespace signorini {

const std::vector<FrictionSolver>& friction_solvers() {
  static const std::vector<FrictionSolver> methods = {
      {"friction_active_set", "all pairs that do the wrong thing change at once, each set exactly",
       friction_active_set},
      {"friction_newton", "one equation per direction, solved by Newton's method, ended exactly",
       friction_newton},
      {"friction_lemke", "one complementarity problem for all, solved by pivoting", friction_lemke},
      {"friction_split", "the slip split in u+ and u-, repaired", friction_split, true},
      {"friction_split_literal", "the slip split in u+ and u-, as printed but for a sign",
       friction_split_literal, true},
  };
  return methods;
}

const FrictionSolver& find_friction_solver(const std::string& name) {
  std::string known;
  for (const FrictionSolver& solver : friction_solvers()) {
    if (solver.name == name) return solver;
    known += (known.empty() ? "" : ", ") + std::string(solver.name);
  }
  throw ProblemError(text("unknown friction solver '", name, "'; known ones: ", known));
}

}  // namespace signorini
