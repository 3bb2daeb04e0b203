// Meshes whose cells do not hang together as they should.
#pragma once
#include <vector>

#include "meshes/block.hpp"
#include "support/two_bodies.hpp"

namespace signorini_test {

/// Both meshes in one, no node in common. The boundaries of the second are called as in the first, with a 2.
inline signorini::Mesh together(signorini::Mesh first, const signorini::Mesh& second) {
  const Eigen::Index nodes = first.n_nodes();
  const Eigen::Index cells = first.n_cells();
  first.nodes.conservativeResize(nodes + second.n_nodes(), 2);
  first.nodes.bottomRows(second.n_nodes()) = second.nodes;
  first.cells.conservativeResize(cells + second.n_cells(), Eigen::NoChange);
  first.cells.bottomRows(second.n_cells()) = second.cells.array() + nodes;
  for (const auto& [name, sides] : second.boundaries)
    for (signorini::CellSide side : sides) {
      side.cell += cells;
      first.boundaries[name + "2"].push_back(side);
    }
  return first;
}

/// The same mesh, of about unit size, with one number for all nodes that are in one place.
inline signorini::Mesh merged(signorini::Mesh mesh) {
  std::vector<Eigen::Index> number;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index node = 0; node < mesh.n_nodes(); ++node) {
    Eigen::Index same = 0;
    while (same < static_cast<Eigen::Index>(kept.size()) &&
           (mesh.nodes.row(kept[static_cast<std::size_t>(same)]) - mesh.nodes.row(node)).norm() >
               1e-12)
      ++same;
    if (same == static_cast<Eigen::Index>(kept.size())) kept.push_back(node);
    number.push_back(same);
  }
  for (Eigen::Index& node : mesh.cells.reshaped()) node = number[static_cast<std::size_t>(node)];
  mesh.nodes = mesh.nodes(kept, Eigen::all).eval();
  return mesh;
}

/// A block 4 x 2 of 4 x 2 cells or more, split from its top down to `tip` along x = 2: nodes of the line
/// above are there twice. Its boundaries are those of its halves, see together().
inline signorini::Mesh split_block(double tip, Eigen::Index finer = 1,
                                   signorini::MeshOrder order = signorini::MeshOrder::Linear) {
  const signorini::Mesh left = named_block("block", {0, 0}, {2, 2}, 2 * finer, 2 * finer, order);
  const signorini::Mesh right = named_block("", {2, 0}, {2, 2}, 2 * finer, 2 * finer, order);
  // Open while the other nodes are merged, and of those above the tip, the left ones.
  const auto opened = [tip](signorini::Mesh mesh, double by) {
    for (Eigen::Index node = 0; node < mesh.n_nodes(); ++node)
      if (mesh.nodes(node, 0) == 2 && mesh.nodes(node, 1) > tip) mesh.nodes(node, 1) += by;
    return mesh;
  };
  signorini::Mesh both = merged(together(opened(left, 8), right));
  for (Eigen::Index node = 0; node < both.n_nodes(); ++node)
    if (both.nodes(node, 1) > 8) both.nodes(node, 1) -= 8;
  return both;
}

/// A block 2 x 1 whose right half has `finer` times as many cells in height as the left: `finer` - 1 nodes hang
/// on each of the left cells' sides. The halves share all other nodes.
inline signorini::Mesh hanging_block(Eigen::Index finer,
                                     signorini::MeshOrder order = signorini::MeshOrder::Linear) {
  return merged(together(named_block("block", {0, 0}, {1, 1}, 2, 2, order),
                         named_block("", {1, 0}, {1, 1}, 2, 2 * finer, order)));
}

}  // namespace signorini_test
