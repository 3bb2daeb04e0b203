#include <cmath>

#include "closed_form/hertz_fit.hpp"
#include "exercise.hpp"
#include "meshes/half_space.hpp"
#include "meshes/reshape.hpp"

namespace ex11_2 {

using namespace signorini;

Scene wedge_on_plate(const Wedge& wedge) {
  HalfSpaceSpec spec;
  spec.name = "plate";
  spec.width = spec.depth = wedge.size;
  spec.core = Eigen::Vector2d::Constant(wedge.core);
  spec.core_columns = wedge.cells;
  spec.core_rows = 3 * wedge.cells / 4;
  spec.layers = 16;
  spec.layer_grading = 3;
  Scene scene;
  scene.bodies.resize(2);
  Body& above = scene.bodies[0];
  Body& plate = scene.bodies[1];
  plate.mesh = make_half_space(spec);
  above.mesh = mapped(mirrored(plate.mesh, MirrorLine::Level), [&](const Eigen::Vector2d& x) {
    return Eigen::Vector2d(x.x(), x.y() + wedge.slope * x.x() * (1 - x.y() / wedge.size));
  });
  above.mesh.name = "wedge";
  for (Body* body : {&above, &plate}) {
    body->material = {wedge.modulus, wedge.ratio, PlaneState::Strain, 1};
    body->supports = {symmetric("axis")};
  }
  above.loads.edges = {{"base", wedge.load / (2 * wedge.size), {}}};
  plate.supports.push_back(fixed("base"));
  scene.contacts = {{{"surface", "wedge"}, Side{"surface", "plate"}}};
  return scene;
}

// The integral of arcosh(a/x) from 0 to a is pi a / 2, that of x^2 arcosh(a/x) pi a^3 / 12: the share is
// 1/6 of a^2, that of an ellipse 1/4 of b^2.
double wedge_half_width(const Eigen::VectorXd& position, const Eigen::VectorXd& force) {
  return std::sqrt(1.5) * half_width_of_forces({position.data(), position.data() + position.size()},
                                               {force.data(), force.data() + force.size()});
}

}  // namespace ex11_2
