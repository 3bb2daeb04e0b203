// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What TargetSearch keeps in mind while it looks for the place that a point faces.
///
/// A search asks one question of thousands of sides. What it has found so far, and how much
/// rounding may have spoilt it, travels along in a Query, so that the search itself is a const
/// function of the target.
///
/// Rounding is estimated once, from the sizes at hand. Lengths of the size of the target are
/// computed with, each with its error; coordinates far from the origin have lost more before. Two
/// distances that differ by less are equal, and both candidates stay.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <vector>

#include "signorini/core/plane.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/pairing/target_search.hpp"

namespace signorini {

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
  /// \param target         box around all sides
  Query(const AnchoredPoint& point, const Eigen::Vector2d& source_normal, const SideBox& target)
      : x(point), position(point.position()), normal(source_normal) {
    const double far = position.cwiseAbs()
                           .cwiseMax(target.lowest.cwiseAbs())
                           .cwiseMax(target.highest.cwiseAbs())
                           .maxCoeff();
    const double size = (target.highest - target.lowest).norm() + target.distance(position);
    rounding = epsilon * (64 * size + 8 * far);
  }

  AnchoredPoint x;           ///< the point
  Eigen::Vector2d position;  ///< of it, rounded [length]
  Eigen::Vector2d normal;    ///< out of the source [-]
  /// What rounding may make of a distance: of arithmetic with lengths, and of coordinates [length]
  double rounding;
  double nearest = std::numeric_limits<double>::infinity();  ///< smallest distance so far [length]
  std::vector<Candidate> candidates;                         ///< within rounding of the nearest
  bool inside = false;  ///< whether the point lies in the target
  /// How far it lies behind the nearest side that it is too deep for; 0: behind none [length]
  double penetration = 0;
  Eigen::Index visits = 0;  ///< boxes that were opened

  /// Takes note of a place. \param candidate  dropped unless it is among the nearest
  void add(const Candidate& candidate) {
    if (candidate.distance < nearest - rounding) candidates.clear();
    if (candidate.distance <= nearest + rounding) candidates.push_back(candidate);
    nearest = std::min(nearest, candidate.distance);
  }
  /// Takes note of a side that the point is too deep for. \param distance  from it [length]
  void pass(double distance) {
    penetration = penetration > 0 ? std::min(penetration, distance) : distance;
  }
};

}  // namespace signorini
