/// \file
/// Discs: evenly divided, or fine at the poles where they are pressed.
#pragma once
#include <Eigen/Core>
#include <string>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// How much of a disc is meshed.
enum class DiscPart {
  LowerRight,  ///< right of the centre and below it
  Right,       ///< right of the centre, mirrored at the level of the centre
  Full         ///< all of it, mirrored at the upright through the centre as well
};

/// What is meshed of a disc, from a quarter of it.
/// \param quarter  the lower right one, with its centre at x = 0, y = `level`, and the boundaries `middle` and `axis`
/// \param level    of the centre [length]
/// \param part     how much is wanted
/// \return that part, of mirrored quarters
[[nodiscard]] Mesh part_of_disc(const Mesh& quarter, double level, DiscPart part);

/// A disc and how it is divided: a core of even cells with layers of cells around it.
struct DiscSpec {
  std::string name = "disc";                         ///< what messages call it
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< [length]
  double radius = 1;                                 ///< [length], positive
  double core = 0.5;  ///< half width of the core / radius, above 0, below (1 + roundness) / 2 [-]
  double core_roundness = 0.5;          ///< shape of the core, 0 (square) to 1 (disc), below 1 [-]
  Eigen::Index core_cells = 4;          ///< from the centre to a side of the core, at least 1
  Eigen::Index layers = 4;              ///< of cells around the core, at least 1
  double layer_grading = 1;             ///< outermost layer / innermost, positive; geometric [-]
  DiscPart part = DiscPart::Full;       ///< how much of it
  MeshOrder order = MeshOrder::Linear;  ///< 4 or 8 nodes per cell; 8: midpoints lie on the circle
};

/// Divides a disc evenly. Cores of a quarter have `core_cells` squared cells, layers twice
/// `core_cells`.
///
/// Boundaries, with the body on the left: `rim`; of a part also `axis` (x of the centre), of a
/// quarter also `middle` (y of the centre). A full rim begins at the lowest node.
/// \param spec  the disc
/// \return a mesh that passes check_mesh(); halves that were mirrored are equal to the last bit if
///   the centre is the origin
/// \throws std::invalid_argument naming the number that is out of range
[[nodiscard]] Mesh make_disc(const DiscSpec& spec);

/// A disc that is fine at its lowest point, and at its highest if both are meshed.
struct PressedDiscSpec {
  std::string name = "disc";                       ///< what messages call it
  Eigen::Vector2d pole = Eigen::Vector2d::Zero();  ///< lowest point [length]
  double radius = 50;                              ///< [length], positive
  /// Width along x from the pole to the last node of the core on the rim, and depth of the core along the axis, both
  /// below radius / 2 [length].
  Eigen::Vector2d core = Eigen::Vector2d::Ones();
  Eigen::Index core_columns = 8;  ///< cells of the core along the rim
  Eigen::Index core_rows = 8;     ///< cells of the core in depth
  Eigen::Index layers = 10;       ///< of cells around the core, at least 1
  double layer_grading = 1;       ///< growth of the last layer / of the first, in logarithms [-]
  DiscPart part = DiscPart::LowerRight;  ///< how much of it
  MeshOrder order = MeshOrder::Linear;   ///< 4 or 8 nodes per cell; 8: midpoints lie on the circle
};

/// Divides a disc that is fine at its poles: the image of a half-space that is fine at a point, see
/// make_half_space(), under the Moebius map w -> w / (1 - i w / 2 R). That map keeps angles, and
/// takes the half disc |w| < 2 R, Im w > 0 to the lower half of the disc.
///
/// Nodes of the core on the rim have even x: they face those of an even core on a plane. Boundaries
/// as of make_disc(); `axis` runs down to the pole.
/// \param spec  the disc
/// \return a mesh that passes check_mesh(); left and right are equal to the last bit if the pole is
///   at x = 0
/// \throws std::invalid_argument naming the number that is out of range
[[nodiscard]] Mesh make_pressed_disc(const PressedDiscSpec& spec);

}  // namespace signorini
