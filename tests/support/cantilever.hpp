// The cantilever above a rigid flat foundation (Xuan & Li 2002, section 4, example 2) as a scene.
#pragma once
#include <Eigen/Core>
#include <string>

#include "meshes/block.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/scene/scene.hpp"
#include "support/meshes.hpp"

namespace signorini_test {

/// Units of the scene: how many of them make 1 cm and 1 kN.
struct Units {
  double length = 1;
  double force = 1;
};

inline signorini::Scene cantilever(const std::string& element, Eigen::Index cells_x,
                                   Eigen::Index cells_y, double pressure = 3.6,
                                   const Units& units = {}) {
  const double area = units.length * units.length;
  signorini::BlockSpec spec;
  spec.name = "beam";
  spec.size = units.length * Eigen::Vector2d(50, 5);
  spec.cells_x = cells_x;
  spec.cells_y = cells_y;
  const signorini::Element& cell = signorini::find_element(element);
  spec.order = order_of(cell);
  signorini::Scene scene;
  signorini::Body& body = scene.bodies[0];
  body.mesh = fitting(signorini::make_block(spec), cell);
  body.element = element;
  body.material = {2.1e4 * units.force / area, 0.29, signorini::PlaneState::Stress, units.length};
  body.supports = {signorini::fixed("left")};
  body.loads.edges.push_back({"top", pressure * units.force / area, {}});
  scene.contacts = {{{"bottom"}, signorini::half_plane({0, -units.length}, {0, 1})}};
  return scene;
}

}  // namespace signorini_test
