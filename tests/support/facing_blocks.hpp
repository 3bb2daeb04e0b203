// Blocks that face each other, and the mortar pairs between them.
#pragma once
#include <cmath>

#include "meshes/block.hpp"
#include "signorini/pairing/mortar.hpp"

namespace signorini_test {

inline signorini::Mesh block(Eigen::Vector2d corner, Eigen::Vector2d size, Eigen::Index edges,
                             signorini::MeshOrder order = signorini::MeshOrder::Linear,
                             double grading = 1) {
  signorini::BlockSpec spec;
  spec.corner = corner;
  spec.size = size;
  spec.cells_x = edges;
  spec.order = order;
  spec.grading_x = grading;
  return signorini::make_block(spec);
}

inline signorini::Mesh turned(const signorini::Mesh& mesh, double angle) {
  return signorini::mapped(mesh, [angle](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return {std::cos(angle) * x.x() - std::sin(angle) * x.y(),
            std::sin(angle) * x.x() + std::cos(angle) * x.y()};
  });
}

/// The bottom of one body over the top of another one, whose nodes come after.
inline signorini::Pairs over(const signorini::Mesh& source, const signorini::Mesh& target,
                             signorini::GapOptions options = {}) {
  options.n_nodes = source.n_nodes() + target.n_nodes();
  return signorini::mortar({source, "bottom", 0}, {target, "top", source.n_nodes()}, options);
}

/// Force on every node, `n x 2`, of pair forces on rows of N or S.
inline signorini::NodeArray on_nodes(const signorini::NodalRows& rows,
                                     const Eigen::VectorXd& force) {
  const Eigen::VectorXd flat = rows.transpose() * force;
  return Eigen::Map<const signorini::NodeArray>(flat.data(), flat.size() / 2, 2);
}

constexpr signorini::MeshOrder orders[] = {signorini::MeshOrder::Linear,
                                           signorini::MeshOrder::Quadratic};

}  // namespace signorini_test
