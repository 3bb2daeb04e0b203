#include "addons/files/gmsh_boundaries.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// A side of a cell by its end nodes in the file.
struct FileSide {
  Index low, high, middle;  // node numbers; middle is -1 without one
  bool forward;             // it runs from low to high
  std::size_t body;
  CellSide side;
};

bool same_ends(const FileSide& a, const FileSide& b) { return a.low == b.low && a.high == b.high; }
bool ends_before(const FileSide& a, const FileSide& b) {
  return std::tie(a.low, a.high) < std::tie(b.low, b.high);
}

std::size_t line_of(const GmshRecords& file, const std::vector<GmshBody>& bodies,
                    const FileSide& side) {
  return file.cells[bodies[side.body].source[at(side.side.cell)]].line;
}

/// Refuses neighbours in the sorted list that cannot be in one mesh.
void check_neighbours(const GmshRecords& file, const std::vector<GmshBody>& bodies,
                      const FileSide& a, const FileSide& b) {
  const std::size_t line_a = line_of(file, bodies, a);
  const std::size_t line_b = line_of(file, bodies, b);
  require_input(
      a.forward != b.forward, file.name, ":", std::max(line_a, line_b),
      ": this cell and that of line ", std::min(line_a, line_b),
      " lie on the same side of an edge: they overlap, or the surface is in two physical groups");
  require_input(a.body != b.body || a.middle == b.middle, file.name, ":", std::max(line_a, line_b),
                ": this cell and that of line ", std::min(line_a, line_b),
                " share the ends of a side but not its middle node");
}

/// All sides of all cells, sorted by their ends.
std::vector<FileSide> sorted_sides(const GmshRecords& file, const std::vector<GmshBody>& bodies) {
  std::vector<FileSide> sides;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const Mesh& mesh = bodies[body].mesh;
    const CellArray& cells = bodies[body].file_nodes;
    for (Index cell = 0; cell < cells.rows(); ++cell) {
      const int n = mesh.corners(cell);
      for (int s = 0; s < n; ++s) {
        const Index first = cells(cell, s);
        const Index last = cells(cell, (s + 1) % n);
        const Index middle = mesh.order() == MeshOrder::Quadratic ? cells(cell, n + s) : -1;
        if (first == last) continue;  // a degenerate cell, which check_mesh() refuses
        sides.push_back(
            {std::min(first, last), std::max(first, last), middle, first < last, body, {cell, s}});
      }
    }
  }
  std::sort(sides.begin(), sides.end(), [](const FileSide& a, const FileSide& b) {
    return std::tie(a.low, a.high, a.forward) < std::tie(b.low, b.high, b.forward);
  });
  for (std::size_t k = 1; k < sides.size(); ++k)
    if (same_ends(sides[k - 1], sides[k])) check_neighbours(file, bodies, sides[k - 1], sides[k]);
  return sides;
}

/// Number of the part of a body that a side belongs to; -1 if it has none.
Index part_of(const Mesh& mesh, const CellSide& side) {
  Index number = 0;
  for (const auto& [name, cells] : mesh.regions) {
    if (std::binary_search(cells.begin(), cells.end(), side.cell)) return number;
    ++number;
  }
  return -1;
}

