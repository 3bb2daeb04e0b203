// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Pressures along one contact, as a fit of an ellipse and a second moment read them.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "closed_form/hertz_fit.hpp"
#include "signorini/core/alignment.hpp"
#include "signorini/scene/solution.hpp"

namespace signorini {

/// The pairs of one contact.
/// \param model    from build()
/// \param contact  its name, or nothing if there is one only
/// \return their numbers, in walking order of the source
/// \throws ProblemError listing the contacts if there is none of that name
[[nodiscard]] std::vector<Eigen::Index> pairs_of(const Model& model, const std::string& contact);

/// The pairs of a contact along the line that it lies on.
struct ContactLine {
  std::vector<Eigen::Index> pair;          ///< their numbers, x rising
  std::vector<double> x;                   ///< from the middle, along the tangent there [length]
  Footprint footprint = Footprint::Strip;  ///< a circle where the middle lies on the axis
};

/// \param model    from build()
/// \param contact  its name, or nothing if there is one only
/// \param middle   of the contact [length]
/// \return its pairs along the tangent of the one nearest to the middle, on both sides as far as the source does not turn
///   back: of a whole rim the half around the middle. In axial symmetry a contact whose middle is on the axis is a circle
/// \throws ProblemError as pairs_of(), or if pairs have no nodes
[[nodiscard]] ContactLine line_of(const Model& model, const std::string& contact,
                                  const Eigen::Vector2d& middle);

/// What a fit and a second moment are read from.
struct Profile {
  ContactLine line;  ///< where the pairs are
  /// From forces of the pairs to forces across the line on their nodes [-]; those of a strip that goes around an axis are
  /// taken to the length of the circle through the middle
  Eigen::MatrixXd nodal;
  std::vector<double> force;     ///< on the nodes, across the line [force]
  std::vector<double> pressure;  ///< of the pairs: force over weight [force/length^2]
  Trace trace;                   ///< how displacements of the source vary between nodes
};

/// \param model     from build()
/// \param solution  of it
/// \param contact   its name, or nothing if there is one only
/// \param middle    of the contact [length]
/// \return forces and pressures of its nodes
/// \throws ProblemError as line_of()
[[nodiscard]] Profile profile(const Model& model, const Solution& solution,
                              const std::string& contact, const Eigen::Vector2d& middle);

}  // namespace signorini
