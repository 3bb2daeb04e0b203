#include "signorini/contact/friction_laws.hpp"

#include "signorini/core/family.hpp"

namespace signorini {
namespace {

FrictionBound coulomb(const Friction& friction, double weight) {
  return {friction.coefficient, friction.cohesion * weight};
}

FrictionBound tresca(const Friction& friction, double weight) {
  require_input(friction.coefficient == 0, "Tresca's law has no coefficient of friction, got ",
                friction.coefficient,
                ": its bound is the cohesion, whatever presses; leave the coefficient "
                "out, or take the law 'coulomb', which has both");
  require_input(friction.cohesion > 0, "Tresca's law needs a cohesion, got ", friction.cohesion,
                ": give the largest shear traction of sides that touch");
  return {0, friction.cohesion * weight};
}

}  // namespace

const std::vector<FrictionLawMember>& friction_laws() {
  static const std::vector<FrictionLawMember> family = {
      {"coulomb", "mu times the force that presses, and cohesion where the sides touch", coulomb},
      {"tresca", "cohesion where the sides touch, whatever presses", tresca}};
  return family;
}

const FrictionLawMember& find_friction_law(const std::string& name) {
  return find_member(friction_laws(), name, "friction law");
}

}  // namespace signorini
