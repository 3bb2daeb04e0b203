// # The family of gap operators
//
// A gap operator finds the pairs between two meshes. The list begins empty: a scene with rigid
// obstacles needs none, and a program with two bodies gets those of
// [pairing](../pairing/gap_operators.cpp) by being linked with that folder.

#include "signorini/contact/gap_operators.hpp"

#include "signorini/core/family.hpp"

namespace signorini {
namespace {

// Made when it is first asked for, which may be before main().
std::vector<GapOperator>& family() {
  static std::vector<GapOperator> members;
  return members;
}

}  // namespace

const std::vector<GapOperator>& gap_operators() { return family(); }

void add_gap_operator(const GapOperator& member) { add_member(member, family()); }

const GapOperator& find_gap_operator(const std::string& name) {
  return find_member(gap_operators(), name, "gap operator");
}

}  // namespace signorini
