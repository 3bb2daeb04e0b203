// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Boundaries of the bodies of an input file.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "addons/files/gmsh_records.hpp"
#include "addons/files/inp_members.hpp"

namespace signorini {

/// An input file on the way to meshes.
struct InpFile {
  /// \param records  of the file
  explicit InpFile(InpRecords records)
      : in(std::move(records)), elements(in.element_sets, numbers), nodes(in.node_sets, tags) {}
  InpFile(const InpFile&) = delete;
  InpFile& operator=(const InpFile&) = delete;
  InpFile(InpFile&&) = delete;
  InpFile& operator=(InpFile&&) = delete;
  ~InpFile() = default;

  /// \param place  among cells, and behind them lines \return that element
  [[nodiscard]] const GmshElement& element(std::size_t place) const {
    return place < in.cells.size() ? in.cells[place] : in.lines[place - in.cells.size()];
  }

  static constexpr std::size_t none = SIZE_MAX;  ///< no body

  InpRecords in;        ///< as it was read, with places of nodes in the place of their numbers
  InpNumbers tags;      ///< of nodes
  InpNumbers numbers;   ///< of elements, see element()
  InpMembers elements;  ///< of element sets
  InpMembers nodes;     ///< of node sets
  std::vector<std::size_t> body_of;  ///< of each cell the number of its body, or `none`
  GmshRecords out;                   ///< its cells, then its boundaries, as of a file of Gmsh
};

/// Adds the lines of boundaries: of surfaces, of sets of lines, and of node sets; see parse_inp().
/// \param file  with its cells in `out`; gets lines, and in `unread` surfaces that have sides within a body
/// \throws ProblemError if a surface has a side that an element has not
void add_boundaries(InpFile& file);

}  // namespace signorini
