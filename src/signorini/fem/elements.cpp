#include "signorini/fem/elements.hpp"

#include "signorini/core/family.hpp"

namespace signorini {

// The table: one line per function that returns a member.
#define SIGNORINI_ELEMENTS q4(), q4_bbar(), q4_incompatible(), q8(), t3(), t6()

Element SIGNORINI_ELEMENTS;  // declares them

const std::vector<Element>& elements() {
  static const std::vector<Element> family = {SIGNORINI_ELEMENTS};
  return family;
}

const Element& find_element(const std::string& name) {
  return find_member(elements(), name, "element");
}

}  // namespace signorini
