/// \file
/// Width and height of an ellipse of pressure from what a mesh of nodes says about it.
///
/// The last closed node tells the half-width only to the distance of two nodes. Two measures use
/// all nodes: a fit of the middle part, and the second moment of the forces.
#pragma once
#include <vector>

namespace signorini {

/// Part of the half-width that a fit counts, unless it is told another [-].
constexpr double fitted_part = 0.9;

/// An ellipse of pressure.
struct HertzFit {
  double peak_pressure;  ///< q_0 [force/length^2]
  double half_width;     ///< b [length]
};

/// What a line of nodes across a contact stands for.
enum class Footprint {
  Strip,  ///< the same all along: a line contact, whose nodes share its width
  Circle  ///< the same all around the first place, x = 0, as in axial symmetry: nodes have rings
};

/// Fits \f$ p^2 = q_0^2 (1 - x^2 / b^2) \f$ by least squares to the nodes with |x| < `inner` b.
///
/// p^2 is linear in x^2, so each fit is a straight line; which nodes count depends on b, and fits
/// are repeated until their number no longer changes. Exact pressures give the exact ellipse on any
/// nodes. Pressures that are nodal forces over their share of a boundary with equal steps h are
/// means around the node: they are too small by h^2/12 times the curvature, in the middle by
/// \f$ q_0 h^2 / (12 b^2) \f$. That error belongs to the mesh, not to the fit.
/// \param x         of the nodes, from the middle of the contact [length]; any order, half or whole
/// \param pressure  at the nodes [force/length^2], compression > 0
/// \param inner     part of the half-width that counts [-], in (0, 1]
/// \param footprint of the contact: over a circle each node counts as its ring does, and that on the axis not at all,
///   whose pressure meshes do not resolve, however fine they are
/// \return the ellipse
/// \throws std::invalid_argument if the lists differ in length, fewer than two different distances
///   have pressure or lie inside, or the pressure does not fall with the distance
[[nodiscard]] HertzFit fit_hertz(const std::vector<double>& x, const std::vector<double>& pressure,
                                 double inner = fitted_part,
                                 Footprint footprint = Footprint::Strip);

/// How the peak of fit_hertz() changes with each pressure while the nodes that count stay the same.
/// \param x         of the nodes [length]
/// \param pressure  at the nodes [force/length^2]
/// \param inner     part of the half-width that counts [-]
/// \param footprint of the contact
/// \return one number per node [-]; 0 at nodes that do not count
/// \throws std::invalid_argument as fit_hertz()
[[nodiscard]] std::vector<double> peak_pressure_gradient(const std::vector<double>& x,
                                                         const std::vector<double>& pressure,
                                                         double inner = fitted_part,
                                                         Footprint footprint = Footprint::Strip);

/// How displacements vary between the nodes of a boundary.
enum class Trace {
  Linear,    ///< edges of two nodes
  Quadratic  ///< edges of three nodes, the middle one in the middle
};

/// Half-width from the second moment: \f$ b = 2 \sqrt{\int p\,x^2 / \int p} \f$ for an ellipse over a strip, and
/// \f$ b = \sqrt{5/2}\,\sqrt{\int p\,x^2 / \int p} \f$ for an ellipsoid over a circle of the radius b.
///
/// Nodal forces f of a finite element pressure p do the work of p on every displacement of the
/// mesh, \f$ \sum f\,g(x) = \int p\,I g \f$, where I g interpolates g at the nodes. So the sum of
/// f is the integral of p, and on quadratic edges the sum of f x^2 is its second moment. On linear
/// edges I x^2 is too large by (x - x_i)(x_{i+1} - x), which makes b of the bare sum too large by the
/// share \f$ h^2 / (3 b^2) \f$, 0.2 % with 12 edges on b. So what p does on the edge between is taken
/// off, \f$ (x_{i+1} - x_i)^3 (p_i + p_{i+1}) / 12 \f$ with p = f / (half of the two edges); of rings, times their radius.
///
/// A half-model needs no special care: its node on the axis carries half of the force there, as it
/// should. Integrating p by the trapezoidal rule instead misses the root at the edge of the contact.
/// \param x      of the nodes in rising order, from the middle of the contact [length]; from 0 on
///   for a half-model, and for a circle
/// \param force  of the nodes [force], compression > 0
/// \param trace  how displacements vary between the nodes
/// \param footprint  of the contact
/// \return b [length]
/// \throws std::invalid_argument if the lists differ in length, x does not rise, or no force presses
[[nodiscard]] double half_width_of_forces(const std::vector<double>& x,
                                          const std::vector<double>& force,
                                          Trace trace = Trace::Linear,
                                          Footprint footprint = Footprint::Strip);

/// How half_width_of_forces() changes with each force.
/// \param x      of the nodes in rising order [length]
/// \param force  of the nodes [force]
/// \param trace  how displacements vary between the nodes
/// \param footprint  of the contact
/// \return one number per node [length/force]
/// \throws std::invalid_argument as half_width_of_forces()
[[nodiscard]] std::vector<double> half_width_gradient(const std::vector<double>& x,
                                                      const std::vector<double>& force,
                                                      Trace trace = Trace::Linear,
                                                      Footprint footprint = Footprint::Strip);

}  // namespace signorini
