/// \file
/// Quantities that a solution is asked for, and whose error is estimated.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "signorini/core/alignment.hpp"
#include "signorini/scene/solution.hpp"

namespace signorini {

/// How large the resultant of one contact is, of normal and friction forces [force].
struct ContactForce {
  std::string contact = {};  ///< as in Model::contacts; may be left out if there is one only
};

/// What presses the sides of one contact together: the sum of the normal forces of its pairs, compression > 0, the integral
/// of the pressure [force]. Along a straight side it is the normal resultant; along a closed ring that has none.
struct NormalForce {
  std::string contact = {};  ///< as of ContactForce
  /// Which part of the pressure at a place of the source counts [-]; all of it without one. Where the function jumps
  /// inside a side, nodal forces cannot follow it.
  ScalarField share = {};
};

/// One component of the displacement of a boundary, its mean over it, or of one point [length].
struct Displacement {
  std::string body = {};                      ///< its name; may be left out if there is one only
  Axis axis = Axis::Y;                        ///< which component
  std::string boundary = {};                  ///< whose mean is meant, unless there is a point
  std::optional<Eigen::Vector2d> point = {};  ///< a node, or a place on the edge [length]
};

/// The highest pressure of a contact that presses as Hertz's does, from a fit of its middle: fit_hertz() [force/length^2]. In
/// axial symmetry a contact whose middle is on the axis is a circle, others are strips.
struct PeakPressure {
  std::string contact = {};                          ///< as of ContactForce
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< of the contact, before loading [length]
};

/// Half of the width of such a contact, from the second moment of its forces: half_width_of_forces() [length]; of a
/// circle its radius.
struct HalfWidth {
  std::string contact = {};                          ///< as of ContactForce
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< of the contact, before loading [length]
};

/// What a solution is asked for.
struct Goal {
  std::string name;  ///< what tables call it
  std::variant<ContactForce, NormalForce, Displacement, PeakPressure, HalfWidth>
      quantity;  ///< what it is
};

/// Reads a goal off a solution.
/// \param model     from build()
/// \param solution  of it
/// \param goal      any
/// \return its value: [force], [length] or [force/length^2]
/// \throws ProblemError if there is no such body, boundary, point or contact, or the problem is not solved; if a width or a
///   peak is asked for where the pairs have no nodes, or too few of them press; if the resultant of a contact is nothing beside its forces
[[nodiscard]] double value(const Model& model, const Solution& solution, const Goal& goal);

/// How large the terms are that a goal is the sum of: of the mean of a displacement the lengths of all displacements there,
/// of a NormalForce the forces of its pairs. Where they cancel, a value much smaller is rounding.
/// \param model     from build()
/// \param solution  of it
/// \param goal      any
/// \return the sum of their sizes, as the value; of others the size of the value
/// \throws ProblemError as value()
[[nodiscard]] double terms_of(const Model& model, const Solution& solution, const Goal& goal);

/// How a goal changes with the solution: \f$ dJ = j^T du + w^T d\lambda \f$.
struct GoalGradient {
  Eigen::VectorXd displacement;  ///< j `n`, of the unknowns; empty if it depends on forces only
  Eigen::VectorXd force;         ///< w, of all rows of A; empty if it depends on displacements only
};

/// \param model     from build()
/// \param solution  of it
/// \param goal      any; of the fit of a peak the nodes that take part stay the same
/// \return its derivatives
/// \throws ProblemError as value()
[[nodiscard]] GoalGradient gradient(const Model& model, const Solution& solution, const Goal& goal);

/// What a goal overlooks between the nodes: of a NormalForce the pressure there that counts more, or less, than the
/// straight lines of `share` between nodes say; of a PeakPressure on sides of two nodes, where a nodal pressure is a mean, what
/// such means of the ellipse change its fit by.
/// \param model     from build()
/// \param solution  of it
/// \param goal      any
/// \return what is to be added to its value; 0 of all others
/// \throws ProblemError as value()
[[nodiscard]] double quadrature_error(const Model& model, const Solution& solution,
                                      const Goal& goal);

/// What a reading may be wrong by because pressure is not what it takes it for: of a PeakPressure, how far the peak of half
/// of the middle that is fitted is from that of all of it; the whole peak if that half cannot be fitted. Of a HalfWidth, how
/// far it is from that of an ellipse with the fitted peak which bears the same force; the whole width if no peak can be
/// fitted. Of Hertz's contact it vanishes as the mesh is refined.
/// \param model     from build()
/// \param solution  of it
/// \param goal      any
/// \return its size, 0 of all others
/// \throws ProblemError as value()
[[nodiscard]] double model_error(const Model& model, const Solution& solution, const Goal& goal);

}  // namespace signorini
