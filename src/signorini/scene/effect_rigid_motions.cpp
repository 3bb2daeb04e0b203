#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/motions.hpp"

namespace signorini::effect {
namespace {

/// Motions that supports leave are unknowns if contact can stop them, and errors if not.
void price(const Scene& scene, Plan& draft) {
  for (const FreeMotion& mode : draft.modes)
    draft.on.push_back(mode.sentence + ": only contact holds it, one amplitude");
  const NodalRows felt = contact_rows(draft.gaps, draft.law);
  std::string loose;
  for (const std::string& motion : motions_without_contact(felt, draft.modes))
    loose += (loose.empty() ? "" : "; ") + motion;
  pose(loose.empty(), loose,
       scene.contacts.empty() ? ": add a support" : ", and no contact stops that: add a support");
}

}  // namespace

Effect rigid_motions() {
  return {"rigid motions",
          [](const Scene& /*scene*/, const Plan& draft) { return !draft.modes.empty(); }, price,
          [](Plan& plan, Model& model) { model.modes = std::move(plan.modes); }};
}

}  // namespace signorini::effect
