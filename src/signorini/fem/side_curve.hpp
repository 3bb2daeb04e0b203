/// \file
/// The line along which two nodes, or three, of a cell side lie: shape functions, normals, projections.
///
/// A place on a side is computed from three nodes, and its gap to another body is a difference of
/// two such places. At \f$x = 10^6\f$ a place is rounded to \f$10^{-10}\f$, and a gap of
/// \f$10^{-9}\f$ would have one digit. So a point is kept as a node and a short way from it
/// (AnchoredPoint), and differences are taken part by part.
#pragma once
#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// A vector in about twice the working precision.
struct ExactWay {
  Eigen::Vector2d rounded = {0, 0};  ///< [length]
  Eigen::Vector2d rest = {0, 0};     ///< what rounding has taken from it [length]
};

/// A point as a node, or another position that is exact, and the way from there. Far from the origin the
/// position of a place on a side is rounded more than the way to it: what is computed from points is computed
/// from their differences, which are as exact as the nodes are. What rounding takes from the way is kept, too: of places that nearly
/// coincide the difference has all its digits.
class AnchoredPoint {
 public:
  /// \param position  that is taken as exact [length]
  template <typename Derived>
  AnchoredPoint(const Eigen::MatrixBase<Derived>& position) : anchor_(position) {}
  /// \param x  coordinate that is taken as exact [length] \param y  the other
  AnchoredPoint(double x, double y) : anchor_(x, y) {}
  /// \return where it is, rounded [length]
  [[nodiscard]] Eigen::Vector2d position() const { return anchor_ + arm_; }
  /// \param share  how much of a way [-] \param way  from here \return the point there, in about twice the working precision
  [[nodiscard]] AnchoredPoint moved(double share, const ExactWay& way) const;
  /// \param from  another point \return the way from there to here
  [[nodiscard]] ExactWay way_from(const AnchoredPoint& from) const;
  /// \param to  a point \param from  another \return the way between them, to the rounding of their arms [length]
  friend Eigen::Vector2d operator-(const AnchoredPoint& to, const AnchoredPoint& from) {
    return (to.anchor_ - from.anchor_) + (to.arm_ - from.arm_);
  }

 private:
  AnchoredPoint(const Eigen::Vector2d& anchor, const Eigen::Vector2d& arm,
                const Eigen::Vector2d& rest)
      : anchor_(anchor), arm_(arm), rest_(rest) {}

  Eigen::Vector2d anchor_;
  Eigen::Vector2d arm_ = {0, 0};
  Eigen::Vector2d rest_ = {0, 0};  // what rounding has taken from the arm
};

/// Values at the nodes of a side, in walking order: first, last; or first, middle, last.
struct SideShape {
  Eigen::Vector3d value;  ///< N [-]; the third is 0 on a side of two nodes
  Eigen::Vector3d slope;  ///< dN/dxi [-]
};

/// Linear or quadratic shape functions of a side.
/// \param n_nodes  2 or 3
/// \param xi       place along the side, -1 at its first node and 1 at its last [-]
/// \return values and slopes in the order of Mesh::side_nodes()
[[nodiscard]] SideShape side_shape(std::size_t n_nodes, double xi);

/// One side of a mesh as the curve x(xi), straight or a parabola. The body lies to its left.
class SideCurve {
 public:
  /// \param mesh  that has the side
  /// \param side  of one of its cells
  SideCurve(const Mesh& mesh, const CellSide& side);

  /// \return numbers of its 2 or 3 nodes in walking order
  [[nodiscard]] const std::vector<Eigen::Index>& nodes() const { return nodes_; }
  /// \param xi  place along the side [-]
  /// \return shape functions there
  [[nodiscard]] SideShape shape(double xi) const { return side_shape(nodes_.size(), xi); }
  /// \param xi  place along the side [-]
  /// \return the point there; exactly the node at -1 and 1, otherwise in about twice the working precision
  [[nodiscard]] AnchoredPoint point(double xi) const;
  /// \param xi  place along the side [-]
  /// \return dx/dxi [length], in walking direction
  [[nodiscard]] Eigen::Vector2d tangent(double xi) const {
    return slope_.rounded + 2 * xi * bend_.rounded;
  }
  /// \param xi  place along the side [-]
  /// \return unit vector out of the body [-]
  [[nodiscard]] Eigen::Vector2d normal(double xi) const;
  /// Lowest and highest coordinates of a box around the side.
  /// \return columns: lowest, highest (x, y) [length]
  [[nodiscard]] Eigen::Matrix2d box() const;
  /// Closest place of the side: all places where the distance is smallest nearby are compared, each
  /// found by Newton's method between bounds that hold one of them only.
  /// \param x  a point [length]
  /// \return xi in [-1, 1]; the lower of two at the same distance
  [[nodiscard]] double closest(const AnchoredPoint& x) const;
  /// Where x stands square on the curve continued beyond an end.
  /// \param x    a point [length], closest to that end of the side
  /// \param end  -1 or 1
  /// \return xi beyond the end; not finite if there is none near
  [[nodiscard]] double continued(const AnchoredPoint& x, int end) const;
  /// Where a line meets the curve.
  /// \param x          on the line [length]
  /// \param direction  of the line [-]
  /// \param beyond     how far beyond the ends the curve is continued, in xi [-]
  /// \return up to two places xi, increasing
  [[nodiscard]] std::vector<double> crossings(const AnchoredPoint& x,
                                              const Eigen::Vector2d& direction,
                                              double beyond) const;

 private:
  std::vector<Eigen::Index> nodes_;
  Eigen::Vector2d first_, last_;
  AnchoredPoint middle_;
  ExactWay slope_, bend_;  // x = middle + slope xi + bend xi^2
};

/// A node on one of its sides.
struct NodeOnSide {
  const SideCurve* side;   ///< one that it belongs to
  double xi;               ///< where on it: -1, 0 or 1 [-]
  Eigen::Vector2d normal;  ///< sum of the normals of all its sides there, out of the body [-]
};

/// Where the nodes of a boundary are on its sides.
/// \param sides  of the boundary; must outlive the result
/// \return by number of the node
[[nodiscard]] std::map<Eigen::Index, NodeOnSide> nodes_on_sides(
    const std::vector<SideCurve>& sides);

/// \param mesh      any
/// \param boundary  the name of one of its boundaries
/// \return its sides as curves, in walking order
/// \throws ProblemError if there is no such boundary, or it has no sides
[[nodiscard]] std::vector<SideCurve> side_curves(const Mesh& mesh, const std::string& boundary);

}  // namespace signorini
