#include "addons/motion/moved_scene.hpp"

#include <memory>

#include "addons/equations/take_equations.hpp"
#include "addons/motion/moved_pairs.hpp"
#include "addons/motion/moving_step.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

/// A contact whose pairs can be found where bodies have moved to. Node to segment fails as nodes pass the corners of sides,
/// where its normals jump; a gap that was changed in the mesh is not the one that is found anew.
void check_contact(const ContactSpec& contact, const Plan& draft) {
  const std::string what = describe(draft.bodies, contact);
  if (std::holds_alternative<Side>(contact.target))
    require_input(contact.gap_operator == "mortar" && contact.quadrature == Quadrature::Segments,
                  what, ": gaps of bodies that move must not jump as nodes pass from side to side, as ",
                  "those of the operator ", contact.gap_operator, " do here: take operator = ",
                  "\"mortar\" with quadrature = \"segments\"");
  const Obstacle* const obstacle = std::get_if<Obstacle>(&contact.target);
  require_input(obstacle == nullptr || !obstacle->of_mesh, what, ": this obstacle is made for small movements, and bodies of "
                "this scene move: take kind = \"disc\", of the radius of the hole less the clearance, at hole_centre + shift");
  require_input(contact.interference.value_or(0) == 0 && contact.adjust.value_or(0) == 0, what,
                ": gaps of bodies that move are those of the meshes: draw ",
                contact.adjust.value_or(0) == 0 ? "the interference" : "adjusted gaps",
                " into them, and leave the key out");
  require_input(!contact.small_sliding, what,
                ": where bodies move no sliding is too far: leave small_sliding out");
}

/// What the loop needs of a scene when it finds pairs anew: no meshes and no loads.
std::shared_ptr<const Scene> contacts_of(const Scene& scene) {
  auto some = std::make_shared<Scene>();
  some->contacts = scene.contacts;
  some->solver = scene.solver;
  some->bodies.resize(scene.bodies.size());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    some->bodies[b].supports = scene.bodies[b].supports;
  return some;
}

}  // namespace

void move_pairs(const Scene& scene, Plan& draft) {
  require_input(scene.path.has_value(),
                any_law(scene) ? "a material has a law of finite strain" : "bodies move (moves = true)",
                ", which takes load steps: add [[steps]] with until = 1 and count = 1 or more");
  for (const ContactSpec& contact : scene.contacts) check_contact(contact, draft);
  draft.followed.reset();
  draft.loop = std::make_shared<const StepLoop>(moving_step(
      [contacts = contacts_of(scene)](const Displaced& displacement, const Displaced& before,
                                      Model& model) {
        place_bodies(*contacts, displacement, before, model);
        if (model.equations) take_equations_of_rows(displacement, model);
      }));
}

}  // namespace signorini
