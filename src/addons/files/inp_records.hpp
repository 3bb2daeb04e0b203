// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What an input file of CalculiX or Abaqus says of its mesh, in its own numbers; read_inp() makes meshes of it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "addons/files/gmsh_records.hpp"

namespace signorini {

/// Some members of a set: numbers from `first` to `last`, or those of another set.
struct InpEntry {
  std::int64_t first = 0;  ///< number of the file
  std::int64_t last = 0;   ///< and that up to which the entry goes
  std::int64_t step = 1;  ///< from one to the next
  std::string set = {};   ///< key of another set that is defined before; empty: numbers
  int side = 0;           ///< number behind S or E; 0: all sides of elements that lie on the border
  bool edge = false;      ///< E: the faces of shells are not counted
};

/// A set of nodes or of elements, or a surface.
struct InpSet {
  std::string name;               ///< as the file writes it first
  std::vector<InpEntry> entries;  ///< in the order of the file
  std::size_t line = 0;           ///< where it begins, from 1
  bool of_part = false;           ///< whether it stands in a part or an instance, and not behind it
};

/// What a section says of the thickness of elements.
struct InpThickness {
  std::string set;       ///< key of their element set
  std::string value;     ///< as the file writes it
  std::size_t line = 0;  ///< where it stands, from 1
};

/// Sets by their names in capital letters: input files do not tell small letters from large ones. Of two sets of one name, one of
/// a part and one of the assembly, one has its place in front of the name, as in `PART-1.SET-1`.
using InpSets = std::map<std::string, InpSet>;

/// The mesh of an input file.
struct InpRecords {
  std::string name;                        ///< of the file, for messages
  std::vector<GmshNode> nodes;             ///< in the order of the file
  std::vector<GmshElement> cells;          ///< plane elements; `nodes` are the numbers of the file
  std::vector<std::int64_t> cell_numbers;  ///< of the file
  std::vector<int> first_sides;            ///< of cells, see InpElementType
  std::vector<GmshElement> lines;          ///< elements of two or three nodes, alike
  std::vector<std::int64_t> line_numbers;  ///< of the file
  InpSets element_sets;               ///< and the sets that elements are put into where they stand
  InpSets node_sets;                  ///< alike
  InpSets surfaces;                   ///< of sides of elements
  InpSets node_surfaces;              ///< of nodes; their entries name sets of `node_sets`
  std::vector<std::string> sections;  ///< keys of the element sets that have a section
  std::vector<std::string>
      of_elements;  ///< keys of the sets that elements are put into where they stand
  std::map<std::string, std::size_t>
      unread;  ///< keywords and elements that are not read, and their first lines
  std::vector<InpThickness> thicknesses;  ///< other than 1
  std::vector<std::string> notes;         ///< on names that several things have
};

/// Reads nodes, elements, sets, surfaces, and which sets have sections.
/// \param content  the text of the file
/// \param name     of the file, for messages
/// \return what it holds; numbers are not looked up
/// \throws ProblemError `NAME:LINE: ...` if a line that is read is not as it should be, a set is used before it is defined, or
///   for what would change the mesh and is not read: files that are included, systems of coordinates, generated and copied nodes and
///   elements, several parts or instances; or if the text is UTF-16
[[nodiscard]] InpRecords inp_records(std::string_view content, const std::string& name);

}  // namespace signorini
