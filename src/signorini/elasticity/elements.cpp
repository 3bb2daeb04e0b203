#include "signorini/elasticity/elements.hpp"

#include "signorini/core/errors.hpp"

namespace signorini {

const std::vector<Element>& elements() {
  static const std::vector<Element> family = {q4(), q4_bbar(), q4_incompatible(), q8()};
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
