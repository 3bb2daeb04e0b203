/// \file
/// New meshes from old ones: bent, moved, mirrored, renamed, joined.
///
/// The functions compose: `joined(block, "right", mirrored(block, line), "right")` is a symmetric
/// plate. Each of them keeps what check_mesh() asks for, so that a mesh is checked once, at the
/// end.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Bends a mesh into another shape.
/// \param mesh  to start from
/// \param map   new position of a node from its position [length]; must not mirror
/// \return the same cells and boundaries with every node moved; not checked, see check_mesh()
[[nodiscard]] Mesh mapped(Mesh mesh,
                          const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map);

/// \param mesh   to start from
/// \param shift  added to every position [length]
/// \return the mesh in another place
[[nodiscard]] Mesh moved(Mesh mesh, const Eigen::Vector2d& shift);

/// Lines that a mesh is mirrored at.
enum class MirrorLine {
  Upright,  ///< x = place: left and right change places
  Level     ///< y = place: above and below change places
};

/// The mirror image. Cells still run counter-clockwise and boundaries keep the body on the left:
/// both are listed backwards. Names stay with the sides: the image of `right` is still `right`.
/// \param mesh   to start from
/// \param line   that the mesh is mirrored at
/// \param place  of the line [length]; nodes on the line stay exactly where they are
/// \return a mesh that passes check_mesh() if the first one does
[[nodiscard]] Mesh mirrored(Mesh mesh, MirrorLine line, double place = 0);

/// Gives a boundary another name. If there is one of the new name already, they become one.
/// \param mesh  that has the boundary `from`
/// \param from  old name
/// \param to    new name
/// \return the mesh with the boundary `to`
/// \throws ProblemError if there is no boundary `from`, or if it does not end where the boundary
///   `to` begins or begin where that ends
[[nodiscard]] Mesh renamed(Mesh mesh, const std::string& from, const std::string& to);

/// Glues two meshes together along a line whose nodes they share. The two boundaries along the line
/// are gone after that; others of the same name become one, in walking order where they meet. So do regions.
/// \param first     mesh; its nodes and cells keep their numbers, name and positions are its own
/// \param along     its boundary on the line
/// \param second    mesh of as many nodes per side
/// \param opposite  its boundary on the line
/// \return one mesh: nodes and cells of the first, then the others of the second
/// \throws ProblemError if there is no such boundary, if sides have not as many nodes in both, or
///   if the nodes of the two boundaries differ in number or, by more than rounding (1e-12 of the
///   size), in place
[[nodiscard]] Mesh joined(Mesh first, const std::string& along, const Mesh& second,
                          const std::string& opposite);

}  // namespace signorini
