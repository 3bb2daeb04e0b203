// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What a mesh file of Gmsh says, in its own numbers; read_gmsh() makes meshes of it.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "addons/files/gmsh.hpp"
#include "addons/files/gmsh_groups.hpp"

namespace signorini {

/// One node of a Gmsh file.
struct GmshNode {
  std::int64_t tag = 0;                          ///< what the file calls it
  std::array<double, 3> position = {{0, 0, 0}};  ///< x, y, z [length]
  std::size_t line = 0;                          ///< where it stands, from 1
};

/// One line, triangle or quadrilateral of a Gmsh file.
struct GmshElement {
  std::array<std::size_t, 8> nodes = {};  ///< numbers in GmshRecords::nodes: corners, midpoints
  std::size_t corners = 0;                ///< 2 of a line, 3 or 4 of a cell
  std::size_t n_nodes = 0;  ///< corners, or with midpoints 3 of a line, 6 or 8 of a cell
  std::size_t groups = 0;   ///< number of its set in GmshRecords::groups
  std::size_t line = 0;     ///< where it stands, from 1
};

/// Nodes, elements and physical groups of a Gmsh file.
struct GmshRecords {
  std::string name;                          ///< of the file, for messages
  std::string surface = "physical surface";  ///< what the file calls a group of cells, for messages
  std::vector<GmshNode> nodes;               ///< all of them, no tag twice
  std::vector<GmshElement> lines;            ///< one-dimensional elements
  std::vector<GmshElement> cells;            ///< triangles and quadrilaterals
  GmshGroups groups;                         ///< physical groups
};

/// Reads the sections of a Gmsh file [\ref GeuzaineRemacle2009], of version 2.2 or 4.1 and written
/// as text. Points and sections that hold no mesh are skipped, as is text between sections.
/// \param content  the text of the file
/// \param name     of the file, for messages
/// \return what it holds; every element refers to nodes that are there
/// \throws ProblemError `NAME:LINE: expected ..., got ...` if the text is no such file, is cut off,
///   or holds elements other than points, lines, triangles and quadrilaterals of 2 or 3 nodes per side
[[nodiscard]] GmshRecords gmsh_records(std::string_view content, const std::string& name);

/// Makes meshes of what a file holds.
/// \param file   with one cell or more
/// \param parts  as parse_gmsh()
/// \return as parse_gmsh()
/// \throws ProblemError as parse_gmsh()
[[nodiscard]] std::vector<Mesh> meshes_of(const GmshRecords& file, const GmshParts& parts);

}  // namespace signorini
