// Finite strain: bodies whose material has a law, step by step, with pairs where they have moved to.
#include "addons/equations/equations.hpp"
#include "addons/motion/finite_strain.hpp"
#include "addons/motion/law_limits.hpp"
#include "addons/motion/moved_scene.hpp"
#include "addons/motion/register.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/checks.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

const char* name_of(const StrainLaw* law) { return law == nullptr ? "small" : law->name; }

/// A cell of small strain in a body that turns would be wrong. A cell with a law in a body of small strain would be of no use.
void check_layers(const Body& body) {
  for (const Layer& layer : body.layers)
    require_input((layer.material.law != nullptr) == (body.material.law != nullptr), "layer '",
                  layer.region, "' of '", body.mesh.name, "': it has the law ", name_of(layer.material.law),
                  ", but its body ", name_of(body.material.law),
                  "; either all of a body has laws of finite strain, or nothing of it");
}

/// An element that a law can be asked in. Internal modes of a cell in compression find hourglasses that resist nothing.
void check_element(const Body& body, const BodyModel& planned) {
  const std::string what =
      text("body '", planned.mesh.name, "' with the law ", body.material.law->name);
  require_input(planned.element.relax == nullptr, what, ": ", planned.element.name,
                " bends into hourglasses when it is pressed; take q4_bbar, q4, q8, t3 or t6");
  require_input(!planned.material.eigenstrain, what,
                ": a temperature is for small strain; leave the law out, or the temperature");
}

void declare_finite_strain(const Scene& scene, Plan& draft) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    check_layers(scene.bodies[b]);
    if (scene.bodies[b].material.law == nullptr) continue;
    check_element(scene.bodies[b], draft.bodies[b]);
    draft.on.push_back(text("finite strain of '", draft.bodies[b].mesh.name, "': ",
                            scene.bodies[b].material.law->name,
                            "; mostly 4 to 10 tangents a step, each with pairs where bodies stand then, "
                            "and a factor"));
    if (draft.bodies[b].material.base.state == PlaneState::Stress && !scene.contacts.empty())
      draft.notes.push_back(text("'", draft.bodies[b].mesh.name,
                                 "' is a sheet that becomes thinner or thicker: pressures and shear of its "
                                 "contacts are forces over lengths where it stands and its thickness before strain"));
  }
  move_pairs(scene, draft);
}

}  // namespace

void register_finite_strain() {
  add_strain_law(st_venant_kirchhoff());
  add_strain_law(neo_hooke());
  add_check({"limits of strain laws", nullptr, nullptr, nullptr, notes_on_laws, nullptr});
  add_effect({"finite strain",
              [](const Scene& scene, const Plan& /*draft*/) { return any_law(scene); },
              declare_finite_strain, nullptr},
             "load steps");
}

}  // namespace signorini
