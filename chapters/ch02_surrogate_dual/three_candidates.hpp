// Chapter 2 - The rubber block with three candidates, and what one weighted gap makes of it.
#pragma once
#include <algorithm>
#include <utility>

#include "signorini/fem/block.hpp"
#include "signorini/scene/readings.hpp"

namespace ch02 {

using namespace signorini;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The rubber block of chapter 1 on a flatter obstacle, with two cells.
// [scene]
inline Scene three_candidates() {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {-20, 0}, {40, 20}, 2, 1);
  body.material = {/*E [N/mm^2]*/ 10, /*nu*/ 0.3, PlaneState::Strain, /*thickness [mm]*/ 1};
  body.supports = {prescribed("top", Axis::X, 0.0), prescribed("top", Axis::Y, -1.0)};
  scene.contacts = {{{"bottom"}, disc({5, -400}, 400)}};
  return scene;
}
// [scene]

/// Many conditions traded for one weighted gap: the best total force for these weights, and its worth.
// [trade]
struct Trade {
  double force;   // eta [N]
  double energy;  // s [N mm]
};

inline Trade trade(const ContactProblem& problem, const VectorXd& xi) {
  const double overlap = -problem.free_gap.dot(xi);      // b.xi, without contact
  const double yield = xi.dot(problem.compliance * xi);  // what a force of 1 closes of it
  const double eta = std::max(0.0, overlap) / yield;     // (23), never pulling
  return {eta, 0.5 * eta * eta * yield};                 // (24)
}
// [trade]

/// The weights of a solution: its forces as shares of their sum.
inline VectorXd shares(const SolvedScene& block) {
  const VectorXd& force = block.solution.contact.force;
  return force / force.sum();
}

}  // namespace ch02
