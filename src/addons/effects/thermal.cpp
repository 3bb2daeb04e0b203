#include "addons/effects/thermal.hpp"

namespace signorini {

Eigen::Vector4d thermal_strain(const Material& material, double warmer) {
  const double strain = material.expansion * warmer;
  return {strain, strain, 0, strain};
}

Eigenstrain expansion(const Temperature& temperature) {
  if (!temperature.nonzero()) return {};
  return [temperature](const Material& material, const Eigen::Vector2d& x) {
    return thermal_strain(material, temperature.at(x));
  };
}

}  // namespace signorini
