// The cantilever of the chapter, its data, and its solution.
#pragma once
#include <string>

#include "closed_form/beam.hpp"
#include "meshes/block.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/readings.hpp"

namespace ch06 {

using namespace signorini;
using Eigen::Index;

/// The data of the paper, as we read them, in cm and kN: a beam 1 cm above the foundation; the width is ours.
// [data]
const BeamOnFoundation paper{/*length*/ 50,     /*height*/ 5,           /*width*/ 1,
                             /*modulus*/ 2.1e4, /*poisson_ratio*/ 0.29, /*gap*/ 1,
                             /*pressure*/ 3.6};
const double total_force_2d = 71.626;  // limit of our own meshes up to 800 x 80 [kN]
// [data]

/// The scene: what a user writes down. All lengths and forces come from `beam`.
// [scene]
inline Scene cantilever(const BeamOnFoundation& beam, const std::string& element, Index cells) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("cantilever", {0, 0}, {beam.length, beam.height}, cells, cells / 10,
                    element == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear);
  body.element = element;
  body.material = {beam.youngs_modulus, beam.poisson_ratio, PlaneState::Stress, beam.width};
  body.supports = {fixed("left")};
  body.loads.edges = {{"top", beam.pressure, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, -beam.gap}, {0, 1})}};
  return scene;
}
// [scene]

/// Its certified solution.
inline SolvedScene solve_cantilever(const BeamOnFoundation& beam, const std::string& element,
                                    Index cells) {
  return solved(cantilever(beam, element, cells), "the cantilever");
}

inline double total_force(const SolvedScene& run) {
  return resultants(run.model, run.solution).force.y();
}

}  // namespace ch06
