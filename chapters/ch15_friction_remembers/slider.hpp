/// \file
/// A spring that drags a tip along a wall: by hand, and as one triangle of the library.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "addons/steps/steps.hpp"
#include "signorini/core/errors.hpp"

namespace ch15 {

using namespace signorini;

constexpr double k = 20;             // stiffness of the spring [N/mm]
constexpr double pressed = 10;       // force that presses the tip on the wall [N]
constexpr double B = 0.5 * pressed;  // bound of the friction force, mu = 0.5 [N]
constexpr double U = 1;              // the hand goes to and fro by so much [mm]

/// What a spring with a sliding tip remembers. \param place  slip in total [mm] \param lost  [N mm]
// [by hand]
struct Tip {
  double place = 0;  // slip in total [mm]
  double lost = 0;   // dissipated so far [N mm]
};

inline double drag(double hand, Tip& tip) {
  const double stuck = k * (hand - tip.place);   // pull of the spring if the tip stays [N]
  const double pull = std::clamp(stuck, -B, B);  // friction bears no more than B
  const double slip = (stuck - pull) / k;        // so the tip moves until it does
  tip.place += slip;                             // and stays where it has come to
  tip.lost += std::abs(pull * slip);
  return pull;
}
// [by hand]

/// \return the way of the hand: to U, to -U and back to U, 1 mm in a unit of time
inline History to_and_fro() { return {"hand", {0, 1, 3, 5}, {0, U, -U, U}}; }

/// One triangle: its root is the hand, its tip rubs on the wall x = 2. By symmetry its stiffness is diagonal; along
/// the wall it is E / (4 (1 + nu)) = k. \param times  of the steps \return the scene
inline Scene triangle(const std::vector<double>& times) {
  Scene scene;
  Body& spring = scene.bodies[0];
  spring.mesh.name = "spring";
  spring.mesh.nodes.resize(3, 2);
  spring.mesh.nodes << 0, -1, 2, 0, 0, 1;
  spring.mesh.cells.resize(1, 3);
  spring.mesh.cells << 0, 1, 2;
  spring.mesh.boundaries = {{"tip", {{0, 0}}}, {"root", {{0, 2}}}};
  spring.material = {100, 0.25, PlaneState::Stress, 1};
  // [path]
  spring.supports = {prescribed("root", Axis::X, 0), prescribed("root", Axis::Y, 1)};
  spring.supports[1].history = "hand";
  spring.loads.points = {{{2, 0}, {pressed, 0}}};
  scene.contacts = {{{"tip"}, half_plane(/*point*/ {2, 0}, /*normal out of it*/ {-1, 0})}};
  scene.contacts[0].friction = Friction{B / pressed, 0};
  scene.path = Path{times, {to_and_fro()}};
  // [path]
  return scene;
}

/// What would come out if slip were counted in total: each load for itself, from rest.
/// \param scene  with load steps \param observe  called for every time of them
template <class Observer>
void forget(const Scene& scene, const Observer& observe) {
  Ledger ledger;
  Model model = build(scene, ledger);
  CondensedPath path = condense_path(model, ledger);
  for (const double time : scene.path->times) {
    const Step alone = step(/*past*/ {}, time, model, path, {});
    require_solved(alone.solution, "a load for itself");
    observe(model, alone);
  }
}

/// Goes along a path that has to be solved to its end. \param scene  with load steps \param observe  of every step
template <class Observer>
void remember(const Scene& scene, const Observer& observe) {
  const PathEnd end = solve_steps(scene, observe);
  if (end.status != SolveStatus::Solved) throw NotSolved(end.reason);
}

}  // namespace ch15
