// A rigid pin in an elastic plate (Xuan & Li 2002, section 4, example 3) as a scene, and the contact problem
// of its 15 x 15 mesh for the tests of the solvers.
#pragma once
#include <Eigen/Core>
#include <string>

#include "meshes/plate_with_hole.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/scene/scene.hpp"
#include "support/meshes.hpp"

namespace signorini_test {

/// The upper half of the plate, in kN and cm. `pressure` on the right side is against the body: 25 is
/// reading (C), the pin bears on the right of the hole; -25 is reading (T), it bears on the left.
inline signorini::Scene pin_in_plate(double pressure, Eigen::Index cells_angle = 15,
                                     Eigen::Index cells_radius = 15, double clearance = 0.2,
                                     const std::string& element = "q4") {
  const double side = pressure > 0 ? 1 : -1;  // of the hole that the pin bears on
  signorini::PlateWithHoleSpec spec;
  spec.hole_radius = 5;
  spec.size = {20, 20};
  spec.cells_angle = cells_angle;
  spec.cells_radius = cells_radius;
  spec.sector = signorini::Sector::Half;
  const signorini::Element& cell = signorini::find_element(element);
  spec.order = order_of(cell);
  signorini::Scene scene;
  signorini::Body& body = scene.bodies[0];
  body.mesh = fitting(signorini::make_plate_with_hole(spec), cell);
  body.element = element;
  body.material = {1000, 0.3, signorini::PlaneState::Strain, 1};
  body.supports = {signorini::symmetric("symmetry"),
                   signorini::prescribed_at("hole", {5 * side, 0}, signorini::Axis::X)};
  body.loads.edges = {{"right", pressure, {}}};
  scene.contacts = {{{"hole"}, signorini::pin_in_hole({0, 0}, clearance, {clearance * side, 0})}};
  return scene;
}

/// The pairs of the hole without the pole, which is held: 15 for 15 cells along the half hole.
inline signorini::ContactProblem pin_problem(double pressure, Eigen::Index cells = 15) {
  signorini::Ledger ledger;
  const signorini::Model model = signorini::build(pin_in_plate(pressure, cells, cells), ledger);
  return signorini::condense(model, ledger).problem;
}

}  // namespace signorini_test