/// The sides that lie on a line: one, two of different bodies, or none between parts of a body.
std::pair<std::vector<FileSide>::const_iterator, std::vector<FileSide>::const_iterator> sides_on(
    const GmshRecords& file, const std::vector<GmshBody>& bodies,
    const std::vector<FileSide>& sides, const GmshElement& line, const std::string& curve) {
  const auto a = static_cast<Index>(line.nodes[0]);
  const auto b = static_cast<Index>(line.nodes[1]);
  const FileSide wanted{std::min(a, b), std::max(a, b), -1, true, 0, {0, 0}};
  const auto found = std::equal_range(sides.begin(), sides.end(), wanted, ends_before);
  require_input(
      found.first != found.second, file.name, ":", line.line, ": this line of '", curve,
      "' is no side of a cell; put the surface beside it into a physical group, or take the curve "
      "out of its group");
  const FileSide& one = *found.first;
  const FileSide& other = *(found.second - 1);
  const bool within = found.second - found.first == 2 && one.body == other.body;
  if (within &&
      part_of(bodies[one.body].mesh, one.side) != part_of(bodies[other.body].mesh, other.side))
    return {found.second, found.second};
  require_input(
      !within, file.name, ":", line.line, ": this line of '", curve,
      "' lies within a body; make each part a physical surface, or take the curve out of its "
      "group");
  const Index middle = line.n_nodes == 3 ? static_cast<Index>(line.nodes[2]) : -1;
  for (auto side = found.first; side != found.second; ++side)
    require_input(side->middle == middle, file.name, ":", line.line, ": this line of '", curve,
                  "' has ", line.n_nodes, " nodes, and the side of the cell there has ",
                  side->middle < 0    ? "2"
                  : line.n_nodes == 2 ? "3"
                                      : "another middle node",
                  "; save all elements with the same Mesh.ElementOrder");
  return found;
}

/// Takes away what stands in a list for the second time.
std::vector<CellSide> each_once(const std::vector<CellSide>& sides) {
  std::vector<CellSide> result;
  std::set<std::pair<Index, int>> seen;
  for (const CellSide& side : sides)
    if (seen.insert({side.cell, side.side}).second) result.push_back(side);
  return result;
}

}  // namespace

void add_boundaries(const GmshRecords& file, std::vector<GmshBody>& bodies) {
  const std::vector<FileSide> sides = sorted_sides(file, bodies);
  using Found = std::map<std::int64_t, std::vector<CellSide>>;  // by the tag of the group
  std::vector<Found> found(bodies.size());
  std::map<std::string, std::int64_t> tags;
  for (const GmshElement& line : file.lines)
    for (const std::int64_t tag : file.groups.tags(line.groups)) {
      const std::string curve = file.groups.name(1, tag);
      const std::int64_t other = tags.emplace(curve, tag).first->second;
      require_input(other == tag, file.name, ":", line.line, ": physical curves ", other, " and ",
                    tag, " are both named '", curve, "'; rename one");
      const auto [begin, end] = sides_on(file, bodies, sides, line, curve);
      for (auto side = begin; side != end; ++side) found[side->body][tag].push_back(side->side);
    }
  for (std::size_t body = 0; body < bodies.size(); ++body)
    for (const auto& [tag, list] : found[body])
      bodies[body].mesh.boundaries[file.groups.name(1, tag)] =
          chained(bodies[body].mesh, each_once(list));
}

std::vector<CellSide> chained(const Mesh& mesh, const std::vector<CellSide>& sides) {
  const auto first_node = [&](std::size_t k) { return mesh.side_nodes(sides[k]).front(); };
  const auto last_node = [&](std::size_t k) { return mesh.side_nodes(sides[k]).back(); };
  std::map<Index, std::deque<std::size_t>> begin_at;  // the sides that go on from a node
  std::map<Index, int> open;                          // how many more begin there than end there
  for (std::size_t k = 0; k < sides.size(); ++k) {
    begin_at[first_node(k)].push_back(k);
    ++open[first_node(k)];
    --open[last_node(k)];
  }
  std::vector<CellSide> result;
  std::vector<char> used(sides.size(), 0);
  const auto walk = [&](std::size_t k) {
    for (;;) {
      used[k] = 1;
      result.push_back(sides[k]);
      std::deque<std::size_t>& next = begin_at[last_node(k)];
      while (!next.empty() && used[next.front()] != 0) next.pop_front();
      if (next.empty()) return;
      k = next.front();
    }
  };
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (used[k] == 0 && open[first_node(k)] > 0) {
      --open[first_node(k)];
      walk(k);
    }
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (used[k] == 0) walk(k);
  return result;
}

}  // namespace signorini
