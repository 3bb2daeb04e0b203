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

namespace {

// Rows of bodies that have moved by \f$ \hat u \f$ are tangents there. A gap that is seen there belongs to
// \f$ \hat u \f$, so that the number without any displacement is \f$ g - N\hat u \f$, and likewise of the
// slip. A rigid obstacle stands still: what a node has moved since the last step is its slip.
void count_from_the_meshes(const Standing& standing, Pairs& pairs) {
  const auto flat = [](const NodeArray& all) {
    return Eigen::Map<const Eigen::VectorXd>(all.data(), all.size());
  };
  pairs.initial_gap -= pairs.opening * flat(standing.displacement);
  if (pairs.sliding.nonZeros() == 0) return;
  if (pairs.slid.size() == 0) pairs.slid = pairs.sliding * flat(standing.since);
  pairs.slid -= pairs.sliding * flat(standing.displacement);
}

Pairs pairs_of(const ContactSpec& contact, const std::vector<BodyModel>& bodies,
               const GapOptions& options) {
  const Surface source = surface(bodies, contact.source);
  if (const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target))
    return node_to_obstacle(source, *obstacle, options);
  const Side& side = std::get<Side>(contact.target);
  const Depth other = depth_of(bodies[body_index(bodies, side)].material);
  require_input(options.depth.factor == other.factor, describe(bodies, contact), ": the bodies are ",
                options.depth.factor, " and ", other.factor,
                " thick, but contact in the plane needs one thickness");
  return find_gap_operator(contact.gap_operator).pair(source, surface(bodies, side), options);
}

}  // namespace

// A rigid obstacle has a formula for gap and normal, and needs no search. Two bodies are paired by the
// operator of the scene. They must have one thickness. Otherwise the same pressure would be one force
// on the source and another one on the target, and the two would not balance.
Pairs pair_up(const ContactSpec& contact, const std::vector<BodyModel>& bodies, bool sliding,
              const Standing* standing) {
  const Depth depth = depth_of(bodies[body_index(bodies, contact.source)].material);
  GapOptions options{count_nodes(bodies), depth, sliding, contact.points, contact.quadrature};
  if (standing != nullptr) options.before = &standing->before;
  Pairs pairs = pairs_of(contact, bodies, options);
  if (standing != nullptr) count_from_the_meshes(*standing, pairs);
  return pairs;
}

}  // namespace signorini
