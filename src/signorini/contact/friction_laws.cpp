// # Laws of friction
//
// The friction force of a closed pair is bounded, \f$\lvert\tau\rvert \le b = \mu\lambda + C\f$,
// with an offset \f$C\f$. Coulomb's law with cohesion \f$c\f$ has \f$C = c\,w\f$ with the weight
// \f$w\f$ of the pair, because cohesion is a force per area. With \f$\mu = 0.3\f$, \f$c = 2\f$,
// \f$w = 0.5\f$ and \f$\lambda = 10\f$ the pair bears 4. Tresca's law bears \f$c\,w = 1\f$,
// whatever \f$\lambda\f$ is.
//
// With linear bounds contact with friction is a *linear* complementarity problem, for which there
// are methods by pivots and a certificate. A bound that is curved in \f$\lambda\f$ would need
// iterations around it.

#include "signorini/contact/friction_laws.hpp"

#include "signorini/core/family.hpp"

namespace signorini {
namespace {

FrictionBound coulomb(const Friction& friction, double weight) {
  return {friction.coefficient, friction.cohesion * weight};
}

/// Both laws have two numbers, and a scene may give the wrong one. A coefficient that is ignored in
/// silence would look like a result of Tresca's law.
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
