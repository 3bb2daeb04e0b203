// The two interfaces of the chapter: blocks on a straight line, and the disc on a plate of chapter 11.
#pragma once
#include <cmath>
#include <string>
#include <utility>

#include "closed_form/hertz.hpp"
#include "meshes/hertz_meshes.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/readings.hpp"

namespace ch10 {

using namespace signorini;

/// What is asked of the gap operator.
struct Sampling {
  const char* gap_operator = "gauss_points";
  int points = 2;
  Quadrature quadrature = Quadrature::SourceEdges;
};

inline void touch(Scene& scene, const Side& source, const Side& target, const Sampling& by) {
  ContactSpec contact;
  contact.source = source;
  contact.target = target;
  contact.gap_operator = by.gap_operator;
  contact.points = by.points;
  contact.quadrature = by.quadrature;
  scene.contacts = {contact};
}

/// Two blocks, 2 wide and 1 high, the upper one under a pressure of 1, which it should be everywhere between them.
inline Scene blocks(Eigen::Index source_edges, Eigen::Index target_edges, const Sampling& by) {
  Scene scene;
  scene.bodies.resize(2);
  Body& upper = scene.bodies[0];
  Body& lower = scene.bodies[1];
  upper.mesh = block("upper", {0, 1}, {2, 1}, source_edges, 3);
  lower.mesh = block("lower", {0, 0}, {2, 1}, target_edges, 3);
  upper.material = lower.material = {1000, 0.3, PlaneState::Strain, 1};
  upper.supports = {prescribed_at("top", {0, 2}, Axis::X)};  // it floats: contact holds it up
  lower.supports = {prescribed("bottom", Axis::Y, 0), prescribed_at("bottom", {0, 0}, Axis::X)};
  upper.loads.edges = {{"top", 1, {}}};
  touch(scene, {"bottom", "upper"}, {"top", "lower"}, by);
  return scene;
}

/// The disc of section 3.1 of the paper, in closed form.
inline const LineContact hertz_contact{50, 4000 / (2 * (1 - 0.35 * 0.35)), 41.76};

/// Half of a disc on half of a plate; with 16 cells below the core of the disc, nodes meet nodes.
inline Scene hertz(Eigen::Index plate_cells, const Sampling& by, Eigen::Index finer = 1) {
  HertzMeshSpec spec;
  spec.disc_cells *= finer;
  spec.disc_rows *= finer;
  spec.disc_layers *= finer;
  spec.plate_cells = plate_cells * finer;
  spec.plate_rows *= finer;
  spec.plate_layers *= finer;
  HertzMeshes meshes = make_hertz_meshes(spec);
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = std::move(meshes.disc);
  scene.bodies[1].mesh = std::move(meshes.plate);
  for (Body& body : scene.bodies) {
    body.material = {4000, 0.35, PlaneState::Strain, 1};
    body.supports = {symmetric("axis")};
  }
  scene.bodies[1].supports.push_back(fixed("base"));
  scene.bodies[0].loads.edges = {{"middle", hertz_contact.force / 2 / hertz_contact.radius, {}}};
  touch(scene, {"rim", scene.bodies[0].mesh.name}, {"surface", scene.bodies[1].mesh.name}, by);
  return scene;
}

/// Peak, and root mean square of the error where x < 0.7 b; both over q_0.
struct PressureError {
  double peak = 0;
  double rms = 0;
};

inline PressureError against_hertz(const NodeArray& position, const Eigen::VectorXd& weight,
                                   const Eigen::VectorXd& pressure) {
  const double q = hertz_peak_pressure(hertz_contact);
  const double inner = 0.7 * hertz_half_width(hertz_contact);
  PressureError error;
  double sum = 0;
  for (Eigen::Index i = 0; i < pressure.size(); ++i) {
    const double x = position(i, 0);
    error.peak = std::max(error.peak, pressure(i) / q);
    if (x > inner) continue;
    const double off = (pressure(i) - hertz_pressure(hertz_contact, x)) / q;
    error.rms += weight(i) * off * off;
    sum += weight(i);
  }
  error.rms = std::sqrt(error.rms / sum);
  return error;
}

}  // namespace ch10
