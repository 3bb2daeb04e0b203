// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// From the lines of a Gmsh file to the boundaries of its bodies.
#pragma once
#include <cstddef>
#include <vector>

#include "addons/files/gmsh_records.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// A mesh, and where it came from.
struct GmshBody {
  Mesh mesh;                        ///< its cells run counter-clockwise
  std::vector<std::size_t> source;  ///< `n_cells` numbers in GmshRecords::cells
  CellArray file_nodes;             ///< as Mesh::cells, but numbers in GmshRecords::nodes
};

/// Makes a boundary of each physical curve, in every body that has sides on it; see parse_gmsh().
/// \param file    with the lines
/// \param bodies  all bodies of the file; get their boundaries
/// \throws ProblemError if a line of a physical curve is no side of a body or lies within one, if
///   cells overlap along a side, or if two curves of one body have the same name
void add_boundaries(const GmshRecords& file, std::vector<GmshBody>& bodies);

/// Puts sides into walking order.
/// \param mesh   that has them
/// \param sides  in any order, none twice
/// \return the same sides, piece after piece: the open pieces, each from its end, then the closed
///   ones; of several the one whose first side is earlier in `sides`
[[nodiscard]] std::vector<CellSide> chained(const Mesh& mesh, const std::vector<CellSide>& sides);

}  // namespace signorini
