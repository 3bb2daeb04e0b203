// # Six elements, and how to choose
//
// The same beam tells most of them apart: length 8, height 1, eight square cells, \f$E = 1\f$,
// \f$\nu = 0\f$, clamped at one end and loaded across at the other. Beam theory with shear says
// that the tip moves by 2067. The elements give this part of it:
//
// - q4: 67 %. Shear that bending does not have makes it too stiff.
// - q4_incompatible: 99.5 %. It has the same nodes, and is what we take unless asked otherwise.
// - q8: 99.8 %, with more than twice as many nodes.
//
// A member is a function that returns an Element. Its name stands in one table, so that lists,
// scenes and the conformance suite know it at once. Assembly takes any element and does not know
// the table: a program that names its element itself, q4() say, is linked with that one alone.

#include "signorini/fem/elements.hpp"

#include "signorini/core/family.hpp"
#include "signorini/fem/assembly.hpp"

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

const Element& element_for(const Mesh& mesh, const std::string& name) {
  const Element& element = find_element(name.empty() ? usual_element(mesh) : name);
  check_element(mesh, element);
  return element;
}

}  // namespace signorini
