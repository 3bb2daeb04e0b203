#include "meshes/hertz_meshes.hpp"

#include "meshes/disc.hpp"
#include "meshes/half_space.hpp"

namespace signorini {

HertzMeshes make_hertz_meshes(const HertzMeshSpec& spec) {
  PressedDiscSpec disc;
  disc.radius = spec.radius;
  disc.core.setConstant(spec.core);
  disc.core_columns = spec.disc_cells;
  disc.core_rows = spec.disc_rows;
  disc.layers = spec.disc_layers;
  HalfSpaceSpec plate;
  plate.name = "plate";
  plate.width = spec.plate.x();
  plate.depth = spec.plate.y();
  plate.core.setConstant(spec.plate_core * spec.core);
  plate.core_columns = spec.plate_cells;
  plate.core_rows = spec.plate_rows;
  plate.layers = spec.plate_layers;
  disc.layer_grading = plate.layer_grading = spec.layer_grading;
  disc.order = plate.order = spec.order;
  return {make_pressed_disc(disc), make_half_space(plate)};
}

}  // namespace signorini
