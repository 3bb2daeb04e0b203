#include "addons/files/inp_boundaries.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

/// A side of a cell between two nodes.
struct Border {
  GmshElement line;
  std::size_t body = 0;
  bool within = false;  // two cells of one body have it
};

class BoundaryMaker {
 public:
  explicit BoundaryMaker(InpFile& file) : file_(file) {}
  void make() {
    find_border();
    add_surfaces();
    add_nodes(file_.in.node_surfaces, "surface");
    add_lines();
    add_nodes(file_.in.node_sets, "node set");
  }

 private:
  static std::pair<std::size_t, std::size_t> ends(std::size_t a, std::size_t b) {
    return {std::min(a, b), std::max(a, b)};
  }

  /// The side of a cell as a line.
  static GmshElement side_of(const GmshElement& cell, std::size_t side) {
    GmshElement line;
    line.corners = 2;
    line.n_nodes = cell.n_nodes == cell.corners ? 2 : 3;
    line.nodes[0] = cell.nodes[side];
    line.nodes[1] = cell.nodes[(side + 1) % cell.corners];
    if (line.n_nodes == 3) line.nodes[2] = cell.nodes[cell.corners + side];
    return line;
  }

  void find_border() {
    for (std::size_t cell = 0; cell < file_.in.cells.size(); ++cell) {
      if (file_.body_of[cell] == InpFile::none) continue;
      for (std::size_t side = 0; side < file_.in.cells[cell].corners; ++side) {
        const GmshElement line = side_of(file_.in.cells[cell], side);
        const auto [found, is_new] = border_.emplace(ends(line.nodes[0], line.nodes[1]),
                                                     Border{line, file_.body_of[cell], false});
        if (!is_new) found->second.within = found->second.body == file_.body_of[cell];
      }
    }
  }

  /// Puts a side into a boundary. \return whether it lies on the border of a body
  bool add_line(std::size_t a, std::size_t b, std::size_t group, std::size_t at) {
    const auto found = border_.find(ends(a, b));
    if (found == border_.end() || found->second.within) return false;
    file_.out.lines.push_back(found->second.line);
    file_.out.lines.back().groups = group;
    file_.out.lines.back().line = at;
    return true;
  }

  /// The group of a boundary; nothing, and a note, if the name is taken. \param what  it is made of
  std::optional<std::size_t> group_of(const std::string& key, const InpSet& set, const char* what) {
    if (const auto [other, is_new] = taken_.try_emplace(key, what, set.line); !is_new) {
      file_.in.notes.push_back(text("the ", what, " '", set.name, "' (line ", set.line,
                                    ") is no boundary, as the ", other->second.first, " of line ",
                                    other->second.second, " has this name: rename one of them"));
      return {};
    }
    return file_.out.groups.set_of({file_.out.groups.add(1, set.name)});
  }

  void add_surfaces() {
    for (const auto& [key, surface] : file_.in.surfaces) {
      const auto group = group_of(key, surface, "surface");
      bool within = false;
      for (const InpEntry& entry : surface.entries) {
        InpPlaces cells;
        file_.elements.put(entry, cells);
        for (const std::size_t cell : cells) {
          if (cell >= file_.in.cells.size() || file_.body_of[cell] == InpFile::none) continue;
          const GmshElement& one = file_.in.cells[cell];
          const bool all = entry.side == 0;
          const int first = entry.edge ? 1 : file_.in.first_sides[cell];
          const auto end = first + static_cast<int>(one.corners);
          require_input(all || (entry.side >= first && entry.side < end), file_.in.name, ":",
                        surface.line, ": surface '", surface.name, "': the element of line ",
                        one.line, " has no side ", entry.edge ? 'E' : 'S', entry.side,
                        first > 1 ? "; of a shell, S1 and S2 are its faces" : "");
          for (int side = all ? first : entry.side; side < end; ++side) {
            const GmshElement line = side_of(one, static_cast<std::size_t>(side - first));
            const bool added = add_line(line.nodes[0], line.nodes[1], *group, surface.line);
            within = within || (!added && !all);
            if (!all) break;
          }
        }
      }
      if (within)
        file_.in.unread.emplace(text("sides within a body of surface '", surface.name, '\''),
                                surface.line);
    }
  }

  void add_lines() {
    for (const auto& [key, set] : file_.in.element_sets) {
      const InpPlaces& places = file_.elements.of(key);
      if (places.empty() || places.front() < file_.in.cells.size()) continue;
      const auto group = group_of(key, set, "element set");
      for (const std::size_t place : places) {
        if (!group) break;
        const auto& nodes = file_.element(place).nodes;
        // Of three nodes some write the middle one second, others last.
        if (file_.element(place).n_nodes == 2 || !add_line(nodes[0], nodes[2], *group, set.line))
          add_line(nodes[0], nodes[1], *group, set.line);
      }
    }
  }

  /// Boundaries of the sides that have all their nodes in a set. \param what  the sets are
  void add_nodes(const InpSets& sets, const char* what) {
    for (const auto& [key, set] : sets) {
      InpPlaces nodes;
      for (const InpEntry& entry : set.entries) file_.nodes.put(entry, nodes);
      std::sort(nodes.begin(), nodes.end());
      const auto has = [&](std::size_t node) {
        return std::binary_search(nodes.begin(), nodes.end(), node);
      };
      const auto group = group_of(key, set, what);
      if (!group) continue;
      for (const auto& [at, side] : border_)
        if (has(at.first) && has(at.second) && (side.line.n_nodes == 2 || has(side.line.nodes[2])))
          add_line(at.first, at.second, *group, set.line);
    }
  }

  InpFile& file_;
  std::map<std::pair<std::size_t, std::size_t>, Border> border_;
  // What the boundary of a key is made of, and where that stands.
  std::map<std::string, std::pair<const char*, std::size_t>> taken_;
};

}  // namespace

void add_boundaries(InpFile& file) { BoundaryMaker(file).make(); }

}  // namespace signorini
