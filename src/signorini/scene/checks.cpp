#include "signorini/scene/checks.hpp"

#include "signorini/core/family.hpp"

namespace signorini {
namespace {

std::vector<Check>& all_checks() {
  static std::vector<Check> family;
  return family;
}

}  // namespace

const std::vector<Check>& checks() { return all_checks(); }

void add_check(const Check& member) { add_member(member, all_checks()); }

}  // namespace signorini
