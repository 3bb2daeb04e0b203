// # Loads as effects
//
// Loads give one vector p, the right side of \f$ Ku = p \f$. There are three kinds: a force
// per volume, a pressure on a boundary, and a force at a point. Each is made of nodal forces
// that do the same work as the load,
// \f[ p_i = \int_\Omega N_i\, b\, d\Omega + \int_\Gamma N_i\, t\, d\Gamma + N_i(x)\, F. \f]
// An example: a side of length 2 with two nodes and thickness 1, under the pressure 3, gives
// each node a force of 3 against the body. A force of 8 a quarter of the way along the side
// gives 6 to the near node and 2 to the far one.
//
// The three are effects of their own, so that the plan has a line for each and says which
// are off.

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini::effect {
namespace {

// Forces on held components go into the supports and not into p: add_nodal_forces() drops
// them.
void add_load(const BodyModel& body, const Loads& loads, Eigen::VectorXd& load) {
  add_nodal_forces(body, nodal_loads(body.mesh, body.element, body.material, loads), load);
}

// An effect is asked first whether the scene has it. The answer must cost nothing, so no
// mesh is touched. A body force counts as present if it is given, even if it is zero: it is
// a function of the place.
bool has_weight(const Body& body) { return static_cast<bool>(body.loads.body_force); }

bool has_edge_loads(const Body& body) { return !body.loads.edges.empty(); }

// A force of zero is no force, so that a table of loads may have zeros in it.
bool pulls(const PointForce& load) { return (load.force.array() != 0).any(); }

bool has_point_forces(const Body& body) {
  return std::any_of(body.loads.points.begin(), body.loads.points.end(), pulls);
}

// A point force acts on the node at its place, or on the nodes of the side that it lies on.
// The plan says which, so that a reader sees where the force went.
std::string describe(const EdgePlace& place) {
  if (place.nodes.size() == 1) return text("node ", place.nodes.front());
  return text("the side from node ", place.nodes.front(), " to ", place.nodes.back());
}

}  // namespace

// Nothing can be wrong with a body force before it is evaluated, so the plan only tells it.
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

// A wrong name of a boundary or a pressure that is not a number is refused in the plan,
// before anything is assembled.
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

// The place is looked up already in the plan: a point off the edge is an error, and the user
// should see which nodes get the force. The list of places has an entry for every force,
// empty for a force of zero.
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
