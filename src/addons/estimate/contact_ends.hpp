// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Where contact ends: a mesh puts its end at a node, and goals notice.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "addons/estimate/contact_edges.hpp"
#include "addons/estimate/dual.hpp"

namespace signorini {

/// A place where contact ends, between a closed pair and an open one.
struct ContactEnd {
  Eigen::Index closed;  ///< number of the last closed pair
  Eigen::Index open;    ///< number of the open one beside it
  double pull;          ///< what the open one would carry if it were closed, < 0 [force]
  double overlap;       ///< the gap of the closed one if it carried nothing, < 0 [length]
  double offset;        ///< t, see free_boundary() [pairs]
};

/// \param edges     contact_edges() of the model
/// \param solution  of it
/// \param dual      of both; no pair slides
/// \return the ends of all contacts, in the order of the edges
[[nodiscard]] std::vector<ContactEnd> contact_ends(const std::vector<ContactEdge>& edges,
                                                   const Solution& solution, const Dual& dual);

/// What a goal J lacks because contact must end at a node.
///
/// With the end s pairs further out the pressure at the end is singular in proportion to s - t, where contact belongs: the
/// energy of the bodies grows by \f$ (t - 1/2)^2 \f$ when the open pair is closed, and it falls by \f$ (t + 1/2)^2 \f$ when the
/// closed one is opened, in the same unit. Both are products of a force and a gap, and their roots
/// give t, between -1/2 and 1/2 and the same for all goals. Every goal is stationary there. So
///
/// \f[ J(s) = J + a s + c s^2 + d s^3, \qquad J(\pm 1) = J_\pm, \qquad J'(t) = 0, \qquad V = J(t) - J, \f]
///
/// with the \f$ J_\pm \f$ of the end one pair further out and in. The cubic counts: how strongly J depends on the singular
/// pressure also changes with the end, for the half-width of Hertz's contact by the share 1/b.
/// \param end        from contact_ends()
/// \param per_force  what a force on the open pair adds to J [goal/force]
/// \param per_gap    mu of the closed pair [goal/length]
/// \return V [goal]
[[nodiscard]] double free_boundary(const ContactEnd& end, double per_force, double per_gap);

/// The cells around the end of a contact. There stresses of the solution and of the dual are both singular, in
/// proportion to how far the end is from where it belongs; free_boundary() counts that, and recovery does not see it.
/// \param ends   from contact_ends()
/// \param model  whose contacts they are of
/// \param body   one of its bodies
/// \return per cell of the body how much of its error products counts, 1 away from all ends; 0 where the cell is around all
///   nodes that the last closed pair presses [-]
[[nodiscard]] Eigen::VectorXd away_from_ends(const std::vector<ContactEnd>& ends,
                                             const Model& model, const BodyModel& body);

}  // namespace signorini
