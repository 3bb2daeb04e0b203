/// \file
/// The problems that the iteration is tried on.
#pragma once
#include <algorithm>
#include <string>

#include "exact.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/programme/dense_programme.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

// Three problems with K = I, in exact fractions and in floating point.
// [problems]
inline const exact::Programme corner = {{{0, 1}, {1, -1}}, {0, 0}, {1, 2}};
inline const exact::Programme fan = {{{1, -1}, {2, -1}, {1, 1}}, {0, 0, 0}, {1, 0}};
inline const exact::Programme four_walls = {
    {{-3, -2, 3}, {1, -3, 3}, {-1, 2, 0}, {2, -3, 3}}, {1, 1, 1, 2}, {0, -1, 6}};
// [problems]

inline Eigen::VectorXd floating(const exact::Vector& x) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(x.size()));
  std::transform(x.begin(), x.end(), result.begin(), [](const auto& f) { return f.value(); });
  return result;
}

inline exact::Set exact_set(const std::vector<Eigen::Index>& rows) {
  return {rows.begin(), rows.end()};
}

inline std::string text_of(const exact::Set& rows) {  // counted from 1
  std::string list;
  for (const std::size_t i : rows) list += (list.empty() ? "" : ", ") + std::to_string(i + 1);
  return list;
}

inline std::string text_of(const exact::Vector& x) {
  std::string list;
  for (const exact::Fraction& f : x) list += (list.empty() ? "(" : ", ") + f.text();
  return list + ")";
}

inline DenseProgramme floating(const exact::Programme& q) {
  const Eigen::Index n = static_cast<Eigen::Index>(q.p.size());
  DenseProgramme result{Eigen::MatrixXd::Identity(n, n), floating(q.p), {}, floating(q.g)};
  result.A.resize(result.initial_gap.size(), n);
  for (std::size_t i = 0; i < q.A.size(); ++i)
    result.A.row(static_cast<Eigen::Index>(i)) = floating(q.A[i]);
  return result;
}

inline ContactProblem condensed(const DenseProgramme& q) { return condense(q).problem; }

inline Eigen::VectorXd displacement(const DenseProgramme& q, const ContactState& state) {  // K = I
  return q.load - q.A.transpose() * state.force;
}

inline ContactProblem condensed(Scene scene, const BlockSpec& block, const Obstacle& obstacle) {
  scene.bodies[0].mesh = make_block(block);
  scene.contacts = {{{"bottom"}, obstacle}};
  Ledger ledger;
  return condense(build(scene, ledger), ledger).problem;
}

/// The block of chapter 1 on its obstacle.
inline ContactProblem block_on_obstacle() {
  Scene scene;
  Body& body = scene.bodies[0];
  body.material = {10, 0.3, PlaneState::Strain, 1};
  body.supports = {prescribed("top", Axis::X, 0.0), prescribed("top", Axis::Y, -1.0)};
  BlockSpec block;
  block.corner = {-20, 0};
  block.size = {40, 20};
  block.cells_x = 160;
  block.cells_y = 80;
  return condensed(scene, block, disc({0, -60}, 60));
}

/// The cantilever of chapter 6 on its foundation.
inline ContactProblem cantilever() {
  Scene scene;
  Body& body = scene.bodies[0];
  body.material = {2.1e4, 0.29, PlaneState::Stress, 1};
  body.supports = {fixed("left")};
  body.loads.edges = {{"top", 3.6, {}}};
  BlockSpec block;
  block.size = {50, 5};
  block.cells_x = 100;
  block.cells_y = 10;
  return condensed(scene, block, half_plane({0, -1}, {0, 1}));
}

}  // namespace signorini
