// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How far along a boundary a place is.
#pragma once
#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "signorini/fem/side_curve.hpp"

namespace signorini {

/// The sides of a boundary, each with the length of those before it. Sides that do not meet follow one another without a gap.
class ArcLength {
 public:
  /// \param mesh      that has the boundary
  /// \param boundary  its name
  /// \throws ProblemError if there is no such boundary, or it has no sides
  ArcLength(const Mesh& mesh, const std::string& boundary);

  /// \return the sides in walking order
  [[nodiscard]] const std::vector<SideCurve>& sides() const { return sides_; }
  /// Where lengths are reached within a side.
  /// \param side     any, also one of a finer mesh of the boundary
  /// \param lengths  from the begin of the boundary [length]
  /// \return xi in (-1, 1), without those of lengths that are reached at an end of the side or on another one
  [[nodiscard]] std::vector<double> places(const SideCurve& side,
                                           const std::vector<double>& lengths) const;
  /// \param side  number of a side \param xi  place on it [-] \return length from the begin of the boundary [length]
  [[nodiscard]] double at(std::size_t side, double xi) const;
  /// \param x  a point [length] \return length up to the closest place of the boundary; of several the first [length]
  [[nodiscard]] double at(const Eigen::Vector2d& x) const;
  /// \return length of the whole boundary [length]
  [[nodiscard]] double whole() const { return before_.back(); }
  /// \return length up to each node, by its number; where a closed boundary begins it is 0 [length]
  [[nodiscard]] std::map<Eigen::Index, double> of_nodes() const;

 private:
  std::vector<SideCurve> sides_;
  std::vector<Eigen::Matrix2d> boxes_;
  std::vector<double> before_ = {0};  // one more than there are sides
};

}  // namespace signorini
