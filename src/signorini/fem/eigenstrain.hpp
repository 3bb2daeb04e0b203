// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Strains that need no stress at the strain points of cells, and the nodal forces that stand for them.
///
/// A temperature is the usual one: \f$\epsilon_0 = \alpha\,\Delta T\f$ in every direction. A body
/// that is free grows into its neighbour, and one between two walls presses against both.
#pragma once
#include <Eigen/Core>

#include "signorini/core/alignment.hpp"
#include "signorini/fem/cells.hpp"

namespace signorini {

/// The eigenstrain that the components of D see. Plane strain holds what is across the plane, so that it adds nu times that
/// to both directions; plane stress gives way.
/// \param material  of a cell
/// \param free      its eigenstrain (xx, yy, 2 xy, across) [-]
/// \return (xx, yy, 2 xy, hoop) [-]; the last one counts in axial symmetry only
[[nodiscard]] Eigen::Vector4d strain_in_plane(const Material& material,
                                              const Eigen::Vector4d& free);

/// The strains at the strain points of a cell that stresses are read without.
///
/// What internal modes of the element give way to is taken from them: an eigenstrain that varies in a cell bends
/// its modes, too.
/// \param cell    any
/// \param points  its strain points
/// \param free    the eigenstrain, not empty
/// \return one column per strain point, as many rows as its D
[[nodiscard]] PointStrains eigenstrains(const Cell& cell, const StrainPoints& points,
                                        const Eigenstrain& free);

/// Nodal forces that would strain a body by its eigenstrain: the integral of \f$ B^T D\,\epsilon_0 \f$.
/// \param mesh      the body
/// \param element   fits its cells
/// \param material  of its cells
/// \return `n_nodes x 2` [force]; zero without an eigenstrain
[[nodiscard]] NodeArray eigenstrain_forces(const Mesh& mesh, const Element& element,
                                           const MaterialField& material);

}  // namespace signorini
