// # Nodes that look joined and are not
//
// Meshes come from programs that make two blocks beside each other. If each block brings its own
// nodes, every place of the common line has two, and the body is cut there: it looks whole in every
// picture, and the cut opens under load. Or one block has more nodes than the other, and some hang
// on a side without belonging to it. Such nodes are called *duplicate* and *hanging*. A crack is a
// legal body, so that no equation complains. We look for nodes that lie on an outer side without
// being one of its nodes, and the user is told.
//
// How near is *on*? Coordinates in files often have six digits. On a body that is a thousand cells
// long the sixth digit is a thousandth of a cell, and this is what we take: 1/1000 of the shortest
// side there. A true gap between two bodies, or a crack that is open, is usually wider.

#include "addons/checks/loose_nodes.hpp"

#include <algorithm>

#include "signorini/core/index.hpp"
#include "signorini/fem/far.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/pairing/side_tree.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// What is nearer than that, measured by the sides of the cells there, is in one place.
constexpr double nearness = 1e-3;

/// The outer sides in a tree of boxes, and how near is near at each of their nodes.
///
/// To compare each node with each side would cost \f$n^2\f$. The boxes of side_tree.hpp leave a few
/// sides to look at for each node. The tree is asked for distances only; contact asks it for
/// normals as well.
class Outline {
 public:
  // The reach of a node is the smallest one of the cells around it that have an outer side there. A
  // reach of 0 marks the nodes inside.
  explicit Outline(const Mesh& mesh)
      : mesh_(mesh), sides_(outer_sides(mesh)), reach_(at(mesh.n_nodes()), 0) {
    std::vector<SideBox> leaves;
    for (const CellSide& side : sides_) {
      curves_.emplace_back(mesh, side);
      // Not the mean: a long thin cell would allow what is far for its short sides.
      const double reach = nearness * shortest_side(mesh, side.cell);
      for (const Index node : curves_.back().nodes()) {
        double& own = reach_[at(node)];
        if (own == 0) nodes_.push_back(node);
        own = own == 0 ? reach : std::min(own, reach);
      }
      // A leaf of the tree: the box around one side.
      SideBox box;
      box.lowest = curves_.back().box().col(0);
      box.highest = curves_.back().box().col(1);
      box.axis = Eigen::Vector2d::UnitX();  // normals are not asked for
      box.first = static_cast<Index>(leaves.size());
      leaves.push_back(box);
    }
    std::sort(nodes_.begin(), nodes_.end());
    if (!leaves.empty()) tree_ = box_tree(std::move(leaves));
  }

  // Two nodes in one place find each other. One entry is enough for a message, that of the higher
  // number. A node that hangs on a side finds no partner, and is listed in any case.
  [[nodiscard]] std::vector<LooseNode> loose() const {
    std::vector<LooseNode> found;
    for (const Index node : nodes_) {
      LooseNode loose{node, {-1, 0}, -1};
      look(tree_.back(), loose);
      if (loose.side.cell >= 0 && loose.other < node) found.push_back(loose);
    }
    return found;
  }

 private:
  // From the box around all down to single sides; a box that is too far is left with all that is in
  // it.
  void look(const SideBox& box, LooseNode& loose) const {
    if (box.distance(position(loose.node)) > reach_[at(loose.node)]) return;
    if (box.is_leaf()) return consider(at(box.first), loose);
    look(tree_[at(box.first)], loose);
    look(tree_[at(box.second)], loose);
  }

  /// A node in the same place counts more than a side, and among nodes the lowest.
  ///
  /// Neither node nor side: then the closest place of the side, by the reach of both cells.
  void consider(std::size_t number, LooseNode& loose) const {
    const SideCurve& curve = curves_[number];
    const Eigen::Vector2d x = position(loose.node);
    const double reach = reach_[at(loose.node)];
    for (const Index node : curve.nodes())
      if (node == loose.node) return;
    for (const Index node : curve.nodes())
      if ((x - position(node)).norm() <= std::min(reach, reach_[at(node)]) &&
          (loose.other < 0 || node < loose.other)) {
        loose.side = sides_[number];
        loose.other = node;
      }
    if (loose.other >= 0 || loose.side.cell >= 0) return;
    const AnchoredPoint exact(x);
    const double xi = curve.closest(exact);
    const double reach_there = nearness * shortest_side(mesh_, sides_[number].cell);
    if ((exact - curve.point(xi)).norm() <= std::min(reach, reach_there))
      loose.side = sides_[number];
  }

  [[nodiscard]] Eigen::Vector2d position(Index node) const {
    return mesh_.nodes.row(node).transpose();
  }

  const Mesh& mesh_;
  std::vector<CellSide> sides_;
  std::vector<SideCurve> curves_;
  std::vector<double> reach_;  // per node, 0 inside
  std::vector<Index> nodes_;   // on the outline, increasing
  std::vector<SideBox> tree_;  // the box around all is the last
};

}  // namespace

/// The mesh must have passed check_mesh(): a side of no length would make every reach there 0.
std::vector<LooseNode> loose_nodes(const Mesh& mesh) { return Outline(mesh).loose(); }

}  // namespace signorini
