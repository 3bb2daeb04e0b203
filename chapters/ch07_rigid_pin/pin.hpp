// The pin of the chapter in its plate, and what it does to the edge of the hole.
#pragma once

#include "addons/frontal/frontal_factor.hpp"  // the factor of these scenes, linked with it
#include "meshes/plate_with_hole.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/readings.hpp"

namespace ch07 {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

const double degree = pi / 180;

// What the paper gives and what we add, in cm and kN. Reading (T): q pulls on the right side and the pin
// bears on the left of the hole; (C): q presses, the pin bears on the right.
struct Pin {
  double q;                // paper; pressure on the right side: (T) < 0, (C) > 0 [kN/cm^2]
  double clearance;        // paper: epsilon, read as radius of the hole less radius of the pin [cm]
  bool linear_gap = true;  // or the exact distance from the pin
  [[nodiscard]] double side() const { return q > 0 ? 1 : -1; }  // of the hole that bears
};
const Pin tension{-25, 0.2};
const Pin compression{25, 0.2};
const double hole_radius = 5;                                     // ours
const double plate_size = 20;                                     // ours
const Material plate_material{1000, 0.3, PlaneState::Strain, 1};  // paper; thickness ours

/// The upper half of the plate.
// [scene]
inline Scene pin_in_plate(const Pin& pin, Index cells_radius, const VectorXd& rays) {
  PlateWithHoleSpec plate;
  plate.hole_radius = hole_radius;
  plate.size = {plate_size, plate_size};
  plate.cells_angle = rays.size() - 1;
  plate.cells_radius = cells_radius;
  plate.rays = rays;
  plate.sector = Sector::Half;
  const Eigen::Vector2d pole(pin.side() * hole_radius, 0);
  const Eigen::Vector2d shift(pin.side() * pin.clearance, 0);  // the pin touches the pole
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = make_plate_with_hole(plate);
  body.element = "q4";
  body.material = plate_material;
  body.supports = {symmetric("symmetry"), prescribed_at("hole", pole, Axis::X)};
  body.loads.edges = {{"right", pin.q, {}}};
  scene.contacts = {{{"hole"},
                     pin.linear_gap ? pin_in_hole({0, 0}, pin.clearance, shift)
                                    : disc(shift, hole_radius - pin.clearance)}};
  scene.contacts[0].small_sliding = true;  // linear theory, however far it goes
  return scene;
}
// [scene]

/// What happens at the nodes of the half hole, counted from the pole that bears.
struct Bearing {
  SolvedScene run;
  VectorXd theta, force, pressure;  // [deg, kN, kN/cm^2]
  double resultant;                 // of both halves along x [kN/cm]
  double right;                     // u_x in the middle of the right side [cm]
};

/// Radial forces of the pairs, and of the support that stands for the pair at the pole.
// [bearing]
inline Bearing bearing(const Pin& pin, Index cells_radius, const VectorXd& rays) {
  const Scene scene = pin_in_plate(pin, cells_radius, rays);
  SolvedScene run = solved(scene, "the pin");
  const BoundaryForces hole = boundary_forces(run, {"hole"});  // from the left to the right
  VectorXd theta = (pin.side() * hole.position.col(0).array() / hole_radius).acos() / degree;
  VectorXd force = hole.force.cwiseProduct(hole.position).rowwise().sum() / hole_radius;
  VectorXd pressure = force.cwiseQuotient(hole.weight);
  if (pin.side() > 0)
    for (VectorXd* values : {&theta, &force, &pressure}) values->reverseInPlace();
  if (force(0) < 0) throw NotSolved("the pole pulls at its support: it must not be held");
  const double resultant = 2 * pin.side() * hole.force.col(0).sum();
  const Index right = boundary_nodes(scene.bodies[0].mesh, "right").front();
  const double moved = run.solution.displacements[0](right, 0);
  return {std::move(run), theta, force, pressure, resultant, moved};
}
// [bearing]

/// The paper's 225 cells, divided by us: 11 cells over the quadrant that bears, whose 12 nodes are its
/// candidates, 4 over the other.
inline Bearing on_paper_mesh(const Pin& pin) {
  return bearing(pin, 15, pin.side() > 0 ? rays_by_quadrant({11, 4}) : rays_by_quadrant({4, 11}));
}

/// Even cells along the half hole.
inline Bearing on_even_mesh(const Pin& pin, Index cells, Index cells_radius) {
  return bearing(pin, cells_radius, VectorXd::LinSpaced(cells + 1, 0, 180 * degree));
}

}  // namespace ch07
