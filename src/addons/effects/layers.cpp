#include "addons/effects/layers.hpp"

#include "meshes/regions.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {

MaterialField layered(const Mesh& mesh, const Material& base, const std::vector<Layer>& layers) {
  MaterialField field(base);
  field.number_of.resize(static_cast<std::size_t>(mesh.n_cells()), 0);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const Layer& layer = layers[k];
    const std::string what = text("layer '", layer.region, "' of '", mesh.name, "': ");
    require_input(layer.material.state == base.state, what,
                  "its plane state is not that of the body");
    require_input(layer.material.thickness == base.thickness, what,
                  "its thickness must be that of the body, ", base.thickness, ", got ",
                  layer.material.thickness);
    try {
      check_material(layer.material);
    } catch (const ProblemError& error) {
      throw ProblemError(what + error.what());
    }
    field.others.push_back(layer.material);
    for (const Eigen::Index cell : region(mesh, layer.region)) {
      std::size_t& number = field.number_of[static_cast<std::size_t>(cell)];
      require_input(number == 0, what, "cell ", cell, " is in the layer '",
                    layers[number == 0 ? 0 : number - 1].region, "' as well");
      number = k + 1;
    }
  }
  return field;
}

}  // namespace signorini
