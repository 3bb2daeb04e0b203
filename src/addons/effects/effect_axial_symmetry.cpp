#include <algorithm>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini::effect {
namespace {

bool is_axial(const Body& body) { return body.material.state == PlaneState::Axial; }

/// A side that lies on the axis has no area.
void check_side(const Plan& draft, const Side& side) {
  const Mesh& mesh = draft.bodies[body_index(draft.bodies, side)].mesh;
  const std::vector<Eigen::Index> axis = axis_nodes(mesh);
  const auto on_axis = [&axis](Eigen::Index node) {
    return std::binary_search(axis.begin(), axis.end(), node);
  };
  for (const CellSide& part : boundary(mesh, side.boundary)) {
    const std::vector<Eigen::Index> nodes = mesh.side_nodes(part);
    require_input(
        !on_axis(nodes.front()) || !on_axis(nodes.back()), "contact on '", side.boundary, "' of '",
        mesh.name,
        "': it lies on the axis x = 0, where a body of revolution has no surface; leave it out");
  }
}

/// What is added is nothing but a factor: every integral asks depth_of() a material for it, and numbering the
/// unknowns has held what lies on the axis.
void declare_revolution(const Scene& scene, Plan& draft) {
  for (const Body& body : scene.bodies) {
    require_input(is_axial(body), "body '", body.mesh.name,
                  "' is plane, but another body of the scene is axially symmetric: all must be");
    draft.on.push_back(text("axial symmetry of '", body.mesh.name,
                            "': x is the radius, forces are those of the whole circle, ",
                            axis_nodes(body.mesh).size(), " nodes on the axis"));
  }
  for (const ContactSpec& contact : scene.contacts) {
    check_side(draft, contact.source);
    if (const Side* target = std::get_if<Side>(&contact.target)) check_side(draft, *target);
  }
}

}  // namespace

Effect axial_symmetry() {
  return {"axial symmetry",
          [](const Scene& scene, const Plan& /*draft*/) {
            return std::any_of(scene.bodies.begin(), scene.bodies.end(), is_axial);
          },
          declare_revolution, nullptr};
}

}  // namespace signorini::effect
