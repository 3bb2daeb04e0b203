// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The nodes that edges get where they are halved.
#pragma once
#include <array>
#include <vector>

#include "addons/estimate/edges.hpp"
#include "signorini/core/index.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Nodes on halved edges. Those on the outline lie as OutlineShape says; those of a refinement line between quadrilaterals are
/// moved off their edges as its two ends are, the more the nearer they are along the line.
class EdgeMidpoints {
 public:
  /// \param mesh    any; must outlive this
  /// \param edges   of it; must outlive this
  /// \param halved  of each edge, not 0 if it is halved; closed under halving
  EdgeMidpoints(const Mesh& mesh, const MeshEdges& edges, std::vector<char> halved);

  /// \param side  of a cell \return whether its edge is halved
  [[nodiscard]] bool halves(const CellSide& side) const {
    return halved_[at(edges_.at(side))] != 0;
  }
  /// A node of a halved edge.
  /// \param side   of a cell
  /// \param place  0, 1 or 2: at -1/2, 0 or 1/2 as the cell walks; 1 only with two nodes per side
  /// \return its number
  [[nodiscard]] Eigen::Index node(const CellSide& side, int place) const;
  /// \return positions of the old nodes, then of those on edges [length]
  [[nodiscard]] const NodeArray& nodes() const { return nodes_; }

 private:
  /// An edge, and whether it is walked against its first cell.
  struct Walked {
    Eigen::Index edge;
    bool against;
  };
  template <typename Visit>
  void visit_new(Eigen::Index edge, Visit&& visit) const;
  [[nodiscard]] std::vector<Walked> line_from(Eigen::Index edge) const;
  template <typename Shape>
  [[nodiscard]] std::vector<Eigen::Vector2d> off(const Walked& walked, const Shape& shape) const;
  void bend(const std::vector<Walked>& line, const std::vector<Eigen::Vector2d>& start,
            const std::vector<Eigen::Vector2d>& end);

  const Mesh& mesh_;
  const MeshEdges& edges_;
  std::vector<char> halved_;
  std::vector<std::array<Eigen::Index, 3>> on_;  // as the first cell of the edge walks
  NodeArray nodes_;
};

}  // namespace signorini
