// # The table of effects
//
// An effect is what a scene may have besides bodies on supports. The plan goes through this
// table once and asks every member. So the order matters. Initial overlap and friction look
// at the pairs that contact declares. A rigid motion may be stopped by a gap or by a slip.
// So contact comes before the first two, and rigid motions come last.
//
// Add-ons insert their members by name. For example, adjusted gaps stand before contact,
// because they change gaps that contact counts.

#include "signorini/scene/effects.hpp"

#include "signorini/core/family.hpp"

namespace signorini {

// One function per member. Its name stands here once: the line with `Effect` below declares
// it, and the list calls it.
#define SIGNORINI_EFFECTS                                                               \
  body_force(), edge_loads(), point_forces(), contact(), initial_overlap(), friction(), \
      cohesion(), rigid_motions()

namespace effect {
Effect SIGNORINI_EFFECTS;  // declares them
}

namespace {

// The list may grow until a scene is planned. A plan keeps pointers to members, and a
// growing list would move them.
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
