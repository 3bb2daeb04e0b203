#include "signorini/contact/gap_operators.hpp"

#include "signorini/contact/gauss_points.hpp"
#include "signorini/contact/mortar.hpp"
#include "signorini/contact/node_to_segment.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {

const std::vector<GapOperator>& gap_operators() {
  static const std::vector<GapOperator> all = {
      {"node_to_segment", "every node of the source against the side it faces", false, false, false,
       node_to_segment},
      {"gauss_points", "every Gauss point of the source against the side it faces", false, true,
       false, gauss_points},
      {"mortar", "gaps weighted over the edges around every node of the source", true, true, true,
       mortar},
  };
  return all;
}

const GapOperator& find_gap_operator(const std::string& name) {
  std::string known;
  for (const GapOperator& member : gap_operators()) {
    if (member.name == name) return member;
    known += (known.empty() ? "" : ", ") + std::string(member.name);
  }
  throw ProblemError(text("there is no gap operator '", name, "'; known: ", known));
}

}  // namespace signorini
