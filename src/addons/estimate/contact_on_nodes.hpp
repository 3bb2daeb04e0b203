// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Pressures and normals of contact on the nodes of a body.
#pragma once
#include <Eigen/Core>

#include "signorini/scene/solution.hpp"

namespace signorini {

/// What contact does to the nodes of a body: pairs with obstacles, which hold the nodes themselves, and pairs with meshes.
class ContactOnNodes {
 public:
  /// \param model  from build() \param body  one of its bodies
  ContactOnNodes(const Model& model, const BodyModel& body);

  /// Pressures on the nodes: what the forces of pairs do to a node, by what an even pressure of 1 does.
  /// \param force  of all pairs, then of rows that are not looked at [force]
  /// \return `n_nodes x 2`, of obstacles and of meshes; 0 without contact [force/length^2]
  [[nodiscard]] NodeArray pressures(const Eigen::VectorXd& force) const;
  /// How far the normals of contact turn between two nodes.
  /// \param first  node \param last  another \param by  an angle [rad]
  /// \return the angles by that one, of obstacles and of meshes; 0 without contact [-]
  [[nodiscard]] Eigen::Vector2d turning(Eigen::Index first, Eigen::Index last, double by) const;

 private:
  [[nodiscard]] Eigen::MatrixX2d on_nodes(const Eigen::VectorXd& force) const;

  NodalRows opening_;       // of the nodes of the body
  Eigen::VectorXd meshed_;  // of each pair, 1 or 0
  Eigen::MatrixX2d
      even_;  // what an even pressure of 1 does to the components of the nodes [length^2]
};

}  // namespace signorini
