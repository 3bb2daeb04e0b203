// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// One number for a state of stress.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// Von Mises stress.
/// \param stress  (xx, yy, xy, zz) [force/length^2]
/// \return never negative [force/length^2]
[[nodiscard]] double von_mises(const Eigen::Vector4d& stress);

}  // namespace signorini
