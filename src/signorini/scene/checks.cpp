// # The family of checks
//
// A scene may be legal and still not be what its author meant. Checks look for such scenes
// and write notes. The list begins empty: a check costs time and code, so a program takes
// those of the add-on checks only if it wants them.

#include "signorini/scene/checks.hpp"

#include "signorini/core/family.hpp"

namespace signorini {
namespace {

// The list is made when it is first asked for. A global object might not exist yet when
// another file adds its members before `main`.
std::vector<Check>& all_checks() {
  static std::vector<Check> family;
  return family;
}

}  // namespace

const std::vector<Check>& checks() { return all_checks(); }

void add_check(const Check& member) { add_member(member, all_checks()); }

// Notes come first: those of a solution that is withdrawn say what it would have been.
void judge_solution(const Model& model, const Condensed& condensed, Solution& solution) {
  ask_checks(solution.notes, &Check::solution, model, solution);
  for (const Check& check : checks())
    if (check.judge != nullptr) check.judge(model, condensed, solution);
}

}  // namespace signorini
