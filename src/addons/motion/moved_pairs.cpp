// # Pairs where the bodies are
//
// A linear gap follows the normal that a pair has in the mesh. Slide a node by s along a disc of radius R,
// and that gap is wrong by \f$ s^2/2R \f$. So the pairs are found again where the bodies stand, by the effects that
// found them first: contact, friction and cohesion declare and add once more, to a draft whose meshes have moved.
//
// Positions are doubles, and \f$ \hat x = X + u \f$ is rounded. The displacement that belongs to it is
// \f$ \hat u = \hat x - X \f$, not u: so the gap of u is right to first order in what rounding took.

#include "addons/motion/moved_pairs.hpp"

#include <memory>
#include <string>

#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Bodies that stand elsewhere as long as this lives, for a draft; their model gets them back as they were.
class BodiesThere {
 public:
  BodiesThere(Model& model, const NodeArray& places, Plan& draft) : model_(model), draft_(draft) {
    draft.bodies.swap(model.bodies);
    for (BodyModel& body : draft.bodies) {
      NodeArray there = places.middleRows(body.first_node, body.mesh.n_nodes());
      body.mesh.nodes.swap(there);
      still_.push_back(std::move(there));
    }
  }
  ~BodiesThere() {
    for (std::size_t b = 0; b < still_.size(); ++b) draft_.bodies[b].mesh.nodes.swap(still_[b]);
    draft_.bodies.swap(model_.bodies);
  }
  BodiesThere(const BodiesThere&) = delete;
  BodiesThere& operator=(const BodiesThere&) = delete;
  BodiesThere(BodiesThere&&) = delete;
  BodiesThere& operator=(BodiesThere&&) = delete;

 private:
  Model& model_;
  Plan& draft_;
  std::vector<NodeArray> still_;
};

NodeArray nodes_of(const std::vector<BodyModel>& bodies) {
  NodeArray nodes(count_nodes(bodies), 2);
  for (const BodyModel& body : bodies)
    nodes.middleRows(body.first_node, body.mesh.n_nodes()) = body.mesh.nodes;
  return nodes;
}

Eigen::Map<const Eigen::VectorXd> flat(const NodeArray& all) { return {all.data(), all.size()}; }

/// A rigid obstacle stands still: what a node has moved since the last step is its slip.
std::string slide_along_obstacles(const Standing& standing, Pairs& pairs) {
  if (pairs.slid.size() == 0 && pairs.sliding.nonZeros() > 0)
    pairs.slid = pairs.sliding * flat(standing.since);
  return {};
}

/// What supports still have to move: given displacements are counted from where the bodies stand.
Unknowns from_there(Unknowns unknowns, const NodeArray& displacement) {
  unknowns.held = (unknowns.number < 0).select(unknowns.held - displacement, 0);
  return unknowns;
}

/// Rows of bodies that have moved by \f$ \hat u \f$ are tangents there. A gap that is seen there belongs to \f$ \hat u \f$, so
/// that the number without any displacement is \f$ g + A\hat u \f$, and that of the slip \f$ s - T\hat u \f$.
void count_from_the_meshes(const NodeArray& displacement, const Unknowns& unknowns, Gaps& gaps) {
  const Eigen::VectorXd u = restricted(unknowns, displacement);
  gaps.pairs.initial_gap += gaps.A * u;
  if (gaps.T.rows() > 0) gaps.initial_slip -= gaps.T * u;
}

}  // namespace

void place_bodies(const Scene& scene, const NodeArray& displacement, const NodeArray& before,
                  Model& model, bool keep_points) {
  const NodeArray still = nodes_of(model.bodies);
  const NodeArray now = still + displacement;
  const NodeArray earlier = still + before;
  Plan draft;
  draft.standing =
      std::make_shared<const Standing>(Standing{now - still, earlier, now - earlier, keep_points});
  draft.fits = {[&standing = *draft.standing](const ContactSpec& /*contact*/, Pairs& pairs) {
    return slide_along_obstacles(standing, pairs);
  }};
  draft.unknowns = from_there(model.unknowns, draft.standing->displacement);
  draft.gaps.A.resize(0, model.unknowns.count);
  draft.gaps.pairs.opening.resize(0, still.size());
  draft.gaps.pairs.sliding.resize(0, still.size());
  {
    const BodiesThere there(model, now, draft);
    for (const Effect* effect : model.effects)
      if (effect->of_pairs) effect->declare(scene, draft);
  }
  count_from_the_meshes(draft.standing->displacement, draft.unknowns, draft.gaps);
  model.standing = std::move(draft.standing);
  model.gaps = std::move(draft.gaps);
  model.contact_of = std::move(draft.contact_of);
  model.law = std::move(draft.law);
  for (const Effect* effect : model.effects)
    if (effect->of_pairs) effect->add(model);
  model.gaps = {};
}

std::vector<PairName> names_of_pairs(const Model& model) {
  std::vector<PairName> names;
  for (std::size_t pair = 0; pair < model.contact_of.size(); ++pair)
    names.emplace_back(model.contact_of[pair], model.pairs.node[pair]);
  return names;
}

std::vector<ContactStatus> handed_on(const std::vector<PairName>& names,
                                     const std::vector<ContactStatus>& statuses,
                                     const Model& model) {
  if (statuses.size() != names.size()) return {};
  std::map<PairName, ContactStatus> known;
  for (std::size_t k = 0; k < names.size(); ++k) known.emplace(names[k], statuses[k]);
  std::vector<ContactStatus> here;
  for (const PairName& name : names_of_pairs(model)) {
    const auto found = known.find(name);
    here.push_back(found == known.end() ? ContactStatus::Open : found->second);
  }
  return here;
}

}  // namespace signorini
