#include "signorini/elasticity/elements.hpp"

#include "signorini/core/errors.hpp"

namespace signorini {

// The table: one line per function that returns a member.
#define SIGNORINI_ELEMENTS q4(), q4_bbar(), q4_incompatible(), q8()

Element SIGNORINI_ELEMENTS;  // declares them

const std::vector<Element>& elements() {
  static const std::vector<Element> family = {SIGNORINI_ELEMENTS};
  return family;
}

const Element& find_element(const std::string& name) {
  std::string known;
  for (const Element& element : elements()) {
    if (element.name == name) return element;
    known += (known.empty() ? "" : ", ") + std::string(element.name);
  }
  throw ProblemError(text("unknown element '", name, "'; known elements: ", known));
}

}  // namespace signorini
