// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What warm bodies do: strains that nothing hinders.
#pragma once
#include <Eigen/Core>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Strain of a material that is warmer and free to expand: \f$ \alpha\,\Delta T \f$ in every direction.
/// \param material  with its expansion
/// \param warmer    how much warmer [temperature]
/// \return (xx, yy, 2 xy, across) [-]
[[nodiscard]] Eigen::Vector4d thermal_strain(const Material& material, double warmer);

/// \param temperature  of a body
/// \return thermal_strain() at every place; empty if the body is not warm
[[nodiscard]] Eigenstrain expansion(const Temperature& temperature);

}  // namespace signorini
