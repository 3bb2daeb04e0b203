#include "signorini/contact/gap_operators.hpp"

#include "signorini/core/family.hpp"

namespace signorini {

// The table: one line per function that returns a member.
#define SIGNORINI_GAP_OPERATORS node_to_segment(), gauss_points(), mortar()

namespace gap_operator {
GapOperator SIGNORINI_GAP_OPERATORS;  // declares them
}

const std::vector<GapOperator>& gap_operators() {
  using namespace gap_operator;
  static const std::vector<GapOperator> family = {SIGNORINI_GAP_OPERATORS};
  return family;
}

const GapOperator& find_gap_operator(const std::string& name) {
  return find_member(gap_operators(), name, "gap operator");
}

}  // namespace signorini
