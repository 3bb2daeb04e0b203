// Chapter 2 - The rubber block with three candidates, and what one weighted gap makes of it.
#pragma once
#include <algorithm>
#include <vector>

#include "signorini/contact/obstacle.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/fem/assembly.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/problem/problem.hpp"
#include "signorini/solvers/enumerate.hpp"

namespace ch02 {

using namespace signorini;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The rubber block of chapter 1 on a flatter obstacle, with two cells.
// [programme]
inline Mesh two_cells() { return block("block", {-20, 0}, {40, 20}, 2, 1); }

inline Unknowns pressed_down(const Mesh& mesh) {
  return number_unknowns(mesh, {prescribed("top", Axis::X, 0.0), prescribed("top", Axis::Y, -1.0)});
}

inline QuadraticProgramme three_candidates() {
  const Mesh mesh = two_cells();
  const Material rubber{/*E [N/mm^2]*/ 10, /*nu*/ 0.3, PlaneState::Strain, /*thickness [mm]*/ 1};
  const Obstacle obstacle = disc({5, -400}, 400);
  const Unknowns unknowns = pressed_down(mesh);
  const LinearSystem body = assemble(mesh, q4_incompatible(), rubber, unknowns, {});  // K, p
  MatrixXd A = MatrixXd::Zero(3, unknowns.count);
  Vector3d g;
  Eigen::Index pair = 0;
  for (const Eigen::Index node : boundary_nodes(mesh, "bottom")) {
    const auto [gap, normal] = obstacle.look(mesh.nodes.row(node).transpose());
    g(pair) = gap;
    for (int axis = 0; axis < 2; ++axis) A(pair, unknowns.number(node, axis)) = -normal(axis);
    ++pair;
  }
  return {body.stiffness, body.load, A.sparseView(), g};
}
// [programme]

/// The block, condensed to its three pairs, and the forces that press it onto the obstacle.
struct Block {
  QuadraticProgramme programme;  ///< K, p, A, g
  CholeskyFactor factor;         ///< of K
  VectorXd free_displacement;    ///< (20)
  ContactProblem problem;        ///< G and d
  VectorXd force;                ///< lambda
};

inline Block pressed_block() {
  const QuadraticProgramme programme = three_candidates();
  const MatrixXd A = programme.A;
  const CholeskyFactor K(programme.stiffness);
  const VectorXd u0 = K.solve(programme.load);
  const ContactProblem problem{A * K.solve_columns(A.transpose()), programme.initial_gap - A * u0};
  return {programme, K, u0, problem, enumerate(problem).force};  // the best of all eight sets
}

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

/// The weights of the solution: its forces as shares of their sum.
inline VectorXd shares(const Block& block) { return block.force / block.force.sum(); }

}  // namespace ch02
