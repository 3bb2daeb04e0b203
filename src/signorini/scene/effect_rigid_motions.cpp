// # Rigid motions as an effect
//
// Supports may leave a motion to a body, as to a disc that only lies on a plate. Its
// amplitude is an unknown of the contact problem, and balance along it is an equation. This
// effect comes last, because gaps and slips can both stop a motion, and they must be known.
// It adds no numbers: the motions are in the plan.

#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/motions.hpp"

namespace signorini::effect {
namespace {

// A motion that contact can stop is an unknown. One that it cannot is an error: a block on a
// smooth floor slides away under the smallest force along it. With friction its slip rows
// feel the slide, and the scene is taken.
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
