#include "support/same_scenes.hpp"

#include <algorithm>
#include <numeric>

#include "support/random.hpp"

namespace signorini_test {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

VectorField in_units(const VectorField& field, double length, double value) {
  if (!field) return {};
  return [=](const Vector2d& x) { return Vector2d(value * field(x / length)); };
}

void rescale(Material& material, double length, double stress) {
  material.youngs_modulus *= stress;
  if (material.state != PlaneState::Axial) material.thickness *= length;
}

/// The order of `n` things, shuffled.
std::vector<Index> shuffled(Index n, std::uint64_t seed) {
  std::vector<Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Index{0});
  Random random(seed);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1],
              order[static_cast<std::size_t>(random.uniform(0, static_cast<double>(i)))]);
  return order;
}

}  // namespace

Scene in_units(Scene scene, double length, double force) {
  const double stress = force / (length * length);
  for (Body& body : scene.bodies) {
    body.mesh.nodes *= length;
    rescale(body.material, length, stress);
    for (Layer& layer : body.layers) rescale(layer.material, length, stress);
    for (Support& support : body.supports) {
      support.displacement = in_units(support.displacement, length, length);
      if (support.only_at) *support.only_at *= length;
    }
    for (Spring& spring : body.springs) {
      spring.stiffness *= spring.only_at ? force / length : stress / length;
      if (spring.only_at) *spring.only_at *= length;
    }
    Loads& loads = body.loads;
    loads.body_force = in_units(loads.body_force, length, stress / length);
    for (EdgeLoad& load : loads.edges) {
      load.pressure *= stress;
      load.traction = in_units(load.traction, length, stress);
    }
    for (PointForce& load : loads.points) {
      load.point *= length;
      load.force *= force;
    }
    if (body.temperature) body.temperature->gradient /= length;
  }
  for (ContactSpec& contact : scene.contacts) {
    if (contact.friction) contact.friction->cohesion *= stress;
    if (contact.interference) *contact.interference *= length;
    if (contact.adjust) *contact.adjust *= length;
    if (auto* const obstacle = std::get_if<Obstacle>(&contact.target))
      obstacle->look = [look = obstacle->look, length](const Vector2d& x) {
        ObstacleContact seen = look(x / length);
        seen.gap *= length;
        return seen;
      };
  }
  return scene;
}

Renumbered renumbered(Scene scene, std::uint64_t seed) {
  Renumbered result{std::move(scene), {}};
  for (Body& body : result.scene.bodies) {
    const NodeArray old = body.mesh.nodes;
    const std::vector<Index> place = shuffled(old.rows(), seed);
    for (Index node = 0; node < old.rows(); ++node)
      body.mesh.nodes.row(place[static_cast<std::size_t>(node)]) = old.row(node);
    for (Index& node : body.mesh.cells.reshaped())
      if (node >= 0) node = place[static_cast<std::size_t>(node)];
    result.place.push_back(place);
  }
  return result;
}

}  // namespace signorini_test
