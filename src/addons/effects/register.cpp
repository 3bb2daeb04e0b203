#include "addons/effects/register.hpp"

#include "signorini/scene/effects.hpp"

namespace signorini {

namespace effect {
Effect axial_symmetry(), layers(), temperature(), springs(), adjusted_gaps(), interference();
}

void register_effects() {
  using namespace effect;
  add_effect(axial_symmetry(), "body force");
  for (const Effect& member : {layers(), temperature(), springs(), adjusted_gaps(), interference()})
    add_effect(member, "contact");
}

}  // namespace signorini
