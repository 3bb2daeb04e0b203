/// \file
/// Supports, and the numbering of what they leave free.
///
/// A component of a node is either unknown or given, never both. Supports decide, boundary by
/// boundary, and what they leave is numbered node by node. There is no penalty and no multiplier
/// for a support: a given displacement is exact, and its force is read afterwards from the rows
/// that were left out.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "signorini/fem/material.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// A number at every place.
using ScalarField = std::function<double(const Eigen::Vector2d&)>;
/// A vector at every place.
using VectorField = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// Direction of a displacement.
enum class Axis { X = 0, Y = 1 };

/// Displacements that are given along one boundary. Made by fixed(), symmetric() and prescribed().
struct Support {
  std::string boundary;      ///< where
  bool holds_x = false;      ///< whether the x component is given
  bool holds_y = false;      ///< whether the y component is given
  VectorField displacement;  ///< [length]; must be there, only the held components are used
  bool normal_only = false;  ///< symmetry: hold the component across the (axis-parallel) boundary
  std::optional<Eigen::Vector2d> only_at = {};  ///< hold this one node of the boundary [length]
  std::string history =
      {};  ///< name of what the displacement grows with, see Path; empty: it is always there
};

/// No displacement. \PaperEq{XuanLi2002, 5}
/// \param boundary  where
/// \return the support
[[nodiscard]] Support fixed(const std::string& boundary);
/// No displacement across the boundary, free along it.
/// \param boundary  straight and parallel to an axis; number_unknowns() checks it
/// \return the support
[[nodiscard]] Support symmetric(const std::string& boundary);
/// One component is given and constant, the other one is free.
/// \param boundary      where
/// \param axis          which component
/// \param displacement  its value [length]
/// \return the support
[[nodiscard]] Support prescribed(const std::string& boundary, Axis axis, double displacement);
/// One component is given and varies along the boundary, the other one is free.
/// \param boundary      where
/// \param axis          which component
/// \param displacement  its value at every place [length]
/// \return the support
[[nodiscard]] Support prescribed(const std::string& boundary, Axis axis,
                                 const ScalarField& displacement);

/// One component of one node is given, such as the last one that a body needs to stay in place.
/// \param boundary      that the node lies on
/// \param point         where it lies [length]
/// \param axis          which component
/// \param displacement  its value [length]
/// \return the support; number_unknowns() checks that there is such a node
[[nodiscard]] Support prescribed_at(const std::string& boundary, const Eigen::Vector2d& point,
                                    Axis axis, double displacement = 0);

/// Which displacement components are unknown.
struct Unknowns {
  Eigen::Array<Eigen::Index, Eigen::Dynamic, 2> number;  ///< `n_nodes x 2`: unknown, or -1 if held
  NodeArray held;          ///< `n_nodes x 2`: given displacement where held, else 0 [length]
  Eigen::Index count = 0;  ///< number of unknowns `n`
  std::vector<int> node_of;  ///< `n` node of each unknown, in increasing order

  /// What a message calls an unknown.
  /// \param mesh     that was numbered
  /// \param unknown  its number
  /// \return such as "node 12 at (3, 4), direction y"
  [[nodiscard]] std::string describe(const Mesh& mesh, Eigen::Index unknown) const;
};

/// Where the unknowns are.
/// \param mesh      that was numbered
/// \param unknowns  `n` of it
/// \return `n x 2` position of the node of each unknown [length]
[[nodiscard]] NodeArray unknown_positions(const Mesh& mesh, const Unknowns& unknowns);

/// The nodes of a body of revolution that lie on its axis x = 0, up to rounding.
/// \param mesh  the half of its cross-section with x >= 0
/// \return their numbers, increasing; none if the body has a hole there
/// \throws ProblemError if a node lies at x < 0
[[nodiscard]] std::vector<Eigen::Index> axis_nodes(const Mesh& mesh);

/// Numbers the unknowns node by node.
/// \param mesh      the body
/// \param supports  what holds it
/// \param state     in axial symmetry, what lies on the axis does not move away from it
/// \return every component that no support gives, nor the axis, is unknown
/// \throws ProblemError as axis_nodes(), or if a boundary does not exist or has no node where only one is to be held, a
///   symmetric one is not parallel to an axis, a given displacement is not finite, or two supports
///   contradict each other
[[nodiscard]] Unknowns number_unknowns(const Mesh& mesh, const std::vector<Support>& supports,
                                       PlaneState state = PlaneState::Strain);

/// Numbers the unknowns of several bodies one after another.
/// \param bodies  numbered one by one; none is null
/// \return nodes and unknowns of the first body, then those of the second, ...
[[nodiscard]] Unknowns joined(const std::vector<const Unknowns*>& bodies);

}  // namespace signorini
