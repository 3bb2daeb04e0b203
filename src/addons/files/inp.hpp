/// \file
/// Meshes from input files of CalculiX and Abaqus.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// What an input file holds.
struct InpMeshes {
  std::vector<Mesh> meshes;  ///< at least one
  /// What of the file was not read; empty: nothing. With the first lines, as `*CLOAD (line 12)`.
  std::vector<std::string> unread;
  /// Further element sets that could be bodies, or parts of them, with the numbers of their cells, as `ALL (24 cells)`.
  std::vector<std::string> further_sets;
  /// On names that several things have, and thicknesses that are not taken, each with its lines.
  std::vector<std::string> notes = {};
};

/// Makes meshes of an input file of CalculiX or Abaqus: nodes, plane elements, sets and surfaces.
///
/// Elements of the families CPS, CPE, CAX, M3D and S with 3, 4, 6 or 8 nodes become cells. Without `sets` each element set with a section
/// becomes a mesh of its name; if there is none, each set that elements are put into by the line that begins them; if there is none, all cells
/// are one mesh `body`. With `sets` these are one body: of several each becomes a region.
///
/// Boundaries are made of the sides on the border of a body: a surface has those that it names, a set of elements of two or three nodes
/// those that these lie on, a surface of nodes or a node set those whose nodes it all has. Of equal names the first in this order is taken,
/// and a note names the other. Small and capital letters are the same in names of sets; meshes and boundaries have them as the file writes
/// them first. Two sets of one name, one in the part and one in the assembly, are two: of node sets and surfaces that of the assembly has
/// the name, of element sets that of the part; the other one is called `Part-1.NAME` or `Assembly.NAME`, and a note says so.
/// \param content  the text of the file
/// \param name     of the file, for messages
/// \param sets     element sets that are the body; usually none
/// \return the meshes; the shapes of the cells are not checked, see check_mesh()
/// \throws ProblemError `NAME:LINE: ...` as inp_records(); if two nodes or elements have one number, an element has a node that is not
///   there, there is no plane element or no such set, a cell is in two bodies, or a surface has a side that its element has not; or for cells
///   as parse_gmsh()
[[nodiscard]] InpMeshes parse_inp(std::string_view content, const std::string& name,
                                  const std::vector<std::string>& sets = {});

/// Makes meshes of an input file.
/// \param file  of at most `largest_gmsh_file` bytes
/// \param sets  as parse_inp()
/// \return as parse_inp()
/// \throws ProblemError as parse_inp(), or if there is no such file or it cannot be read
[[nodiscard]] InpMeshes read_inp(const std::filesystem::path& file,
                                 const std::vector<std::string>& sets = {});

/// Whether a text looks like an input file of CalculiX or Abaqus. \param content  its beginning at least \return whether
[[nodiscard]] bool is_inp(std::string_view content);

}  // namespace signorini
