#include "signorini/contact/target_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

constexpr double pi = 3.14159265358979323846;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double angle_between(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

/// More than 90 degrees apart, and by more than rounding.
bool faces(const Vector2d& target_normal, const Vector2d& source_normal) {
  return target_normal.dot(source_normal) < -1e-6;
}

}  // namespace

/// A place of one side that the point may be paired with.
struct TargetSearch::Candidate {
  Index side;
  double xi;
  double distance;
  int vertex;  // -1 or 1: the end of the side, where another facing side begins; 0: none
};

struct TargetSearch::Query {
  Query(const Vector2d& point, const Vector2d& source_normal, double size)
      : x(point),
        normal(source_normal),
        rounding(64 * std::numeric_limits<double>::epsilon() *
                 std::max(size, point.cwiseAbs().maxCoeff())) {}

  Vector2d x;
  Vector2d normal;
  double rounding;  // of distances
  double nearest = std::numeric_limits<double>::infinity();
  std::vector<Candidate> candidates;  // within rounding of the nearest
  bool buried = false;
  Index visits = 0;

  void add(const Candidate& candidate) {
    if (candidate.distance < nearest - rounding) candidates.clear();
    if (candidate.distance <= nearest + rounding) candidates.push_back(candidate);
    nearest = std::min(nearest, candidate.distance);
  }
};

TargetSearch::TargetSearch(const Mesh& mesh, const std::string& name)
    : mesh_(&mesh), boundary_(name), size_(mesh.nodes.cwiseAbs().maxCoeff()) {
  for (const CellSide& side : boundary(mesh, name)) sides_.emplace_back(mesh, side);
  before_.assign(sides_.size(), -1);
  after_.assign(sides_.size(), -1);
  std::map<Index, Index> starting;
  for (Index s = n_sides() - 1; s >= 0; --s) starting[side(s).nodes().front()] = s;
  for (Index s = n_sides() - 1; s >= 0; --s) {
    const auto next = starting.find(side(s).nodes().back());
    if (next == starting.end()) continue;
    after_[static_cast<std::size_t>(s)] = next->second;
    before_[static_cast<std::size_t>(next->second)] = s;
  }
  std::vector<Box> leaves;
  for (Index s = 0; s < n_sides(); ++s) leaves.push_back(leaf(s));
  tree_.reserve(2 * sides_.size());
  if (!leaves.empty()) build(leaves, 0, leaves.size());
}

Index TargetSearch::neighbour(Index number, int end) const {
  return (end < 0 ? before_ : after_)[static_cast<std::size_t>(number)];
}

TargetSearch::Box TargetSearch::leaf(Index number) const {
  const SideCurve& curve = side(number);
  Box box;
  box.lowest = curve.box().col(0);
  box.highest = curve.box().col(1);
  // The tangent of a parabola turns one way: between the normals at its ends lie all of them.
  box.axis = (curve.normal(-1) + curve.normal(1)).normalized();
  for (const int end : {-1, 1}) {
    box.spread = std::max(box.spread, angle_between(box.axis, curve.normal(end)));
    const Index next = neighbour(number, end);
    if (next >= 0)
      box.spread = std::max(box.spread, angle_between(box.axis, side(next).normal(-end)));
  }
  box.slack = end_tolerance * (box.highest - box.lowest).norm();
  box.first = number;
  return box;
}

Index TargetSearch::build(std::vector<Box>& leaves, std::size_t begin, std::size_t end) {
  if (end - begin == 1) {
    tree_.push_back(leaves[begin]);
    return static_cast<Index>(tree_.size()) - 1;
  }
  Box box = leaves[begin];
  for (std::size_t k = begin + 1; k < end; ++k) {
    box.lowest = box.lowest.cwiseMin(leaves[k].lowest);
    box.highest = box.highest.cwiseMax(leaves[k].highest);
    box.slack = std::max(box.slack, leaves[k].slack);
  }
  const Vector2d extent = box.highest - box.lowest;
  const int axis = extent.x() >= extent.y() ? 0 : 1;
  const std::size_t half = begin + (end - begin) / 2;
  const auto at = [&](std::size_t k) { return leaves.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(half), at(end), [axis](const Box& a, const Box& b) {
    const double left = a.lowest(axis) + a.highest(axis);
    const double right = b.lowest(axis) + b.highest(axis);
    return left < right || (left == right && a.first < b.first);
  });
  box.first = build(leaves, begin, half);
  box.second = build(leaves, half, end);
  const Box& one = tree_[static_cast<std::size_t>(box.first)];
  const Box& two = tree_[static_cast<std::size_t>(box.second)];
  box.axis = one.axis + two.axis;
  if (box.axis.norm() < 1e-6) {
    box.axis = one.axis;
    box.spread = pi;
  } else {
    box.axis.normalize();
    box.spread = std::min(pi, std::max(angle_between(box.axis, one.axis) + one.spread,
                                       angle_between(box.axis, two.axis) + two.spread));
  }
  tree_.push_back(box);
  return static_cast<Index>(tree_.size()) - 1;
}

