// # Pairs where the bodies are
//
// A linear gap follows the normal that a pair has in the mesh. Slide a node by s along a disc of radius R,
// and that gap is wrong by \f$ s^2/2R \f$. So the pairs are found again where the bodies stand, by the effects that
// found them first: contact, friction and cohesion declare and add once more, to a draft whose meshes have moved.
//
// Positions are doubles, and \f$ \hat x = X + u \f$ is rounded. What rounding took is known to the last digit, and moves the
// gap by its row: so the gap of u is right to first order in it.
//
// A die that irons a long slab touches a few of its nodes, and the others cost as much. Pairs that are farther apart than the
// smallest body is large are left out. Nothing is lost by this: they are open, and each iteration finds anew which are near.

#include "addons/motion/moved_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

NodeArray nodes_of(const std::vector<BodyModel>& bodies) {
  NodeArray nodes(count_nodes(bodies), 2);
  for (const BodyModel& body : bodies)
    nodes.middleRows(body.first_node, body.mesh.n_nodes()) = body.mesh.nodes;
  return nodes;
}

/// X + u rounded, and what that lacks.
struct Places {
  NodeArray rounded;
  NodeArray rest;
};

/// a + b rounded, and what that lacks.
Places sum(const NodeArray& a, const NodeArray& b) {
  const NodeArray rounded = a + b;
  const NodeArray part = rounded - a;
  return {rounded, (a - (rounded - part)) + (b - part)};
}

/// \param carried  what all places are shifted by, and left out
Places places(const NodeArray& X, const Displaced& u, const Eigen::RowVector2d& carried) {
  const Places still = sum(X, -carried.replicate(X.rows(), 1));
  const Places there = sum(still.rounded, u.high);
  return sum(there.rounded, there.rest + (still.rest + u.low));
}

/// Whether only bodies face each other. An obstacle stays where it is.
bool only_bodies(const Scene& scene) {
  return std::all_of(
      scene.contacts.begin(), scene.contacts.end(),
      [](const ContactSpec& contact) { return std::holds_alternative<Side>(contact.target); });
}

/// The middle of where all bodies stand. Gaps and normals are found as if that were the origin, or the last digits of far
/// places would be those of normals. With an obstacle they stay where they are, and so does the axis of bodies of revolution,
/// whose radii are their depth. At rest they have the pairs of the scene, bit by bit.
Eigen::RowVector2d carrier(const Scene& scene, const Model& model, const NodeArray& still,
                           const Displaced& displacement) {
  const bool at_rest = displacement.high.isZero(0) && displacement.low.isZero(0);
  if (at_rest || !only_bodies(scene)) return {0, 0};
  Eigen::RowVector2d mean = (still + displacement.high).colwise().mean();
  if (!model.bodies.empty() && is_axial(model.bodies.front())) mean.x() = 0;
  return mean;
}

/// By how much nodes have moved, less what bodies have in common, which is no slip of theirs.
NodeArray moved_since(const Scene& scene, const Displaced& before, const Displaced& now,
                      const NodeArray& rest) {
  Eigen::RowVector2d common = (now.high - before.high).colwise().mean();
  if (!only_bodies(scene)) common.setZero();
  const Places moved = places(-before.high, {now.high, now.low - before.low}, common);
  return moved.rounded + (moved.rest - rest);
}

/// How far a node has slid along an obstacle that stands still. The angle between the tangents where it came from and where it is is
/// that of an arc, whose chord is the way: from \f$ \theta \f$ to 0 on a circle of radius R it is \f$ R\theta \f$, where the way along
/// the last tangent is \f$ R\sin\theta \f$. Across a corner it is short by \f$ (\theta/2)/\tan(\theta/2) \f$. Turned by nearly 180 degrees
/// there is no arc, and the way along the last tangent is taken.
/// \param from, to  unit tangents [-] \param way  of the node [length] \return slip [length], > 0 along the tangents
double along_arc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& way) {
  const Eigen::Vector2d middle = from + to;
  const double half = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to)) / 2;
  if (half == 0 || middle.norm() < 0.1) return to.dot(way);
  return middle.normalized().dot(way) * half / std::sin(half);
}

