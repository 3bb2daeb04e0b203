/// \file
/// The two meshes of a cylinder pressed onto a plate (Hertz), for quarter models.
#pragma once
#include <Eigen/Core>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// The lower right quarter of a disc of radius R that rests at the origin on the right half of a
/// plate. Vary the counts to have other meshes: equal cores face each other node by node, others do
/// not match. The defaults fit the example of sec. 3.1 of [\ref LinEtAl]: 1399 nodes, 16 cells on
/// 1.3 half widths of the contact.
struct HertzMeshSpec {
  double radius = 50;                   ///< of the disc R [mm]
  Eigen::Vector2d plate = {95, 95};     ///< half width and depth of the plate [mm]
  double core = 1.4;                    ///< width and depth of both cores; above the half width of
                                        ///< the contact, 1.08 [mm]
  double plate_core = 1;                ///< that of the plate / that of the disc [-]
  Eigen::Index disc_cells = 16;         ///< of the core of the disc, along the rim
  Eigen::Index disc_rows = 12;          ///< of the core of the disc, in depth
  Eigen::Index disc_layers = 16;        ///< around it
  Eigen::Index plate_cells = 16;        ///< of the core of the plate, along the surface
  Eigen::Index plate_rows = 12;         ///< of the core of the plate, in depth
  Eigen::Index plate_layers = 17;       ///< around it
  double layer_grading = 3;             ///< of both, see HalfSpaceSpec [-]
  MeshOrder order = MeshOrder::Linear;  ///< of both
};

/// Two bodies that touch in the origin.
struct HertzMeshes {
  Mesh disc;   ///< boundaries `rim` (contact), `axis` (x = 0), `middle` (y = R)
  Mesh plate;  ///< boundaries `surface` (contact), `axis` (x = 0), `side`, `base`
};

/// \param spec  how both are divided
/// \return both meshes; each passes check_mesh()
/// \throws std::invalid_argument naming the number that is out of range
[[nodiscard]] HertzMeshes make_hertz_meshes(const HertzMeshSpec& spec);

}  // namespace signorini