void TargetSearch::look(Index number, Query& query) const {
  const Box& box = tree_[static_cast<std::size_t>(number)];
  ++query.visits;
  const Vector2d outside =
      (box.lowest - query.x).cwiseMax(query.x - box.highest).cwiseMax(Vector2d::Zero());
  if (outside.norm() > query.nearest + query.rounding + box.slack) return;
  // Too few degrees between the normal of the source and all normals in the box.
  if (angle_between(box.axis, query.normal) + box.spread < pi / 2) return;
  // The line from the point to any place in the box is along none of the normals in the box.
  const Vector2d arm = query.x - (box.lowest + box.highest) / 2;
  const Vector2d half = (box.highest - box.lowest) / 2;
  const Vector2d tangent(box.axis.y(), -box.axis.x());
  const double aside = std::abs(arm.dot(tangent)) - half.dot(tangent.cwiseAbs());
  const double farthest = arm.norm() + half.norm();
  if (box.spread < pi / 2 && aside > farthest * std::sin(box.spread) + box.slack + query.rounding)
    return;
  if (box.second < 0) return consider(box.first, query);
  const auto far = [&](Index child) {
    const Box& other = tree_[static_cast<std::size_t>(child)];
    return (query.x - query.x.cwiseMax(other.lowest).cwiseMin(other.highest)).squaredNorm();
  };
  const bool swap = far(box.second) < far(box.first);
  look(swap ? box.second : box.first, query);
  look(swap ? box.first : box.second, query);
}

void TargetSearch::consider(Index number, Query& query) const {
  const SideCurve& curve = side(number);
  Candidate candidate{number, curve.closest(query.x), 0, 0};
  if (!faces(curve.normal(candidate.xi), query.normal)) return;
  if (std::abs(candidate.xi) == 1) {
    const int end = candidate.xi < 0 ? -1 : 1;
    const Index next = neighbour(number, end);
    if (next >= 0 && faces(side(next).normal(-end), query.normal)) {
      if (side(next).closest(query.x) != -end) return;  // the next side is nearer
      candidate.vertex = end;
    } else {
      candidate.xi = curve.continued(query.x, end);
      if (!(std::abs(candidate.xi) <= 1 + end_tolerance)) return;
    }
  }
  const Vector2d arm = query.x - curve.point(candidate.xi);
  candidate.distance = arm.norm();
  if (arm.dot(curve.normal(candidate.xi)) < -depth(number)) {
    query.buried = query.buried || inside_body(query.x);
    return;
  }
  query.add(candidate);
}

Projection TargetSearch::at_vertex(Index number, int end, const Query& query) const {
  const Index next = neighbour(number, end);
  Projection found;
  found.found = true;
  found.side = std::min(number, next);
  found.xi = found.side == number ? end : -end;
  found.point = side(number).point(end);
  const Vector2d arm = query.x - found.point;
  const Vector2d one = side(number).normal(end);
  const Vector2d two = side(next).normal(-end);
  const double a = cross(arm, one);
  const double b = cross(arm, two);
  // The share of the second normal in the one along the arm.
  const double share = std::abs(a - b) > query.rounding ? std::clamp(a / (a - b), 0.0, 1.0) : 0.5;
  found.normal = ((1 - share) * one + share * two).normalized();
  found.gap = arm.dot(found.normal);
  return found;
}

Projection TargetSearch::chosen(Query& query) const {
  std::vector<Candidate>& all = query.candidates;
  if (all.empty()) {
    Projection none;
    none.buried = query.buried;
    return none;
  }
  std::sort(all.begin(), all.end(),
            [](const Candidate& a, const Candidate& b) { return a.side < b.side; });
  for (const Candidate& one : all) {
    if (one.vertex != 0) return at_vertex(one.side, one.vertex, query);
    for (const Candidate& two : all)
      if (two.side != one.side && two.side == neighbour(one.side, 1))
        return at_vertex(one.side, 1, query);
  }
  const Candidate& best = all.front();
  Projection found;
  found.found = true;
  found.side = best.side;
  found.xi = best.xi;
  found.point = side(best.side).point(best.xi);
  found.normal = side(best.side).normal(best.xi);
  found.gap = (query.x - found.point).dot(found.normal);
  return found;
}

