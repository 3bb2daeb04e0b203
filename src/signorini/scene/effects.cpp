#include "signorini/scene/effects.hpp"

#include "signorini/core/family.hpp"

namespace signorini {

// The table: one line per function that returns a member.
#define SIGNORINI_EFFECTS                                                               \
  body_force(), edge_loads(), point_forces(), contact(), initial_overlap(), friction(), \
      cohesion(), rigid_motions()

namespace effect {
Effect SIGNORINI_EFFECTS;  // declares them
}

namespace {

std::vector<Effect>& all_effects() {
  using namespace effect;
  static std::vector<Effect> family = {SIGNORINI_EFFECTS};
  return family;
}

}  // namespace

const std::vector<Effect>& effects() { return all_effects(); }

void add_effect(const Effect& member, const std::string& before) {
  add_member(member, all_effects(), before);
}

}  // namespace signorini
