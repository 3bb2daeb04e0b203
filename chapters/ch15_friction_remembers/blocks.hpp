/// \file
/// A block on an incline, and the square that sticks, slips and opens.
#pragma once
#include <cmath>

#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "slider.hpp"

namespace ch15 {

/// A block, 4 mm x 1 mm, of unit weight per volume, that only friction holds. \param angle  of the incline [rad]
/// \param law  of friction; c in N/mm^2 \return the scene
inline Scene incline(double angle, const Friction& law) {
  Scene scene;
  Body& block = scene.bodies[0];
  block.mesh = signorini::block("block", {0, 0}, {4, 1}, 16, 4);
  block.material = {1000, 0.3, PlaneState::Strain, 1};
  block.loads.body_force = [angle](const Eigen::Vector2d& /*x*/) {
    return Eigen::Vector2d(std::sin(angle), -std::cos(angle));
  };
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = law;
  return scene;
}

/// \param law  of friction \return the steepest incline that holds the block [rad]
inline double slip_angle(const Friction& law) {
  double holds = 0, slides = 0.5 * pi;
  while (slides - holds > 1e-12) {
    const double angle = 0.5 * (holds + slides);
    const bool held = solve(incline(angle, law)).contact.report.status == SolveStatus::Solved;
    (held ? holds : slides) = angle;
  }
  return holds;
}

/// W sin t = c A + mu W cos t. \param law  of friction, c < 1 \return closed form of slip_angle() [rad]
inline double slip_angle_exact(const Friction& law) {
  return std::asin(law.cohesion / std::hypot(1, law.coefficient)) + std::atan(law.coefficient);
}

/// Half of a square block that is pressed on a rough plane and squeezed from its side, in m and Pa, as in SSNV128
/// of Code_Aster: it sticks, slides and opens. \param steps  in which the loads come \return the scene
inline Scene square(int steps) {
  Scene scene;
  Body& block = scene.bodies[0];
  block.mesh = signorini::block("block", {0, 0}, {0.04, 0.04}, 32, 32);
  block.material = {1.3e11, 0.2, PlaneState::Strain, 1};
  block.supports = {symmetric("right"), prescribed_at("bottom", {0.04, 0}, Axis::Y)};
  block.loads.edges = {{"top", 5e7, {}}, {"left", 15e7, {}}};
  for (EdgeLoad& load : block.loads.edges) load.history = "load";
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = Friction{1, 0};
  scene.path = Path{equal_steps(steps), {proportional("load")}};
  return scene;
}

}  // namespace ch15
