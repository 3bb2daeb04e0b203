#include "signorini/contact/target_search.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "signorini/contact/target_query.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::Vector2d;

TargetSearch::TargetSearch(const Mesh& mesh, const std::string& name)
    : mesh_(&mesh),
      boundary_(name),
      sides_(side_curves(mesh, name)),
      before_(sides_.size(), -1),
      after_(sides_.size(), -1),
      tree_(make_tree()) {}

std::vector<SideBox> TargetSearch::make_tree() {
  std::map<Index, Index> starting;
  for (Index s = n_sides() - 1; s >= 0; --s) starting[side(s).nodes().front()] = s;
  for (Index s = n_sides() - 1; s >= 0; --s) {
    const auto next = starting.find(side(s).nodes().back());
    if (next == starting.end()) continue;
    after_[static_cast<std::size_t>(s)] = next->second;
    before_[static_cast<std::size_t>(next->second)] = s;
  }
  std::vector<SideBox> leaves;
  for (Index s = 0; s < n_sides(); ++s) leaves.push_back(leaf(s));
  return box_tree(std::move(leaves));
}

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

Projection TargetSearch::closest(const AnchoredPoint& x, const Vector2d& normal) const {
  Query query(x, normal, tree_.back());
  look(tree_.back(), query);
  Projection found = chosen(query);
  found.visits = query.visits;
  return found;
}

void TargetSearch::look_along(const SideBox& box, Query& query) const {
  ++query.visits;
  if (!box.may_meet(query.position, query.normal, query.nearest, query.rounding)) return;
  if (!box.is_leaf()) {
    look_along(tree_[static_cast<std::size_t>(box.first)], query);
    look_along(tree_[static_cast<std::size_t>(box.second)], query);
    return;
  }
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
