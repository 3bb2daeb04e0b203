#include "signorini/mesh/hertz_meshes.hpp"

namespace signorini {

PressedDiscSpec HertzMeshSpec::disc_spec() const {
  PressedDiscSpec spec;
  spec.radius = radius;
  spec.core = Eigen::Vector2d::Constant(core);
  spec.core_columns = disc_cells;
  spec.core_rows = disc_rows;
  spec.layers = disc_layers;
  spec.layer_grading = layer_grading;
  spec.order = order;
  return spec;
}

HalfSpaceSpec HertzMeshSpec::plate_spec() const {
  HalfSpaceSpec spec;
  spec.name = "plate";
  spec.width = plate.x();
  spec.depth = plate.y();
  spec.core = Eigen::Vector2d::Constant(plate_core * core);
  spec.core_columns = plate_cells;
  spec.core_rows = plate_rows;
  spec.layers = plate_layers;
  spec.layer_grading = layer_grading;
  spec.order = order;
  return spec;
}

HertzMeshes make_hertz_meshes(const HertzMeshSpec& spec) {
  return {make_pressed_disc(spec.disc_spec()), make_half_space(spec.plate_spec())};
}

}  // namespace signorini
