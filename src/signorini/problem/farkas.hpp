/// \file
/// The proof that gaps contradict each other, from a set of pairs.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/scaled.hpp"

namespace signorini {

/// Looks for the proof that nothing solves a problem: y with y_p = 1 and \f$ y_W = -G_{WW}^{-1} G_{Wp} \f$,
/// the forces that hold the pairs of a set where they are while one more is pressed.
/// \param problem  scaled, without friction
/// \param active   W, without p
/// \param pair     p, which depends on W
/// \return y `n_c` in the units of the forces, such that the scaled ones sum to 1, if verify_farkas() holds for the scaled
///   problem; otherwise an empty vector
[[nodiscard]] Eigen::VectorXd farkas_certificate(const ScaledProblem& problem,
                                                 const std::vector<Eigen::Index>& active,
                                                 Eigen::Index pair);

}  // namespace signorini
