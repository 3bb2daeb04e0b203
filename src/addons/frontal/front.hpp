// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The dense part of a front: eliminating its own unknowns.
#pragma once
#include <Eigen/Core>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// Eliminates the own unknowns of a front: the columns become those of L, and what they do to the
/// boundary is taken off the update.
/// \param columns  `(own + rim) x own` of the matrix, of which the lower triangle is read; then those of L
/// \param update   `rim x rim` lower triangle, less L21 L21^T
/// \param least    `own` what each pivot must exceed
/// \return how many unknowns were eliminated; if not all, the diagonal holds the pivot that is too small
[[nodiscard]] Eigen::Index eliminate(Eigen::Ref<Eigen::MatrixXd> columns,
                                     Eigen::Ref<Eigen::MatrixXd> update,
                                     const Eigen::Ref<const Eigen::VectorXd>& least);

}  // namespace signorini
