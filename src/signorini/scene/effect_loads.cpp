#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini::effect {
namespace {

void add_load(const BodyModel& body, const Loads& loads, Eigen::VectorXd& load) {
  add_nodal_forces(body, nodal_loads(body.mesh, body.element, body.material, loads), load);
}

bool has_weight(const Body& body) { return static_cast<bool>(body.loads.body_force); }

bool has_edge_loads(const Body& body) { return !body.loads.edges.empty(); }

bool pulls(const PointForce& load) { return (load.force.array() != 0).any(); }

bool has_point_forces(const Body& body) {
  return std::any_of(body.loads.points.begin(), body.loads.points.end(), pulls);
}

std::string describe(const EdgePlace& place) {
  if (place.nodes.size() == 1) return text("node ", place.nodes.front());
  return text("the side from node ", place.nodes.front(), " to ", place.nodes.back());
}

}  // namespace

Effect body_force() {
  return {"body force",
          [](const Scene& scene, const Plan& /*draft*/) {
            return std::any_of(scene.bodies.begin(), scene.bodies.end(), has_weight);
          },
          [](const Scene& scene, Plan& draft) {
            for (const Body& body : scene.bodies)
              if (has_weight(body)) draft.on.push_back("body force on '" + body.mesh.name + "'");
          },
          [](Model& model) {
            for (const BodyModel& body : model.bodies)
              add_load(body, {body.loads.body_force, {}, {}}, model.programme.load);
          }};
}

Effect edge_loads() {
  return {"edge loads",
          [](const Scene& scene, const Plan& /*draft*/) {
            return std::any_of(scene.bodies.begin(), scene.bodies.end(), has_edge_loads);
          },
          [](const Scene& scene, Plan& draft) {
            for (const Body& body : scene.bodies)
              for (const EdgeLoad& load : body.loads.edges) {
                static_cast<void>(boundary(body.mesh, load.boundary));
                require_input(std::isfinite(load.pressure), "load on '", load.boundary,
                              "': the pressure ", load.pressure,
                              " is not finite, but it must be a number");
                draft.on.push_back("load on '" + load.boundary + "' of '" + body.mesh.name + "'");
              }
          },
          [](Model& model) {
            for (const BodyModel& body : model.bodies)
              add_load(body, {{}, body.loads.edges, {}}, model.programme.load);
          }};
}

Effect point_forces() {
  return {"point forces",
          [](const Scene& scene, const Plan& /*draft*/) {
            return std::any_of(scene.bodies.begin(), scene.bodies.end(), has_point_forces);
          },
          [](const Scene& scene, Plan& draft) {
            for (const Body& body : scene.bodies) {
              auto load = body.loads.points.begin();
              for (const EdgePlace& place : places_of(body.mesh, body.loads.points)) {
                if (!place.nodes.empty())
                  draft.on.push_back(text("force (", load->force.x(), ", ", load->force.y(),
                                          ") on ", describe(place), " of '", body.mesh.name, "'"));
                ++load;
              }
            }
          },
          [](Model& model) {
            for (const BodyModel& body : model.bodies)
              add_load(body, {{}, {}, body.loads.points}, model.programme.load);
          }};
}

}  // namespace signorini::effect
