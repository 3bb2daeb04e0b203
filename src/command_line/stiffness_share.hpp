// What one of several processes assembles of K.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "signorini/scene/bodies.hpp"

namespace command_line {

/// The share of K that one of several processes assembles: of every body as many cells as each of the others, and of the
/// first process the springs too. The shares add up to the K of build(), whatever the scene calls for.
/// \param bodies  with their unknowns and springs
/// \param part    number of the share, from 0
/// \param parts   how many shares there are
/// \return `n x n` compressed, both triangles [force/length]
[[nodiscard]] Eigen::SparseMatrix<double> stiffness_share(
    const std::vector<signorini::BodyModel>& bodies, int part, int parts);

}  // namespace command_line