Projection TargetSearch::closest(const Vector2d& x, const Vector2d& normal) const {
  Query query{
      x, normal,
      64 * std::numeric_limits<double>::epsilon() * std::max(size_, x.cwiseAbs().maxCoeff())};
  if (!tree_.empty()) look(static_cast<Index>(tree_.size()) - 1, query);
  Projection found = chosen(query);
  found.visits = query.visits;
  return found;
}

void TargetSearch::look_along(Index number, Query& query) const {
  const Box& box = tree_[static_cast<std::size_t>(number)];
  ++query.visits;
  const Vector2d arm = (box.lowest + box.highest) / 2 - query.x;
  const Vector2d half = (box.highest - box.lowest) / 2;
  const Vector2d across(query.normal.y(), -query.normal.x());
  const double slack = box.slack + query.rounding;
  if (std::abs(arm.dot(across)) > half.dot(across.cwiseAbs()) + slack) return;
  if (std::abs(arm.dot(query.normal)) - half.dot(query.normal.cwiseAbs()) > query.nearest + slack)
    return;
  if (box.second >= 0) {
    look_along(box.first, query);
    look_along(box.second, query);
    return;
  }
  const SideCurve& curve = side(box.first);
  for (const double xi : curve.crossings(query.x, query.normal, end_tolerance)) {
    const Vector2d back = query.x - curve.point(xi);
    if (!faces(curve.normal(xi), query.normal)) continue;
    if (back.dot(curve.normal(xi)) < -depth(box.first))
      query.buried = query.buried || inside_body(query.x);
    else
      query.add({box.first, xi, back.norm(), 0});
  }
}

Projection TargetSearch::along(const Vector2d& x, const Vector2d& normal) const {
  Query query{
      x, normal,
      64 * std::numeric_limits<double>::epsilon() * std::max(size_, x.cwiseAbs().maxCoeff())};
  if (!tree_.empty()) look_along(static_cast<Index>(tree_.size()) - 1, query);
  // A line through a vertex meets both sides: the one that comes first, no normal between them.
  std::vector<Candidate>& all = query.candidates;
  const auto first = std::min_element(all.begin(), all.end(),
                                      [](const auto& a, const auto& b) { return a.side < b.side; });
  if (first != all.end()) all = {*first};
  Projection found = chosen(query);
  found.visits = query.visits;
  return found;
}

std::vector<Index> TargetSearch::near(const Vector2d& lowest, const Vector2d& highest) const {
  std::vector<Index> found;
  std::vector<Index> open;
  if (!tree_.empty()) open.push_back(static_cast<Index>(tree_.size()) - 1);
  while (!open.empty()) {
    const Box& box = tree_[static_cast<std::size_t>(open.back())];
    open.pop_back();
    if ((box.lowest.array() > highest.array()).any() ||
        (box.highest.array() < lowest.array()).any())
      continue;
    if (box.second < 0) {
      found.push_back(box.first);
      continue;
    }
    open.push_back(box.first);
    open.push_back(box.second);
  }
  std::sort(found.begin(), found.end());
  return found;
}

double TargetSearch::depth(Index number) const {
  const CellSide& own = boundary(*mesh_, boundary_)[static_cast<std::size_t>(number)];
  const SideCurve& curve = side(number);
  const Vector2d chord = (curve.point(1) - curve.point(-1)).normalized();
  double depth = 0;
  for (int k = 2; k < 4; ++k) {
    const Index corner = mesh_->cells(own.cell, (own.side + k) % 4);
    const Vector2d arm = mesh_->nodes.row(corner).transpose() - curve.point(-1);
    depth = std::max(depth, cross(chord, arm));
  }
  return depth;
}

bool TargetSearch::inside_body(const Vector2d& x) const {
  for (Index cell = 0; cell < mesh_->n_cells(); ++cell) {
    bool inside = true;
    for (int k = 0; k < 4 && inside; ++k) {
      const Vector2d a = mesh_->nodes.row(mesh_->cells(cell, k)).transpose();
      const Vector2d b = mesh_->nodes.row(mesh_->cells(cell, (k + 1) % 4)).transpose();
      inside = cross(b - a, x - a) >= 0;
    }
    if (inside) return true;
  }
  return false;
}

}  // namespace signorini
