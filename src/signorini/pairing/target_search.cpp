// # Closest-point projection
//
// This page is the search; target_rules.cpp says what counts as facing. A point of the source has
// a place and a normal of its own, out of its body. A place of the target may be its partner if
// the two normals are more than 90 degrees apart. Of those places the nearest counts.
//
// The search walks through the tree of side_tree.hpp from the top. A box is opened only if it may
// hold something nearer than what was found, and if a line from the point along one of its normals
// can meet it. The nearer child goes first, because its finds let the other one be skipped.
//
// "Nearest" means nearest up to rounding. Two sides that meet above a node are equally far, and
// their two distances differ in the last digit. A search that took the smaller one would be
// decided by rounding at each node. So all candidates within rounding are kept until the end, and
// rules decide.

#include "signorini/pairing/target_search.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "signorini/pairing/target_query.hpp"

namespace signorini {

using Eigen::Index, Eigen::Vector2d;

/// The sides are made first: neighbours and the tree are read from them.
TargetSearch::TargetSearch(const Mesh& mesh, const std::string& name)
    : mesh_(&mesh),
      boundary_(name),
      sides_(side_curves(mesh, name)),
      before_(sides_.size(), -1),
      after_(sides_.size(), -1),
      tree_(make_tree()) {}

/// Neighbours are found by nodes that end one side and begin another. If the boundary touches
/// itself, several sides may begin at a node; then the first of the list is taken.
std::vector<SideBox> TargetSearch::make_tree() {
  std::map<Index, Index> starting;
  for (Index s = n_sides() - 1; s >= 0; --s) starting[side(s).nodes().front()] = s;
  for (Index s = n_sides() - 1; s >= 0; --s) {
    const auto next = starting.find(side(s).nodes().back());
    if (next == starting.end()) continue;
    after_[static_cast<std::size_t>(s)] = next->second;
    before_[static_cast<std::size_t>(next->second)] = s;
  }
  // One box per side; box_tree() puts boxes around them, two by two.
  std::vector<SideBox> leaves;
  for (Index s = 0; s < n_sides(); ++s) leaves.push_back(leaf(s));
  return box_tree(std::move(leaves));
}

/// The normals of a leaf are those of its side, of its neighbours at the vertices, and of what is
/// thought beyond an end: at a vertex a point may face any normal in between.
SideBox TargetSearch::leaf(Index number) const {
  const SideCurve& curve = side(number);
  SideBox box;
  box.lowest = curve.box().col(0);
  box.highest = curve.box().col(1);
  // The tangent of a parabola turns one way: between the normals at its ends lie all of them.
  box.axis = (curve.normal(-1) + curve.normal(1)).normalized();
  for (const int end : {-1, 1}) {
    box.spread = std::max(box.spread, angle_between(box.axis, curve.normal(end)));
    box.spread = std::max(box.spread, angle_between(box.axis, normal_beyond(number, end)));
    const Index next = neighbour(number, end);
    if (next >= 0)
      box.spread = std::max(box.spread, angle_between(box.axis, side(next).normal(-end)));
  }
  box.slack = end_tolerance * (box.highest - box.lowest).norm();
  box.first = number;
  return box;
}

/// A box is left unopened for two reasons: it is too far, or no normal in it points back to the
/// point. The distance may exceed the nearest one by rounding, since a tie is decided later, by the
/// rules.
void TargetSearch::look(const SideBox& box, Query& query) const {
  ++query.visits;
  if (box.distance(query.position) > query.nearest + query.rounding + box.slack) return;
  if (!box.may_hold_foot(query.position, query.rounding)) return;
  if (box.is_leaf()) return consider(box.first, query);
  const SideBox& first = tree_[static_cast<std::size_t>(box.first)];
  const SideBox& second = tree_[static_cast<std::size_t>(box.second)];
  const bool swap = second.distance(query.position) < first.distance(query.position);
  look(swap ? second : first, query);
  look(swap ? first : second, query);
}

/// A query holds all that changes during a search, and the tree stays as it was made. So the answer
/// for a point does not depend on the points that were asked before.
Projection TargetSearch::closest(const AnchoredPoint& x, const Vector2d& normal) const {
  Query query(x, normal, tree_.back());
  look(tree_.back(), query);
  Projection found = chosen(query);
  found.visits = query.visits;
  return found;
}

/// The other kind of search: not the closest place, but where a line meets the target. Segments are
/// cut with it.
void TargetSearch::look_along(const SideBox& box, Query& query) const {
  ++query.visits;
  if (!box.may_meet(query.position, query.normal, query.nearest, query.rounding)) return;
  if (!box.is_leaf()) {
    look_along(tree_[static_cast<std::size_t>(box.first)], query);
    look_along(tree_[static_cast<std::size_t>(box.second)], query);
    return;
  }
  // A line may meet a parabola twice, and a side that looks the other way does not count.
  const SideCurve& curve = side(box.first);
  for (const double xi : curve.crossings(query.x, query.normal, end_tolerance)) {
    const Vector2d back = query.x - curve.point(xi);
    if (!faces(curve.normal(xi), query.normal)) continue;
    if (back.dot(curve.normal(xi)) < -depth(box.first))
      query.inside = query.inside || inside_body(query.x);
    else
      query.add({box.first, xi, back.norm(), 0});
  }
}

/// A cut needs a place and no direction. So there is no rule for vertices here, and the normal is
/// that of a side.
Projection TargetSearch::along(const AnchoredPoint& x, const Vector2d& normal) const {
  Query query(x, normal, tree_.back());
  look_along(tree_.back(), query);
  // A line through a vertex meets both sides: the one that comes first, no normal between them.
  const auto first = std::min_element(query.candidates.begin(), query.candidates.end(),
                                      [](const auto& a, const auto& b) { return a.side < b.side; });
  Projection found;
  found.inside = query.inside;
  if (first != query.candidates.end()) found = on_side(*first, query);
  found.visits = query.visits;
  return found;
}

}  // namespace signorini
