/// \file
/// One node with friction so strong that one load has three answers.
#pragma once
#include <vector>

#include "slider.hpp"

namespace ch15 {

/// An equilibrium of the node.
struct Answer {
  ContactStatus contact_status;  ///< what the node does
  double slip;                   ///< along the wall, from where it began [micrometre]
  double force;                  ///< of the wall, compression > 0 [N]
  double friction;               ///< along the wall [N]
};

/// The node is pressed with 0.2 N. Opening a and slip s need forces a - 0.6 s and s - 0.6 a [N, micrometre].
/// \param coefficient  mu [-], not 5/3 \param push  along the wall [N] \return all equilibria that have not slid before
// [answers]
inline std::vector<Answer> answers(double coefficient, double push) {
  const double load = 0.2, coupling = 0.6, bound = coefficient * load;
  std::vector<Answer> found;
  const double opening = (coupling * push - load) / (1 - coupling * coupling);
  if (opening >= 0) found.push_back({ContactStatus::Open, push + coupling * opening, 0, 0});
  if (std::abs(push) <= bound) found.push_back({ContactStatus::Stick, 0, load, -push});
  for (const ContactStatus contact_status :
       {ContactStatus::SlipForward, ContactStatus::SlipBackward}) {
    const double sign = contact_status == ContactStatus::SlipForward ? 1 : -1;
    const double slip = (push - sign * bound) / (1 - sign * coefficient * coupling);
    const double force = load - coupling * slip;
    if (sign * slip > 0 && force > 0)
      found.push_back({contact_status, slip, force, -sign * coefficient * force});
  }
  return found;
}
// [answers]

/// A triangle with that stiffness at its tip, in N and mm. It is pressed until time 1, then pushed to 0.8 N at
/// time 11 and let go until time 21. \param coefficient  mu [-] \return the scene, with 21 steps
inline Scene wedge(double coefficient) {
  Scene scene;
  Body& wedge = scene.bodies[0];
  wedge.mesh.name = "wedge";
  wedge.mesh.nodes.resize(3, 2);
  wedge.mesh.nodes << 1, 0, 1.5, 1.5, 0, 1;
  wedge.mesh.cells.resize(1, 3);
  wedge.mesh.cells << 0, 1, 2;
  wedge.mesh.boundaries = {{"tip", {{0, 0}}}, {"root", {{0, 2}}}};
  wedge.material = {32000. / 15, 1. / 3, PlaneState::Strain, 1};
  wedge.supports = {fixed("root")};
  wedge.loads.points = {{{1.5, 1.5}, {0.2, 0}, "press"}, {{1.5, 1.5}, {0, 1}, "push"}};
  scene.contacts = {{{"tip"}, half_plane({1.5, 0}, {-1, 0})}};
  scene.contacts[0].friction = Friction{coefficient, 0};
  scene.path =
      Path{equal_steps(21, 21), {{"press", {0, 1}, {0, 1}}, {"push", {1, 11, 21}, {0, 0.8, 0}}}};
  return scene;
}

}  // namespace ch15
