// # What a scene must not be
//
// Some mistakes show in the scene alone, before a mesh is looked at. They are refused here, in
// the words of the user, and cost nothing.
//
// - Names. A contact says 'disc' and means the body of that name, so that no two bodies may
//   have it.
// - Effects. The library knows loads, contact, friction and rigid motions. A scene may also
//   have a temperature, which an add-on computes. In a program without that add-on the
//   temperature would be left out silently, and the answer would be wrong.
// - Histories. A load may follow a history, say first up and then down. Without load steps
//   there is nothing to follow.
//
// One mistake shows only in the numbers of the condensed problem: units in which a length or a
// load is far beyond what a double can square. With a modulus of \f$ 10^{200} \f$ a compliance
// is \f$ 10^{-200} \f$, and its square is 0.

#include "signorini/scene/check_scene.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {
namespace {

// Contacts refer to bodies by name. If two bodies had the same name, a contact could mean
// either of them. A solver and a back end are structs of functions. A program that fills one by
// hand may leave a function out, and would then jump to nowhere after minutes of assembly.
void check_names(const Scene& scene) {
  require_input(!scene.bodies.empty(), "a scene needs at least one body");
  std::set<std::string> names;
  for (const Body& body : scene.bodies)
    require_input(names.insert(body.mesh.name).second, "two bodies are called '", body.mesh.name,
                  "': give every mesh a name of its own");
  require_input(
      scene.solver.solve != nullptr && scene.backend.factor != nullptr,  // needed or not
      "a scene's solver and back end must be members of their families, got one without a ",
      "function: take find_solver(name) and find_backend(name), or leave the defaults");
}

// Refuses what an add-on does that the program has not. A program without the add-on would
// leave a temperature out silently, and its answer would be wrong.
void check_effects(const Scene& scene) {
  const auto check = [](bool wanted, const std::string& name, const char* function) {
    const auto named = [&name](const Effect& effect) { return effect.name == name; };
    require_input(!wanted || std::any_of(effects().begin(), effects().end(), named),
                  "the scene has ", name, ", which this program does not know: call ", function,
                  "() before the scene is planned");
  };
  const char* const own = "register_effects";
  check(scene.path.has_value(), "load steps", "register_load_steps");
  check(scene.bonds != nullptr, "equations", "register_equations");
  for (const Body& body : scene.bodies) {
    check(body.material.state == PlaneState::Axial, "axial symmetry", own);
    check(!body.layers.empty(), "layers", own);
    check(body.temperature.has_value(), "temperature", own);
    check(!body.springs.empty(), "springs", own);
  }
  for (const ContactSpec& contact : scene.contacts) {
    check(contact.adjust.has_value(), "adjusted gaps", own);
    check(contact.interference.has_value(), "interference", own);
    require_input(std::holds_alternative<Obstacle>(contact.target) || !gap_operators().empty(),
                  "the scene has contact between two meshes, for which this program has no gap "
                  "operator: link it with signorini::pairing");
  }
}

// Refuses loads that would follow a history that is not there. A push that follows the history
// 'shake' would otherwise be a push that is always there, the same numbers with another meaning.
// All that may follow one is visited in one place, each_history(), so that nothing is forgotten.
void check_histories(const Scene& scene) {
  if (scene.path) return;
  const auto none = [](const std::string& what, const std::string& history) {
    require_input(history.empty(), what, " follows the history '", history,
                  "', but the scene has no load steps: give it a `path`, or leave the history out");
  };
  for (const Body& body : scene.bodies)
    each_history(body, [&](const std::string& history) {
      none("something of the body '" + body.mesh.name + "'", history);
    });
  for (const ContactSpec& contact : scene.contacts)
    none("the interference of a contact", contact.interference_history);
}

}  // namespace

// The order is that in which a user would mend them: without names no message could say where.
void check_scene(const Scene& scene) {
  check_names(scene);
  check_effects(scene);
  check_histories(scene);
}

// A solver that meets an infinite number blames its caller. Here the caller is the library,
// and the number comes from the units of the scene.
void check_numbers(const ContactProblem& problem) {
  try {
    check_finite(problem);
  } catch (const std::invalid_argument& error) {
    throw ProblemError(text("the scene cannot be solved in these units: ", error.what(),
                            "; look for a modulus, thickness, load, friction or length that is far "
                            "larger or smaller than the others"));
  }
}

}  // namespace signorini
