// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How contact forces on nodes change because the bodies move, while the forces of the pairs stay.
#pragma once
#include <Eigen/SparseCore>

#include "addons/motion/kept_points.hpp"

namespace signorini {

/// The symmetric matrix \f$ B = \partial(N^T\lambda)/\partial u \f$ with \f$ \lambda \f$ fixed: normals turn, and places of the
/// target wander along its sides. A Newton step of bodies that move has \f$ K - B \f$ in the place of K.
///
/// The shares of points are held, and for such rows B is exact but for the rule of the integrals. Those of the library's rows
/// follow the lengths of the source. What they add is not symmetric: a tenth of B or more if each node moves alone, and
/// less than 1 % of what a displacement does that is smooth on the scale of the source's edges. So B is an accelerator and no
/// truth. Exact are its properties: it is symmetric, a translation of all bodies is a null vector, and a turn of all by
/// \f$ \omega \f$ is mapped to the forces that turn with them. An obstacle stands still and is no body then; one whose gap is no distance, as of profile(),
/// has the part that lies along it. What friction adds is not symmetric and is left out.
/// \param kept    points of the pairs; pairs without are taken for flat
/// \param force   `n_c` contact forces [force], compression > 0
/// \param places  `n_nodes x 2` of all nodes, where the pairs were found [length]
/// \return `2 n_nodes x 2 n_nodes` [force/length], column 2 * node + axis; no entries of pairs without force
[[nodiscard]] Eigen::SparseMatrix<double> contact_curvature(const KeptPoints& kept,
                                                            const Eigen::VectorXd& force,
                                                            const NodeArray& places);

}  // namespace signorini
