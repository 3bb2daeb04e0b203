// # A tree of boxes
//
// A boundary of \f$n\f$ sides, asked from \f$n\f$ points, costs \f$n^2\f$ looks. Boxes around
// pairs of boxes make a tree of \f$2n - 1\f$ boxes: a point that is farther from a box than from
// the best place found so far skips all that is in it. Then each point costs about \f$\log n\f$.
//
// Distance alone is not enough. Take a punch that is wider than a flat target: a point far beside
// it has no place that it faces, but no side is so far away that distance would exclude it, since
// nothing was found yet. All sides would be opened, for nothing. So a box also knows the normals
// of its sides, as a cone: an axis and the angle \f$\alpha\f$ from it to the farthest normal. The
// line from \f$p\f$ to its closest place runs along a normal. If the box reaches \f$r\f$ far at
// most, it can hold such a place only if it comes within \f$r\sin\alpha\f$ of the axis through
// \f$p\f$. A flat target has \f$\alpha = 0\f$, and what lies beside it is told at the first box.

#include "signorini/pairing/side_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "signorini/core/plane.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// The smallest box around two, except for the numbers of the children.
///
/// The axis of two cones is the middle of their axes; the new angle covers both. It may be larger
/// than needed. It must not be smaller, or a contact would be overlooked.
SideBox around(const SideBox& one, const SideBox& two) {
  SideBox box;
  box.lowest = one.lowest.cwiseMin(two.lowest);
  box.highest = one.highest.cwiseMax(two.highest);
  box.slack = std::max(one.slack, two.slack);
  box.axis = one.axis + two.axis;
  const bool opposite = box.axis.norm() < 1e-6;  // then nothing can be told
  box.axis = opposite ? one.axis : box.axis.normalized();
  for (const SideBox* child : {&one, &two})
    box.spread = std::max(box.spread, angle_between(box.axis, child->axis) + child->spread);
  box.spread = opposite ? pi : std::min(pi, box.spread);
  return box;
}

/// Adds the boxes of some leaves. \return the number of the one around them
///
/// Halves at the median of the longer direction. The tree is balanced whatever the mesh, and the
/// order of sides with equal places is decided by their number, so that it is the same on every
/// machine.
std::size_t build(std::vector<SideBox>& leaves, std::size_t begin, std::size_t end,
                  std::vector<SideBox>& boxes) {
  if (end - begin == 1) {
    boxes.push_back(leaves[begin]);
    return boxes.size() - 1;
  }
  Eigen::AlignedBox2d all;
  for (std::size_t k = begin; k < end; ++k) all.extend(leaves[k].lowest).extend(leaves[k].highest);
  const int axis = all.sizes().x() >= all.sizes().y() ? 0 : 1;
  const std::size_t half = begin + (end - begin) / 2;
  const auto at = [&](std::size_t k) { return leaves.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(half), at(end), [axis](const SideBox& a, const SideBox& b) {
    const double left = a.lowest(axis) + a.highest(axis);
    const double right = b.lowest(axis) + b.highest(axis);
    return left < right || (left == right && a.first < b.first);
  });
  const std::size_t first = build(leaves, begin, half, boxes);
  const std::size_t second = build(leaves, half, end, boxes);
  SideBox both = around(boxes[first], boxes[second]);
  both.first = static_cast<Index>(first);
  both.second = static_cast<Index>(second);
  boxes.push_back(both);
  return boxes.size() - 1;
}

}  // namespace

/// The arc tangent of sine and cosine. An arc cosine would lose half of the digits of small angles.
double angle_between(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

double SideBox::distance(const Vector2d& x) const {
  return (x - x.cwiseMax(lowest).cwiseMin(highest)).norm();
}

/// `aside` is how far the box is at least from the line through \f$x\f$ along the axis. `farthest`
/// is the \f$r\f$ of above. With a cone of a right angle or more, every direction is possible and
/// nothing is excluded.
bool SideBox::may_hold_foot(const Vector2d& x, double rounding) const {
  if (spread >= pi / 2) return true;
  const Vector2d arm = x - (lowest + highest) / 2;
  const Vector2d half = (highest - lowest) / 2;
  const Vector2d tangent(axis.y(), -axis.x());
  const double aside = std::abs(arm.dot(tangent)) - half.dot(tangent.cwiseAbs());
  const double farthest = arm.norm() + half.norm();
  return aside <= farthest * std::sin(spread) + slack + rounding;
}

/// A line of given direction meets the box only if the box is neither beside it nor too far ahead.
/// Normals do not matter here.
bool SideBox::may_meet(const Vector2d& x, const Vector2d& direction, double reach,
                       double rounding) const {
  const Vector2d arm = (lowest + highest) / 2 - x;
  const Vector2d half = (highest - lowest) / 2;
  const Vector2d across(direction.y(), -direction.x());
  const double beside = std::abs(arm.dot(across)) - half.dot(across.cwiseAbs());
  const double ahead = std::abs(arm.dot(direction)) - half.dot(direction.cwiseAbs());
  return beside <= slack + rounding && ahead <= reach + slack + rounding;
}

/// Children stand before the box around them, and so the last box holds all.
std::vector<SideBox> box_tree(std::vector<SideBox> leaves) {
  std::vector<SideBox> boxes;
  boxes.reserve(2 * leaves.size());
  build(leaves, 0, leaves.size(), boxes);
  return boxes;
}

}  // namespace signorini
