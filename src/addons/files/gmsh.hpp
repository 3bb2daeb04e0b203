/// \file
/// Meshes from files of the mesh generator Gmsh.
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Physical surfaces that are parts of one body, by the name of the body.
using GmshParts = std::map<std::string, std::vector<std::string>>;

/// Makes meshes of a Gmsh file [\ref GeuzaineRemacle2009], version 2.2 or 4.1, written as text.
///
/// Each physical surface becomes a mesh of its name, in the order of the physical tags; those that `parts`
/// puts into one body become one mesh, in the place of the first, with a region of the name of each, and
/// share their nodes. Without physical surfaces the whole file becomes one mesh `body`. Meshes share no nodes:
/// where two bodies meet, each gets its own. Nodes and cells keep the order of the file; nodes of no cell are left
/// out, and a cell whose corners run clockwise is turned.
///
/// Each physical curve becomes a boundary of its name, in every mesh that has sides on it: a curve
/// that two bodies share becomes a boundary of both, one between parts of a body is none. Its sides stand in walking order, the body to
/// the left whatever the direction of the curve, piece after piece: first the open pieces, each from
/// its end, then the closed ones, each from its side that is first in the file; where several sides
/// go on from one node, the first of them in the file is taken.
///
/// Groups without a name are called `surface TAG` and `curve TAG`; groups without elements are passed over. Points, and lines in no group,
/// are ignored.
/// \param content  the text of the file
/// \param name     of the file, for messages
/// \param parts    bodies of several physical surfaces; usually none
/// \return at least one mesh; the shapes of the cells are not checked, see check_mesh()
/// \throws ProblemError `NAME:LINE: ...` if the text is no such file, and then what else it seems to be; has
///   cells other than triangles and quadrilaterals of 2 or 3 nodes per side, or both in one body; no physical
///   surface that `parts` names, or is to be in two bodies; a cell in no physical surface though there
///   are some, or in two; cells that overlap along a side; a line of a physical curve
///   that is no side of a cell or lies within a body; two groups of one name, or names of groups none of which has
///   an element; or if z varies by more than 1e-9 of the extent
[[nodiscard]] std::vector<Mesh> parse_gmsh(std::string_view content, const std::string& name,
                                           const GmshParts& parts = {});

/// Makes meshes of a Gmsh file.
/// \param file   of at most `largest_gmsh_file` bytes
/// \param parts  as parse_gmsh()
/// \return as parse_gmsh()
/// \throws ProblemError as parse_gmsh(), or if there is no such file or it cannot be read
[[nodiscard]] std::vector<Mesh> read_gmsh(const std::filesystem::path& file,
                                          const GmshParts& parts = {});

/// Looks up a mesh.
/// \param meshes  with different names
/// \param name    of one of them
/// \return that mesh
/// \throws ProblemError if there is none of this name; the message lists those that exist
[[nodiscard]] const Mesh& mesh_named(const std::vector<Mesh>& meshes, const std::string& name);

/// Most bytes of a Gmsh file that is read: some millions of cells.
constexpr std::size_t largest_gmsh_file = std::size_t{1} << 29;

}  // namespace signorini
