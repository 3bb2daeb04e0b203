#include "exercise.hpp"

namespace ex22_2 {

double place_faced(const Scene& scene) {
  const Vector2d side = scene.last - scene.first;
  return (scene.node - scene.first).dot(side) / side.squaredNorm();
}

double slip(const Scene& before, const Scene& now) {
  const Vector2d side = before.last - before.first;
  const Vector2d place = before.first + place_faced(now) * side;
  return (place - before.node).dot(side.normalized());
}

}  // namespace ex22_2
