#include "addons/estimate/outline_shape.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/index.hpp"
#include "signorini/core/plane.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/joints.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

}  // namespace

OutlineShape::OutlineShape(const Mesh& mesh) : mesh_(mesh), turns_(at(mesh.n_nodes())) {
  std::vector<char> several(turns_.size(), 0);
  for (const CellSide& side : outer_sides(mesh)) {
    const std::vector<Index> nodes = mesh.side_nodes(side);
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      Turn& first = turns_[at(nodes[k])];
      Turn& last = turns_[at(nodes[k + 1])];
      if (first.behind >= 0) several[at(nodes[k])] = 1;
      if (last.before >= 0) several[at(nodes[k + 1])] = 1;
      first.behind = nodes[k + 1];
      last.before = nodes[k];
    }
  }
  // Positions are rounded to that; a triangle of three nodes that is no higher is a line.
  const double rounding = 8 * epsilon * mesh.nodes.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < turns_.size(); ++k) {
    Turn& here = turns_[k];
    if (here.before < 0 || here.behind < 0 || several[k] != 0) continue;
    const Vector2d in = way(here.before, static_cast<Index>(k));
    const Vector2d out = way(static_cast<Index>(k), here.behind);
    here.corner = false;
    if (in.dot(out) > 0 && std::abs(cross(in, out)) <= rounding * (in + out).norm()) continue;
    here.angle = std::atan2(cross(in, out), in.dot(out));
    here.curvature = 2 * cross(in, out) / (in.norm() * out.norm() * (in + out).norm());
  }
  const double sharp = std::acos(0.5);
  const double twice = 2 * (1 + std::sqrt(epsilon));
  std::vector<char> corner(turns_.size(), 0);
  for (std::size_t k = 0; k < turns_.size(); ++k) {
    const Turn& here = turns_[k];
    if (here.corner) continue;
    const double near =
        std::max(std::abs(turn(here.before).angle), std::abs(turn(here.behind).angle));
    corner[k] = std::abs(here.angle) > sharp || std::abs(here.angle) > twice * near ? 1 : 0;
  }
  for (std::size_t k = 0; k < turns_.size(); ++k)
    turns_[k].corner = turns_[k].corner || corner[k] != 0;
}

const OutlineShape::Turn& OutlineShape::turn(Index node) const { return turns_[at(node)]; }

Vector2d OutlineShape::way(Index from, Index to) const {
  return (mesh_.nodes.row(to) - mesh_.nodes.row(from)).transpose();
}

double OutlineShape::curvature(const Turn& first, const Turn& last) const {
  const auto straight = [](const Turn& node) { return !node.corner && node.angle == 0; };
  if (straight(first) || straight(last)) return 0;
  const bool arc_before = !first.corner && !straight(turn(first.before));
  const bool arc_behind = !last.corner && !straight(turn(last.behind));
  if (!arc_before && !arc_behind) return 0;
  if (first.corner) return last.curvature;
  if (last.corner) return first.curvature;
  const auto change = [&](const Turn& near, const Turn& far, const Turn& other) {
    const double by = near.curvature - (far.corner ? other : far).curvature;
    return by * by;
  };
  const double before = change(first, turn(first.before), last);
  const double behind = change(last, turn(last.behind), first);
  if (before + behind == 0) return first.curvature;
  return (behind * first.curvature + before * last.curvature) / (before + behind);
}

Vector2d OutlineShape::middle(Index first, Index last) const {
  const Vector2d along = way(first, last);
  const Vector2d start = mesh_.nodes.row(first);
  const Turn& here = turn(first);
  const double bent =
      here.behind == last && turn(last).before == first ? curvature(here, turn(last)) : 0;
  if (bent == 0) return start + along / 2;
  const double half = std::clamp(bent * along.norm() / 2, -1.0, 1.0);  // sine of half the angle
  const double rise = half / (1 + std::sqrt(1 - half * half)) / 2;     // by the length of the way
  return start + (along / 2 + rise * Vector2d(along.y(), -along.x()));
}

}  // namespace signorini
