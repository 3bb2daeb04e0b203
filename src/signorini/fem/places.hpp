/// \file
/// Places of a body that a user names by where they are.
///
/// Coordinates name a place on every mesh, numbers of nodes on one mesh only.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "signorini/fem/mesh.hpp"
#include "signorini/fem/side_curve.hpp"

namespace signorini {

/// The nodes of a boundary, or the one of them at a point.
/// \param mesh      that has the boundary
/// \param boundary  its name
/// \param only_at   where the node lies, up to the rounding of positions [length]; all of them without it
/// \param what      is to be done there, for messages
/// \return node numbers in walking order
/// \throws ProblemError if there is no such boundary, or none of its nodes at the point: the message names the nearest
[[nodiscard]] std::vector<Eigen::Index> nodes_at(const Mesh& mesh, const std::string& boundary,
                                                 const std::optional<Eigen::Vector2d>& only_at,
                                                 const std::string& what);

/// How the nodes of a body share what acts at one place.
struct EdgePlace {
  std::vector<Eigen::Index> nodes;  ///< one, or the two or three of a side
  Eigen::Vector3d share;            ///< of each of them [-]; those of a side add up to 1
};

/// The edge of a body, to find places on. Its sides are looked up for the first place that is not a node, and kept.
class Edge {
 public:
  /// \param mesh  the body; must outlive the edge
  explicit Edge(const Mesh& mesh);

  /// \param point  where [length]
  /// \return as place_on_edge()
  /// \throws ProblemError as place_on_edge()
  [[nodiscard]] EdgePlace place(const Eigen::Vector2d& point);

 private:
  const Mesh& mesh_;
  std::vector<SideCurve> sides_;
};

/// Finds a node, or a place on the edge of a body, up to the rounding of positions.
/// \param mesh   the body
/// \param point  where [length]
/// \return the node, or the nodes of the side with their shape functions there
/// \throws ProblemError if the point is neither, naming the nearest node, or lies on two sides or nodes that are
///   not joined
[[nodiscard]] EdgePlace place_on_edge(const Mesh& mesh, const Eigen::Vector2d& point);

}  // namespace signorini
