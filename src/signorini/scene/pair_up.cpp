// # The pairs of a contact
//
// A candidate pair is a point of the source and the place on the target that it faces. pair_up() finds
// the pairs in the meshes, before anything moves. From there on a gap is linear in the displacements,
// \f$ g + Nu \f$.

#include "signorini/scene/pair_up.hpp"

#include "signorini/contact/node_to_obstacle.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {

// A rigid obstacle has a formula for gap and normal, and needs no search. Two bodies are paired by the
// operator of the scene. They must have one thickness. Otherwise the same pressure would be one force
// on the source and another one on the target, and the two would not balance.
//
// Where bodies have moved in a step, the meshes are those of moved bodies, and what the nodes have moved comes along.
Pairs pair_up(const ContactSpec& contact, const std::vector<BodyModel>& bodies, bool sliding,
              const Standing* standing) {
  const Surface source = surface(bodies, contact.source);
  const Depth depth = depth_of(bodies[body_index(bodies, contact.source)].material);
  GapOptions options{count_nodes(bodies), depth, sliding, contact.points, contact.quadrature};
  if (standing != nullptr) {
    options.since = &standing->since;
    options.reach = standing->reach;
  }
  if (const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target))
    return node_to_obstacle(source, *obstacle, options);
  const Side& side = std::get<Side>(contact.target);
  const Depth other = depth_of(bodies[body_index(bodies, side)].material);
  require_input(depth.factor == other.factor, describe(bodies, contact), ": the bodies are ",
                depth.factor, " and ", other.factor,
                " thick, but contact in the plane needs one thickness");
  return find_gap_operator(contact.gap_operator).pair(source, surface(bodies, side), options);
}

}  // namespace signorini
