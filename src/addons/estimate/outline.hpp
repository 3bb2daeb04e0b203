// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What the sides of cells cut off a curved outline, or add to it, and what that counts for goals.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "addons/estimate/contact_on_nodes.hpp"
#include "addons/estimate/goal.hpp"
#include "addons/estimate/recovery.hpp"

namespace signorini {

/// A side of a cell that the outline leaves between its nodes.
struct OutlineShare {
  CellSide side;           ///< on the outline
  Eigen::VectorXd amount;  ///< what it adds to the error of each goal [goal]
};

/// A field of a body with all that moves it.
struct WholeField {
  NodeArray displacement;  ///< `n_nodes x 2`, with the rigid part [length]
  NodeArray pressure;      ///< `n_nodes x 2`: ContactOnNodes::pressures() [force/length^2]
};

/// The change of goals when the outline of a body leaves its sides for the curve that its nodes lie on, see OutlineShape.
///
/// Between a side and its arc lies a sliver of the height \f$ \delta \f$, out of the body > 0. With the fields continued
/// into it, the dual solution says what its body force, its stresses and the loads on it count, to first order
///
/// \f[ J(\Omega) - J(\Omega_h) = \sum \int \delta\,(f^T z - \sigma_u^{*T} D^{-1} \sigma_z^*)\,ds
///   + \int_{\text{arc}} t^T z\,ds - \int_{\text{side}} t^T z\,ds
///   + \int \delta\,(\mu\,c_u + \lambda\,c_z)\,ds, \f]
///
/// with recovered stresses. A pressure p is normal to both lines, and its part is \f$ -p \int \delta\,\nabla\!\cdot z \f$. A
/// mean displacement of a curved boundary changes with the boundary as a traction does. The last part is what contact holds
/// in other places than the curve. With an obstacle it holds the nodes: between them a field v with the strains
/// \f$ \varepsilon \f$ along and across the curve lacks, by \f$ \delta \f$,
///
/// \f[ c_v = 2 r\,\varepsilon_t - \varepsilon_n - r^2 \kappa\,v_n, \f]
///
/// where \f$ \kappa \f$ is the curvature of the curve, and r the angle by which the normals of contact turn over that of the
/// curve: 0 on a plane, about 1 in a hole that fits. With a mesh it holds the mean over the sides,
/// \f$ c_v = \tfrac12 r^2 \kappa\,v_n - r\,\varepsilon_t - \varepsilon_n \f$, and the gap itself is wider by \f$ \delta \f$, which
/// \f$ \mu \f$ counts. What is left is of the third order in the length of a side.
/// \param body    of a model
/// \param stress  recovered() of u, then of z of each goal
/// \param contact of the body
/// \param whole   the same fields
/// \param goals   whose duals they are; where one is a mean displacement of a boundary of this body, it changes too
/// \return the sides that the outline leaves
[[nodiscard]] std::vector<OutlineShare> outline_shares(const BodyModel& body,
                                                       const SmoothStress& stress,
                                                       const ContactOnNodes& contact,
                                                       const std::vector<WholeField>& whole,
                                                       const std::vector<Goal>& goals);

}  // namespace signorini
