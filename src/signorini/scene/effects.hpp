/// \file
/// The family of effects: what a scene may call for besides elastic bodies on supports. To add one: give it an
/// optional entry in Scene, write a `.cpp` with a function of its name that returns it, and put that name into
/// the table in effects.cpp, or, in an add-on, into its register function, which programs call. A scene file of its name
/// beside it, such as friction.toml, is its example: the conformance suite asks for it.
///
/// No step of a run looks at what a scene calls for (checks read it to write notes): plan() asks every effect in the
/// order of the table whether it is present and what it takes, build() makes the plan a model and lets those that are
/// present add their numbers, and what an effect leaves empty no later step sees. So entered load steps: `declare` sorts the loads by the history that they follow,
/// `add` hands the model one p and g per history; the factor and the compliance stay. And so entered *moving geometry*:
/// `declare` says that pairs are searched in every iteration of a step and hands the plan a StepLoop, which asks those effects
/// anew that are `of_pairs`. With *finite strain* that loop writes K and p too, and factors K in each iteration.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// One member of the family.
struct Effect {
  const char* name;  ///< as in `Plan::off`
  /// Whether a scene calls for it; the draft has the bodies and what effects before it in the table took.
  bool (*present)(const Scene& scene, const Plan& draft);
  /// If it is present: checks what the scene says of it, and writes to the draft what it takes, with a line in
  /// `on`. Throws ProblemError for what cannot be meant.
  void (*declare)(const Scene& scene, Plan& draft);
  /// If it is present: adds its rows and loads to a model, which has what was declared, the K and p of the bodies alone,
  /// and the numbers of effects before it in the table. Null if there is nothing to add: materials are read by
  /// assemble(), fits are in the gaps, rigid motions in the plan.
  void (*add)(Model& model);
  /// Whether it writes rows of A: where bodies have moved to, such effects declare and add again, to a draft whose meshes
  /// stand there, see Plan::standing
  bool of_pairs = false;
  /// Lets the given displacements and loads that it takes from the scene, those of Scene::bodies excepted, follow a history.
  /// Asked whether it is present or not. Null if it has none.
  void (*grow)(Scene& scene, const std::string& history) = nullptr;
};

/// The family.
/// \return all members, in the order in which they are asked: loads, contact, friction and rigid motions, which the library
///   has, and those that add-ons added
[[nodiscard]] const std::vector<Effect>& effects();

/// Adds a member to the family, unless it has one of that name. A program does so at its beginning: plans refer to members.
/// \param member  of an add-on
/// \param before  name of the member in front of which it is asked; the last place if there is none of that name
void add_effect(const Effect& member, const std::string& before = "");

}  // namespace signorini
