/// \file
/// Supports, and the numbering of what they leave free.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// A number, or a vector, at every place.
using ScalarField = std::function<double(const Eigen::Vector2d&)>;
using VectorField = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// Direction of a displacement.
enum class Axis { X = 0, Y = 1 };

/// Displacements that are given along one boundary.
struct Support {
  std::string boundary;
  bool holds_x = false;
  bool holds_y = false;
  VectorField displacement;  ///< [length]; only the held components are used
  bool normal_only = false;  ///< symmetry: hold the component across the (axis-parallel) boundary
};

/// No displacement. \PaperEq{XuanLi2002, 5}
[[nodiscard]] Support fixed(const std::string& boundary);
/// No displacement across the boundary, free along it; the boundary must be parallel to an axis.
[[nodiscard]] Support symmetric(const std::string& boundary);
/// One component is given, constant or varying along the boundary [length].
[[nodiscard]] Support prescribed(const std::string& boundary, Axis axis, double displacement);
[[nodiscard]] Support prescribed(const std::string& boundary, Axis axis,
                                 const ScalarField& displacement);

/// Which displacement components are unknown.
struct Unknowns {
  Eigen::Array<Eigen::Index, Eigen::Dynamic, 2> number;  ///< `n_nodes x 2`: unknown, or -1 if held
  NodeArray held;          ///< `n_nodes x 2`: given displacement where held, else 0 [length]
  Eigen::Index count = 0;  ///< number of unknowns
  std::vector<Eigen::Index>
      node_of;  ///< node of each unknown; unknowns of a node follow each other

  /// "node 12 at (3, 4), direction y": what a message calls an unknown.
  [[nodiscard]] std::string describe(const Mesh& mesh, Eigen::Index unknown) const;
};

/// Position of the node of each unknown, `n x 2` [length].
[[nodiscard]] NodeArray unknown_positions(const Mesh& mesh, const Unknowns& unknowns);

/// Numbers the unknowns node by node.
/// \throws ProblemError if a boundary does not exist, a symmetric one is not parallel to an axis, a
///   given displacement is not finite, or two supports contradict each other
[[nodiscard]] Unknowns number_unknowns(const Mesh& mesh, const std::vector<Support>& supports);

/// Finds the rigid motions that the supports leave to each connected body of the mesh.
/// \return one sentence per body that can move ("body 'x' (cells 0 to 7) can move freely in direction
///   x"), empty if there is none
[[nodiscard]] std::vector<std::string> free_motions(const Mesh& mesh, const Unknowns& unknowns);

}  // namespace signorini
