#include "signorini/scene/effects.hpp"

namespace signorini {

// The table: one line per function that returns a member.
#define SIGNORINI_EFFECTS                                                                   \
  axial_symmetry(), body_force(), edge_loads(), point_forces(), layers(), temperature(),    \
      springs(), adjusted_gaps(), interference(), contact(), initial_overlap(), friction(), \
      cohesion(), rigid_motions(), load_steps()

namespace effect {
Effect SIGNORINI_EFFECTS;  // declares them
}

const std::vector<Effect>& effects() {
  using namespace effect;
  static const std::vector<Effect> family = {SIGNORINI_EFFECTS};
  return family;
}

}  // namespace signorini
