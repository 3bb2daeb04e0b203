// Moving geometry: pairs of bodies where they have moved to, step by step.
#include "addons/equations/equations.hpp"
#include "addons/motion/moved_scene.hpp"
#include "addons/motion/register.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

void declare_moving(const Scene& scene, Plan& draft) {
  require_input(!scene.contacts.empty() || any_law(scene),
                "bodies move (moves = true), but without contact their places mean nothing: "
                "leave it out");
  move_pairs(scene, draft);
  draft.on.push_back(text(
      "moving geometry: pairs are found anew in every iteration of a step, mostly 4 to 10 of them",
      any_law(scene) ? "" : "; one factor, a compliance each; strains and turns are small"));
}

}  // namespace

void register_motion() {
  add_effect(
      {"moving geometry", [](const Scene& scene, const Plan& /*draft*/) { return scene.moves; },
       declare_moving, nullptr},
      "load steps");
  register_finite_strain();
}

}  // namespace signorini
