/// \file
/// What warm bodies do: strains that nothing hinders, and the nodal forces that stand for them.
#pragma once
#include <Eigen/Core>

#include "signorini/core/alignment.hpp"
#include "signorini/fem/cells.hpp"

namespace signorini {

/// Strain of a material that is warmer and free to expand in the plane, but across it does what its state says:
/// \f$ \alpha\,\Delta T \f$ in both directions, times \f$ 1 + \nu \f$ in plane strain; the hoop strain in axial symmetry.
/// \param material     with its expansion
/// \param temperature  how much warmer [temperature]
/// \return (xx, yy, 2 xy, hoop) [-]
[[nodiscard]] Eigen::Vector4d thermal_strain(const Material& material, double temperature);

/// \param cell   any \param point  one of its strain points \return where that is [length]
[[nodiscard]] Eigen::Vector2d position(const Cell& cell, const StrainPoint& point);

/// The strains at the strain points of a cell that stresses are read without.
///
/// What internal modes of the element give way to is taken from them: a temperature that varies in a cell bends
/// its modes, too.
/// \param cell         any
/// \param points       its strain points
/// \param temperature  of the body
/// \return one column per strain point, as many rows as its D
[[nodiscard]] PointStrains thermal_strains(const Cell& cell, const StrainPoints& points,
                                           const Temperature& temperature);

/// Nodal forces that would expand a body as its temperature does: the integral of \f$ B^T D\,\epsilon_T \f$.
/// \param mesh     the body
/// \param element  fits its cells
/// \param matter   of its cells
/// \return `n_nodes x 2` [force]; zero without a temperature
[[nodiscard]] NodeArray thermal_forces(const Mesh& mesh, const Element& element,
                                       const Matter& matter);

}  // namespace signorini
