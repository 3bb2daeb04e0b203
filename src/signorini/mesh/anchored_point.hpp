/// \file
/// Points whose differences keep, far from the origin, the digits that their positions lose.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// A point as a node, or another position that is exact, and the way from there. Far from the origin the
/// position of a place on a side is rounded more than the way to it: what is computed from points is computed
/// from their differences, which are as exact as the nodes are.
class AnchoredPoint {
 public:
  /// \param position  that is taken as exact [length]
  template <typename Derived>
  AnchoredPoint(const Eigen::MatrixBase<Derived>& position) : anchor_(position) {}
  /// \param x  coordinate that is taken as exact [length] \param y  the other
  AnchoredPoint(double x, double y) : anchor_(x, y) {}
  /// \param anchor  position that is taken as exact [length]
  /// \param arm     from there to the point [length]
  AnchoredPoint(const Eigen::Vector2d& anchor, const Eigen::Vector2d& arm)
      : anchor_(anchor), arm_(arm) {}

  /// \return where it is, rounded [length]
  [[nodiscard]] Eigen::Vector2d position() const { return anchor_ + arm_; }
  /// \param way  from here [length] \return the point there
  [[nodiscard]] AnchoredPoint operator+(const Eigen::Vector2d& way) const {
    return {anchor_, arm_ + way};
  }
  /// \param to  a point \param from  another \return the way between them [length]
  friend Eigen::Vector2d operator-(const AnchoredPoint& to, const AnchoredPoint& from) {
    return (to.anchor_ - from.anchor_) + (to.arm_ - from.arm_);
  }

 private:
  Eigen::Vector2d anchor_;
  Eigen::Vector2d arm_ = {0, 0};
};

}  // namespace signorini
