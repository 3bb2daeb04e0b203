// Layers and temperature: what assembly and stresses read from the material of a body.
#include <algorithm>
#include <cmath>
#include <string>

#include "addons/effects/layers.hpp"
#include "addons/effects/thermal.hpp"
#include "meshes/regions.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/fem/strain_law.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini::effect {
namespace {

bool same(const Material& a, const Material& b) {
  return a.youngs_modulus == b.youngs_modulus && a.poisson_ratio == b.poisson_ratio &&
         a.state == b.state && a.thickness == b.thickness && a.expansion == b.expansion && a.law == b.law;
}

bool has_layers(const Body& body) {
  return std::any_of(body.layers.begin(), body.layers.end(),
                     [&](const Layer& layer) { return !same(layer.material, body.material); });
}

std::string law_of(const Material& material) {
  return material.law == nullptr ? "" : text(", law ", material.law->name);
}

/// Also of a layer that changes nothing: its name may be mistyped.
void check_regions(const Scene& scene) {
  for (const Body& body : scene.bodies)
    for (const Layer& layer : body.layers) static_cast<void>(region(body.mesh, layer.region));
}

void declare_layers(const Scene& scene, Plan& draft) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    if (!has_layers(body)) continue;
    draft.bodies[b].material = layered(body.mesh, body.material, body.layers);
    for (const Layer& layer : body.layers)
      draft.on.push_back(text("layer '", layer.region, "' of '", body.mesh.name,
                              "': ", region(body.mesh, layer.region).size(), " cells, E ",
                              layer.material.youngs_modulus, ", nu ",
                              layer.material.poisson_ratio, law_of(layer.material)));
  }
}

bool is_warm(const Body& body) { return body.temperature && body.temperature->nonzero(); }

bool expands(const MaterialField& field) {
  return field.base.expansion != 0 ||
         std::any_of(field.others.begin(), field.others.end(),
                     [](const Material& other) { return other.expansion != 0; });
}

void declare_temperature(const Scene& scene, Plan& draft) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!is_warm(scene.bodies[b])) continue;
    const Temperature& temperature = *scene.bodies[b].temperature;
    const std::string what = text("temperature of '", draft.bodies[b].mesh.name, "'");
    require_input(std::isfinite(temperature.uniform) && temperature.gradient.allFinite(), what,
                  ": must be finite, got ", temperature.uniform, " and the gradient (",
                  temperature.gradient.x(), ", ", temperature.gradient.y(), ')');
    MaterialField& field = draft.bodies[b].material;
    require_input(
        expands(field), what,
        ": its material does not expand; give it a thermal expansion, or leave the temperature "
        "out");
    field.eigenstrain = expansion(temperature);
    std::string line = text(what, ": ", temperature.uniform, " more than without stress");
    if ((temperature.gradient.array() != 0).any())
      line += text(" at the origin, with the gradient (", temperature.gradient.x(), ", ",
                   temperature.gradient.y(), ')');
    if (temperature.varying) line += ", and what varies on top of that";
    draft.on.push_back(line);
    double most = 0;
    std::vector<Material> materials = field.others;
    materials.push_back(field.base);
    for (const Material& material : materials)
      for (Eigen::Index node = 0; node < draft.bodies[b].mesh.n_nodes(); ++node)
        most = std::max(most, std::abs(material.expansion *
                                       temperature.at(draft.bodies[b].mesh.nodes.row(node))));
    if (most > SmallLimits().strain)
      draft.notes.push_back(text(what, ": free expansion alone is a strain of ", 100 * most,
                                 " %, which is not small; check the units of both"));
  }
}

}  // namespace

Effect layers() {
  return {"layers",
          [](const Scene& scene, const Plan& /*draft*/) {
            check_regions(scene);
            return std::any_of(scene.bodies.begin(), scene.bodies.end(), has_layers);
          },
          declare_layers, nullptr};
}

Effect temperature() {
  return {"temperature",
          [](const Scene& scene, const Plan& /*draft*/) {
            return std::any_of(scene.bodies.begin(), scene.bodies.end(), is_warm);
          },
          declare_temperature, nullptr};
}

}  // namespace signorini::effect
