// # The family of gap operators
//
// A gap operator finds the pairs between two meshes. The list begins empty: a scene with rigid
// obstacles needs none, and a program with two bodies gets those of
// [pairing](../pairing/gap_operators.cpp) by being linked with that folder.

#include "signorini/contact/gap_operators.hpp"

#include "signorini/core/family.hpp"

namespace signorini {

const std::vector<GapOperator>& gap_operators() { return open_family<GapOperator>(); }

// A name is added once, whoever adds it.
void add_gap_operator(const GapOperator& member) { add_member(member, open_family<GapOperator>()); }

const GapOperator& find_gap_operator(const std::string& name) {
  return find_member(gap_operators(), name, "gap operator");
}

}  // namespace signorini
