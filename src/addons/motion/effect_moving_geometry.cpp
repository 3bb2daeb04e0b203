// Moving geometry: pairs of bodies where they have moved to, step by step.
#include <memory>
#include <utility>

#include "addons/motion/moved_pairs.hpp"
#include "addons/motion/moving_step.hpp"
#include "addons/motion/register.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

constexpr const char* moves = "bodies move (moves = true)";

/// A contact whose pairs can be found where bodies have moved to. Node to segment fails as nodes pass the corners of sides,
/// where its normals jump; a gap that was changed in the mesh is not the one that is found anew.
void check_contact(const ContactSpec& contact, const Plan& draft) {
  const std::string what = describe(draft.bodies, contact);
  if (std::holds_alternative<Side>(contact.target))
    require_input(contact.gap_operator == "mortar" && contact.quadrature == Quadrature::Segments,
                  what, ": where ", moves, ", gaps must not jump as nodes pass from side to side: ",
                  "take operator = \"mortar\" with quadrature = \"segments\"");
  require_input(contact.interference.value_or(0) == 0 && contact.adjust.value_or(0) == 0, what,
                ": where ", moves,
                ", gaps are those of the meshes: draw interference or adjusted "
                "gaps into them");
  require_input(!contact.small_sliding, what, ": where ", moves,
                ", no sliding is too far: leave small_sliding out");
}

/// What the loop needs of a scene when it finds pairs anew: no meshes and no loads.
std::shared_ptr<const Scene> contacts_of(const Scene& scene) {
  auto some = std::make_shared<Scene>();
  some->contacts = scene.contacts;
  some->solver = scene.solver;
  some->bodies.clear();
  for (const Body& body : scene.bodies) {
    some->bodies.emplace_back();
    some->bodies.back().supports = body.supports;
  }
  return some;
}

void declare_moving(const Scene& scene, Plan& draft) {
  require_input(scene.path.has_value(), moves,
                ": they do so in load steps, even if it is one: add [[steps]] with until = 1 and "
                "count = 1 or more");
  require_input(!scene.contacts.empty(), moves,
                ", but without contact their places mean nothing: "
                "leave it out");
  for (const ContactSpec& contact : scene.contacts) check_contact(contact, draft);
  draft.followed.reset();
  draft.loop = std::make_shared<const StepLoop>(
      moving_step([contacts = contacts_of(scene)](const NodeArray& displacement,
                                                  const NodeArray& before, Model& model) {
        place_bodies(*contacts, displacement, before, model);
      }));
  draft.on.push_back(
      text("moving geometry: pairs are found anew in every iteration of a step, 5 to "
           "15 of them; one factor, a compliance each; strains and turns are small"));
}

}  // namespace

void register_motion() {
  add_effect(
      {"moving geometry", [](const Scene& scene, const Plan& /*draft*/) { return scene.moves; },
       declare_moving, nullptr},
      "load steps");
}

}  // namespace signorini
