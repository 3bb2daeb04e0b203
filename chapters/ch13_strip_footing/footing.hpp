// The footing of the chapter on its soil.
#pragma once

#include "closed_form/footing.hpp"
#include "meshes/half_space.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/pairing/mortar.hpp"  // the operators of these contacts, linked with it
#include "signorini/scene/readings.hpp"

namespace ch13 {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

// [data]
const double a = 1.5;                // half of the width [m]
const double q = 15;                 // on top of the footing [kPa]
const double soil_modulus = 20e3;    // [kPa]
const double footing_modulus = 2e7;  // [kPa]
const double poisson_ratio = 0.25;   // of both [-]
const RigidStrip strip{a, 2 * q* a};
// [data]
const double mean_pressure = 2 * q / pi;  // (46) in the middle [kPa]

/// Cells under half of the footing, beside it and in depth; width = depth = `far`.
inline EdgeBlockSpec soil_of(Index under, Index beside, Index deep, double grading, double far) {
  EdgeBlockSpec soil;
  soil.edge = a;
  soil.width = soil.depth = far;
  soil.cells_under = under;
  soil.cells_beside = beside;
  soil.cells_deep = deep;
  soil.grading_under = grading;
  return soil;
}

/// Three meshes: that of the paper in number of nodes, and two for a soil that is wider and deeper.
// [meshes]
const EdgeBlockSpec coarse = soil_of(7, 9, 5, /*grading*/ 4, /*far*/ 15);
const EdgeBlockSpec medium = soil_of(30, 40, 34, 64, 60);
const EdgeBlockSpec fine = soil_of(60, 72, 66, 64, 60);
// [meshes]

/// Half of the soil: held below, on rollers at the axis, free at the side.
inline Body soil_body(const EdgeBlockSpec& spec) {
  Body soil;
  soil.mesh = make_edge_block(spec);
  soil.material = {soil_modulus, poisson_ratio, PlaneState::Strain, 1};
  soil.supports = {symmetric("axis"), fixed("base")};
  return soil;
}

/// The footing and how it is divided.
struct FootingSpec {
  double thickness = 2;              // [m]
  Index rows = 4;                    // of cells
  double modulus = footing_modulus;  // [kPa]
  Index columns = 0;                 // of cells; 0: those of the soil
};

// [scene]
inline Scene on_soil(const EdgeBlockSpec& soil, const FootingSpec& spec) {
  EdgeBlockSpec above = soil;
  if (spec.columns > 0) above.cells_under = spec.columns;
  Body footing;
  footing.mesh = make_graded_block("footing", above.under(),
                                   stretched(0, {{spec.thickness, spec.rows, /*grading*/ 2}}));
  footing.material = {spec.modulus, poisson_ratio, PlaneState::Strain, 1};
  footing.supports = {symmetric("left")};
  footing.loads.edges = {{"top", q, {}}};
  Scene scene;
  scene.bodies = {footing, soil_body(soil)};
  scene.contacts = {{/*source*/ {"surface", "soil"}, /*target*/ Side{"bottom", "footing"}}};
  return scene;
}
// [scene]

inline SolvedScene settle(const EdgeBlockSpec& soil, const FootingSpec& footing) {
  return solved(on_soil(soil, footing), "the footing");
}

inline std::string percent(double part) { return number(100 * part, "%.2f"); }

}  // namespace ch13
