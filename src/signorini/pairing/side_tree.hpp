/// \file
/// Sides of a boundary in a tree of boxes that also know the normals inside.
///
/// It is the bounding volume hierarchy of computer graphics, with one addition. There a ray asks
/// what it hits, here a point asks what it faces, and directions of normals exclude more than
/// distances do.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// A box around sides, and all normals that a projection on them can have.
struct SideBox {
  Eigen::Vector2d lowest;    ///< corner [length]
  Eigen::Vector2d highest;   ///< opposite corner [length]
  Eigen::Vector2d axis;      ///< middle of the normals, unit vector [-]
  double spread = 0;         ///< angle from the axis to the farthest normal, pi at most [rad]
  double slack = 0;          ///< by how much a projection may miss the box [length]
  Eigen::Index first = -1;   ///< a child; in a leaf the number of its side
  Eigen::Index second = -1;  ///< the other child; in a leaf -1

  /// \return whether it holds one side only
  [[nodiscard]] bool is_leaf() const { return second < 0; }
  /// \param x  a point [length]
  /// \return its distance from the box, 0 inside [length]
  [[nodiscard]] double distance(const Eigen::Vector2d& x) const;
  /// Whether a projection of x on the sides inside is possible at all.
  ///
  /// The line from x to its projection runs along the normal there, so that the box must meet the
  /// wedges that open from x along the normals inside: what lies beside a flat target is told from
  /// it at once, not after a look at all of its sides.
  /// \param x         a point [length]
  /// \param rounding  of distances [length]
  /// \return false only if no line from x into the box is along a normal inside
  [[nodiscard]] bool may_hold_foot(const Eigen::Vector2d& x, double rounding) const;
  /// \param x          on a line [length]
  /// \param direction  of the line, unit vector [-]
  /// \param reach      how far from x, both ways [length]
  /// \param rounding   of distances [length]
  /// \return whether that stretch of the line may meet the box; false only if it does not
  [[nodiscard]] bool may_meet(const Eigen::Vector2d& x, const Eigen::Vector2d& direction,
                              double reach, double rounding) const;
};

/// Puts boxes around boxes, two by two.
/// \param leaves  one box per side, at least one
/// \return the boxes, every one after its two children: the one around all is the last
[[nodiscard]] std::vector<SideBox> box_tree(std::vector<SideBox> leaves);

/// \param a  a vector
/// \param b  another
/// \return angle between them, 0 to pi [rad]
[[nodiscard]] double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

}  // namespace signorini
