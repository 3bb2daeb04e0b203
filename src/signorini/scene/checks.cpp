// # The family of checks
//
// A scene may be legal and still not be what its author meant. Checks look for such scenes
// and write notes. The list begins empty: a check costs time and code, so a program takes
// those of the add-on checks only if it wants them.

#include "signorini/scene/checks.hpp"

#include "signorini/core/family.hpp"

namespace signorini {

// The order in which members are added is the order in which they are asked.
const std::vector<Check>& checks() { return open_family<Check>(); }

void add_check(const Check& member) { add_member(member, open_family<Check>()); }

// Notes come first: those of a solution that is withdrawn say what it would have been.
void check_solution(const Model& model, const Condensed& condensed, Solution& solution) {
  ask_checks(solution.notes, &Check::solution, model, solution);
  for (const Check& check : checks())
    if (check.withdraw != nullptr) check.withdraw(model, condensed, solution);
}

}  // namespace signorini
