/// \file
/// Rigid motions that supports leave to a body.
///
/// Contact problems are often of this kind: a disc on a plate that only the plate holds. For most
/// programs that is an error, and the usual remedy is a weak spring whose force stays in the
/// result. Here it is a case with equations of its own. What is wanted is a basis of the motions,
/// with few and readable members: translations along the axes where they are free, and one
/// rotation.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "signorini/fem/joints.hpp"
#include "signorini/fem/unknowns.hpp"

namespace signorini {

/// A rigid motion that supports leave to a body: its displacement is zero strain and no held component.
struct FreeMotion {
  std::string body;  ///< "body 'x' (8 cells around (2, 0.5))"
  /// (a, b, c): moves the point x by (a - c (y - y0), b + c (x - x0)) [-, -, 1/length]
  Eigen::Vector3d motion = Eigen::Vector3d::Zero();
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< (x0, y0) of the body [length]
  double size = 1;                                   ///< diagonal of the box around it [length]
  /// `n` displacement of each unknown, at most about 1 [-]: entries of the body alone
  Eigen::SparseVector<double> shape;
  double directions =
      0;  ///< one rounding of the directions that it goes in, see direction_rounding()
};

/// \param motion  of one body
/// \return "body 'x' (8 cells around (2, 0.5)) can move freely in direction x"
[[nodiscard]] std::string in_words(const FreeMotion& motion);

/// Several motions at once, those of one body as one.
/// \param motions    `n_r` of some bodies, those of each behind each other
/// \param amplitude  `n_r` of each, or none of none; a body that moves less than a millionth of the farthest rests
/// \return a sentence as above for each body that moves
[[nodiscard]] std::vector<std::string> in_words(const std::vector<FreeMotion>& motions,
                                                const Eigen::VectorXd& amplitude);

/// Finds the rigid motions that the supports leave to each piece of a mesh: those that move no held component by more
/// than what rounding of the coordinates makes of it, which grows with the distance from the origin.
/// \param mesh      any
/// \param pieces    of the mesh
/// \param unknowns  `n` of it
/// \param state     in axial symmetry, bodies can only move along the axis
/// \return independent motions, up to three per piece, in axial symmetry up to one; empty if there is none
[[nodiscard]] std::vector<FreeMotion> free_motions(const Mesh& mesh,
                                                   const std::vector<MeshPiece>& pieces,
                                                   const Unknowns& unknowns,
                                                   PlaneState state = PlaneState::Strain);

/// The same for those who do not have the pieces. \param mesh  any \param unknowns  `n` of it
/// \param state  as above \return as above
[[nodiscard]] std::vector<FreeMotion> free_motions(const Mesh& mesh, const Unknowns& unknowns,
                                                   PlaneState state = PlaneState::Strain);

}  // namespace signorini
