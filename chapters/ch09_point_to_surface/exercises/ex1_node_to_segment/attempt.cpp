#include "exercise.hpp"

namespace ex9_1 {

std::optional<Place> facing(const Nodes& /*positions*/) {
  // your code here: shape functions first, then normal, tangent and gap
  return std::nullopt;
}

Nodes shared_out(const Place& /*place*/, double /*normal*/, double /*friction*/) {
  // your code here
  return Nodes::Zero();
}

}  // namespace ex9_1
