/// \file
/// Stresses from displacements, and what a stress does to a face.
///
/// The sign is that of mechanics: tension is positive. Contact pressures have the other sign, and
/// they are computed elsewhere, from contact forces.
#pragma once
#include <Eigen/Core>

#include "signorini/fem/element.hpp"
#include "signorini/fem/material_field.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// One stress (xx, yy, xy, zz) per row [force/length^2], tension positive; zz is across the plane: in axial symmetry
/// the hoop stress, see stress_across() for the others.
using StressArray = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// Stress at the nodes: the values at the strain points of each cell are fitted by a bilinear
/// function (of a triangle, linear), evaluated at the nodes and averaged over the cells that meet there, also between materials.
/// \param mesh           the body
/// \param element        fits its cells
/// \param material       of its cells; its eigenstrain needs no stress
/// \param displacements  `n_nodes x 2` [length]
/// \return `n_nodes x 4`; zero at a node without a cell
/// \throws std::invalid_argument unless there is one displacement per node
/// \throws ProblemError as check_material()
[[nodiscard]] StressArray nodal_stress(const Mesh& mesh, const Element& element,
                                       const MaterialField& material,
                                       const NodeArray& displacements);

/// Mean stress of every cell.
/// \param mesh           the body
/// \param element        fits its cells
/// \param material       of its cells; its eigenstrain needs no stress
/// \param displacements  `n_nodes x 2` [length]
/// \return `n_cells x 4`
/// \throws std::invalid_argument or ProblemError, as nodal_stress()
[[nodiscard]] StressArray cell_stress(const Mesh& mesh, const Element& element,
                                      const MaterialField& material,
                                      const NodeArray& displacements);

/// Energy that strains store, as if there were no eigenstrain: half the integral of \f$ \varepsilon^T D\,\varepsilon \f$.
///
/// As a sum of squares of strains it is exact to rounding of the strains, where \f$ \tfrac12 u^T K u \f$ loses as much
/// as large displacements cancel in K u.
/// \param mesh           the body
/// \param element        fits its cells
/// \param material       of its cells; its eigenstrain is not looked at
/// \param displacements  `n_nodes x 2` [length]
/// \return not negative [force*length]
/// \throws std::invalid_argument or ProblemError, as nodal_stress()
[[nodiscard]] double strain_energy(const Mesh& mesh, const Element& element,
                                   const MaterialField& material, const NodeArray& displacements);

/// The force per area on a face of a body.
struct Traction {
  double normal;  ///< sigma_n [force/length^2], tension > 0: minus the contact pressure
  Eigen::Vector2d tangential;  ///< along the face, on the body [force/length^2]
};

/// Splits the traction \f$ \sigma n \f$ of a plane stress tensor.
///
/// \f[ \sigma_n = n^T\sigma n, \f] \PaperEq{LinEtAl, 5}
/// \f[ \tau = \sigma n - \sigma_n n, \f] \PaperEq{LinEtAl, 7}
/// \param stress  (sigma_x, sigma_y, tau_xy) of the body [force/length^2], tension > 0
/// \param normal  out of the body, length 1
/// \return both parts
[[nodiscard]] inline Traction traction(const Eigen::Vector3d& stress,
                                       const Eigen::Vector2d& normal) {
  const Eigen::Vector2d whole(stress(0) * normal.x() + stress(2) * normal.y(),
                              stress(2) * normal.x() + stress(1) * normal.y());
  const double along = whole.dot(normal);
  return {along, whole - along * normal};
}

}  // namespace signorini
