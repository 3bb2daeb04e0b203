#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/motions.hpp"

namespace signorini::effect {
namespace {

/// Motions that supports leave are unknowns if contact can stop them, and errors if not.
void declare_motions(const Scene& scene, Plan& draft) {
  for (const FreeMotion& mode : draft.modes)
    draft.on.push_back(in_words(mode) + ": only contact holds it, one amplitude");
  const NodalRows felt = contact_rows(draft.gaps, draft.law);
  const std::string loose = joined(motions_without_contact(felt, draft.modes), "; ");
  require_input(
      loose.empty(), loose,
      scene.contacts.empty() ? ": add a support" : ", and no contact stops that: add a support");
}

}  // namespace

Effect rigid_motions() {
  return {"rigid motions",
          [](const Scene& /*scene*/, const Plan& draft) { return !draft.modes.empty(); },
          declare_motions, nullptr};
}

}  // namespace signorini::effect
