// # Laws by name
//
// A law has a function that answers for a cell. Small strain is a member without that function: its
// cells are those of assembly.cpp. Add-ons add the others, and a program that links none pays
// nothing for them.

#include "signorini/fem/strain_laws.hpp"

#include "signorini/core/family.hpp"

namespace signorini {
namespace {

std::vector<StrainLaw>& family() {
  static std::vector<StrainLaw> members = {
      {"small", "linear elasticity, for strains and turns that are small", nullptr}};
  return members;
}

}  // namespace

const std::vector<StrainLaw>& strain_laws() { return family(); }

void add_strain_law(const StrainLaw& member) { add_member(member, family()); }

// A material points to its law, and to none if strains are small. So whoever adds up cells asks the
// pointer, and not a name.
const StrainLaw* find_strain_law(const std::string& name) {
  const StrainLaw& member = find_member(family(), name, "strain law");
  return member.answer == nullptr ? nullptr : &member;
}

}  // namespace signorini