/// The slips of a contact with an obstacle since the last step.
Eigen::VectorXd slid_on(const Obstacle& obstacle, const Pairs& pairs, const NodeArray& since) {
  Eigen::VectorXd slid(pairs.weight.size());
  for (Eigen::Index pair = 0; pair < slid.size(); ++pair) {
    Eigen::Vector2d way(0, 0);
    for (NodalRows::InnerIterator entry(pairs.opening, pair); entry; ++entry)
      way = since.row(entry.col() / 2).transpose();
    const Eigen::Vector2d there = pairs.position.row(pair).transpose();
    const Eigen::Vector2d n0 = obstacle.look(there - way).normal;
    const Eigen::Vector2d n = pairs.normal.row(pair).transpose();
    slid(pair) = along_arc({n0.y(), -n0.x()}, {n.y(), -n.x()}, way);
  }
  return slid;
}

/// What supports still have to move, from the rounded places.
Unknowns from_there(Unknowns unknowns, const Displaced& u, const NodeArray& rest) {
  unknowns.held = (unknowns.number < 0).select(((unknowns.held - u.high) - u.low) + rest, 0);
  return unknowns;
}

/// Gaps and slips are seen from the rounded places, which the unknowns are a little beside.
void add_rest(const NodeArray& rest, const Unknowns& unknowns, Gaps& gaps) {
  const Eigen::VectorXd beside = restricted(unknowns, rest);
  gaps.pairs.initial_gap -= gaps.A * beside;
  if (gaps.T.rows() > 0) gaps.initial_slip += gaps.T * beside;
}

}  // namespace

double smallest_size(const Model& model) {
  double size = std::numeric_limits<double>::infinity();
  for (const BodyModel& body : model.bodies) {
    const NodeArray& nodes = body.mesh.nodes;
    size = std::min(size, (nodes.colwise().maxCoeff() - nodes.colwise().minCoeff()).norm());
  }
  return size;
}

void place_bodies(const Scene& scene, const Displaced& displacement, const Displaced& before,
                  Model& model) {
  const NodeArray still = nodes_of(model.bodies);
  const Eigen::RowVector2d carried = carrier(scene, model, still, displacement);
  const Places now = places(still, displacement, carried);
  Plan draft;
  const auto standing = std::make_shared<Standing>(
      Standing{displacement.high, moved_since(scene, before, displacement, now.rest)});
  if (!displacement.high.isZero(0)) standing->reach = smallest_size(model);
  draft.standing = standing;
  draft.fits = {[&standing = *standing](const ContactSpec& contact, Pairs& pairs) {
    const Obstacle* const obstacle = std::get_if<Obstacle>(&contact.target);
    if (obstacle != nullptr && pairs.sliding.nonZeros() > 0)
      pairs.slid = slid_on(*obstacle, pairs, standing.since);
    return std::string();
  }};
  draft.unknowns = from_there(model.unknowns, displacement, now.rest);
  draft.gaps.A.resize(0, model.unknowns.count);
  draft.gaps.pairs.opening.resize(0, still.size());
  draft.gaps.pairs.sliding.resize(0, still.size());
  draft.bodies = model.bodies;
  for (BodyModel& body : draft.bodies)
    body.mesh.nodes = now.rounded.middleRows(body.first_node, body.mesh.n_nodes());
  for (const Effect* effect : model.effects)
    if (effect->of_pairs) effect->declare(scene, draft);
  add_rest(now.rest, draft.unknowns, draft.gaps);
  draft.gaps.pairs.position.rowwise() += carried;
  model.standing = std::move(draft.standing);
  model.gaps = std::move(draft.gaps);
  model.contact_of = std::move(draft.contact_of);
  model.law = std::move(draft.law);
  for (const Effect* effect : model.effects)
    if (effect->of_pairs) effect->add(model);
  model.gaps = {};
}

void count_from_the_scene(const Displaced& displacement, Model& model) {
  if (model.programme.A.rows() == 0) return;
  model.programme.initial_gap +=
      model.programme.A * restricted(model.unknowns, displacement.high + displacement.low);
  model.pairs.initial_gap = model.programme.initial_gap.head(model.pairs.weight.size());
}

}  // namespace signorini
