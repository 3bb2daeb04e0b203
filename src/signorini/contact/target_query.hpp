/// \file
/// What TargetSearch keeps in mind while it looks for the place that a point faces.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <vector>

#include "signorini/contact/target_search.hpp"

namespace signorini {

/// \param a  a vector in the plane
/// \param b  another
/// \return a_x b_y - a_y b_x
[[nodiscard]] inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// \param target_normal  unit vector [-]
/// \param source_normal  of any length of about 1 [-]
/// \return whether they are more than 90 degrees apart, by more than rounding
[[nodiscard]] inline bool faces(const Eigen::Vector2d& target_normal,
                                const Eigen::Vector2d& source_normal) {
  return target_normal.dot(source_normal) < -1e-6;
}

/// A place of one side that the point may be paired with.
struct TargetSearch::Candidate {
  Eigen::Index side;  ///< its number in the list of the boundary
  double xi;          ///< place on it, -1 to 1 [-]
  double distance;    ///< from the point [length]
  int vertex;         ///< -1 or 1: the end of the side at which the point faces the vertex; 0: none
};

/// One search: what is asked, and what was found so far.
struct TargetSearch::Query {
  /// Begins a search.
  /// \param point          to be paired [length]
  /// \param source_normal  out of the source there, of any length of about 1 [-]
  /// \param size           of the target, for what rounding makes of distances [length]
  Query(const Eigen::Vector2d& point, const Eigen::Vector2d& source_normal, double size)
      : x(point),
        normal(source_normal),
        rounding(64 * std::numeric_limits<double>::epsilon() *
                 std::max(size, point.cwiseAbs().maxCoeff())) {}

  Eigen::Vector2d x;                                         ///< the point [length]
  Eigen::Vector2d normal;                                    ///< out of the source [-]
  double rounding;                                           ///< of distances [length]
  double nearest = std::numeric_limits<double>::infinity();  ///< smallest distance so far [length]
  std::vector<Candidate> candidates;                         ///< within rounding of the nearest
  bool buried = false;      ///< whether the point lies in the target
  Eigen::Index visits = 0;  ///< boxes that were opened

  /// Takes note of a place. \param candidate  dropped unless it is among the nearest
  void add(const Candidate& candidate) {
    if (candidate.distance < nearest - rounding) candidates.clear();
    if (candidate.distance <= nearest + rounding) candidates.push_back(candidate);
    nearest = std::min(nearest, candidate.distance);
  }
};

}  // namespace signorini
