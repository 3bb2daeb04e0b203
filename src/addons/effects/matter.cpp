#include "addons/effects/matter.hpp"

#include "signorini/core/errors.hpp"
#include "signorini/fem/regions.hpp"

namespace signorini {

Matter layered(const Mesh& mesh, const Material& bulk, const std::vector<Layer>& layers) {
  Matter matter(bulk);
  matter.layer_of.resize(static_cast<std::size_t>(mesh.n_cells()), 0);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const Layer& layer = layers[k];
    const std::string what = text("layer '", layer.region, "' of '", mesh.name, "': ");
    pose(layer.material.state == bulk.state, what, "its plane state is not that of the body");
    pose(layer.material.thickness == bulk.thickness, what,
         "its thickness must be that of the body, ", bulk.thickness, ", got ",
         layer.material.thickness);
    try {
      check_material(layer.material);
    } catch (const ProblemError& error) {
      throw ProblemError(what + error.what());
    }
    matter.layers.push_back(layer.material);
    for (const Eigen::Index cell : region(mesh, layer.region)) {
      std::size_t& layer_of = matter.layer_of[static_cast<std::size_t>(cell)];
      pose(layer_of == 0, what, "cell ", cell, " is in the layer '",
           layers[layer_of == 0 ? 0 : layer_of - 1].region, "' as well");
      layer_of = k + 1;
    }
  }
  return matter;
}

}  // namespace signorini
