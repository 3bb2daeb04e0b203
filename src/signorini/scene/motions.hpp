/// \file
/// Rigid motions of the bodies of a scene: which there are, what contact makes of them, and where to ground them.
#pragma once
#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "signorini/core/alignment.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// Rigid motions that supports and springs leave to the bodies, each on the unknowns of all of them.
/// \param bodies  with their unknowns and springs
/// \return `n_r` independent motions
[[nodiscard]] std::vector<FreeMotion> rigid_modes(const std::vector<BodyModel>& bodies);

/// \param bodies  one or several
/// \return one rounding of the directions of their sides [-]: that of the body that knows them worst
[[nodiscard]] double direction_rounding(const std::vector<BodyModel>& bodies);

/// \param modes  from rigid_modes()
/// \return one rounding of the directions that they were made from [-], 0 if there are none
[[nodiscard]] double direction_rounding(const std::vector<FreeMotion>& modes);

/// Rigid motions that open and close no gap.
/// \param A      `n_c x n` gaps, see Gaps
/// \param modes  `n_r` rigid motions of `n` unknowns
/// \return sentences of the modes that take part in such a motion, empty if every motion moves some gap
[[nodiscard]] std::vector<std::string> motions_without_contact(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& A, const std::vector<FreeMotion>& modes);

/// One unknown per rigid mode to attach a spring to, so that the springs alone hold the bodies.
/// \param modes  `n_r` independent rigid motions of `n` unknowns
/// \return `n_r` numbers of unknowns
[[nodiscard]] std::vector<Eigen::Index> grounding(const std::vector<FreeMotion>& modes);

/// The shapes of rigid modes side by side, by their entries.
/// \param modes  `n_r`
/// \return `n x n_r`; empty if there are none
[[nodiscard]] Eigen::SparseMatrix<double> mode_entries(const std::vector<FreeMotion>& modes);

/// The same for dense methods: with all zeros, `n` numbers a mode.
/// \param modes  `n_r`
/// \return `n x n_r`; empty if there are none
[[nodiscard]] Eigen::MatrixXd mode_shapes(const std::vector<FreeMotion>& modes);

}  // namespace signorini
