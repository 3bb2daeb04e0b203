// What one of several processes assembles of K.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "signorini/scene/bodies.hpp"
#include "signorini/scene/scene.hpp"

namespace command_line {

/// The share of K that one of several processes assembles: of every body as many cells as each of the others, and of the
/// first process the springs too. The shares add up to the K of build() of a scene without equations.
/// \param bodies  with their unknowns and springs
/// \param part    number of the share, from 0
/// \param parts   how many shares there are
/// \return `n x n` compressed, both triangles [force/length]
[[nodiscard]] Eigen::SparseMatrix<double> stiffness_share(
    const std::vector<signorini::BodyModel>& bodies, int part, int parts);

/// The same of a scene. Equations join unknowns of all shares: where the scene has some, the first process assembles all of K.
/// \param scene  as for build()
/// \param part   number of the share, from 0
/// \param parts  how many shares there are
/// \return `n x n` compressed, both triangles [force/length]
[[nodiscard]] Eigen::SparseMatrix<double> stiffness_share(const signorini::Scene& scene, int part,
                                                          int parts);

}  // namespace command_line
