// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Finer meshes from coarse ones, everywhere or in parts.
#pragma once
#include <vector>

#include "addons/estimate/edges.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Halves edges of a mesh and cuts the cells there: quadrilaterals into two or four, across; triangles by the
/// bisection of their longest side, and of the halves if their other sides are halved too [\ref Rivara1984], which never
/// leaves an angle below half the smallest of the first mesh.
///
/// Old nodes stay where they are, with their numbers. New ones on the outline lie on the line that the outline
/// follows there, see OutlineShape; those along a refinement line between quadrilaterals follow its two ends, the more the
/// nearer they are, so that concentric circles stay circles; all others lie where the shape functions of the
/// cell have them. Cells of a curved side so coarse that its arc leaves them are found by check_mesh().
/// \param mesh    any
/// \param edges   of it
/// \param halved  of each edge, not 0 if it is to be halved, once; closed_under_halving() adds what must be
/// \return the same body with the same boundaries and regions; the pieces of a cell take its place, and those of
///   a side
/// \throws std::invalid_argument unless there is a mark for each edge
[[nodiscard]] Mesh refined_mesh(const Mesh& mesh, const MeshEdges& edges, std::vector<char> halved);

/// A mesh whose marked edges were halved, once each.
struct HalvedMesh {
  Mesh mesh;          ///< as of refined_mesh()
  MarkedEdges marks;  ///< its edges, and which halves are to be halved again
};

/// Halves marked edges once, and says what is left to be halved.
/// \param mesh   any
/// \param marks  of its edges
/// \return mesh and marks
/// \throws std::invalid_argument as refined_mesh()
[[nodiscard]] HalvedMesh halved_once(const Mesh& mesh, const MarkedEdges& marks);

/// Halves all edges: every cell becomes four.
/// \param mesh  any
/// \return as above
[[nodiscard]] Mesh refined_mesh(const Mesh& mesh);

}  // namespace signorini
