#include "addons/files/inp_elements.hpp"

namespace signorini {

// A name such as CPS4R is a family, a number of nodes, and letters.
InpElementType inp_element_type(const std::string& name) {
  if (name == "STRI65") return {3, 6, 3};
  const auto is = [&](const std::string& family) { return name.rfind(family, 0) == 0; };
  for (const char* const family : {"B2", "B3", "T2D", "T3D", "R2D", "RAX", "SAX"})
    if (is(family)) return {2, 0};
  for (const std::string family : {"CPS", "CPE", "CPEG", "CAX", "CGAX", "M3D", "S", "STRI"}) {
    if (!is(family) || name.size() == family.size()) continue;
    const std::string rest = name.substr(family.size() + 1);  // of S8R5 the 5 counts freedoms
    if (rest.find_first_of("0123456789") != rest.npos && rest != "R5") continue;
    const int first_side = family[0] == 'C' ? 1 : 3;
    const char nodes = name[family.size()];
    if (nodes == '3' || nodes == '6') return {3, nodes == '3' ? 3U : 6U, first_side};
    if (nodes == '4' || nodes == '8') return {4, nodes == '4' ? 4U : 8U, first_side};
  }
  return {};
}

const std::map<std::string, const char*>& inp_refused() {
  constexpr const char* numbers =
      "write all nodes and elements out, as a pre-processor does, or as meshio convert does";
  static const std::map<std::string, const char*> all = {
      {"INCLUDE", "put that file in the place of this line"},
      {"SYSTEM", "write the nodes in the coordinates of the whole"},
      {"NGEN", numbers},
      {"NFILL", numbers},
      {"NCOPY", numbers},
      {"NMAP", numbers},
      {"ELGEN", numbers},
      {"ELCOPY", numbers},
      {"SYMMETRIC MODEL GENERATION", numbers}};
  return all;
}

}  // namespace signorini
