// Relations that hold up to a number, as contact does. What is left to the number is the gap of a pair; at 0 a force that never
// pulls acts on all terms at once. To solvers and certificates such a pair is one of a contact.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "signorini/core/index.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/pair_up.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// Areas of nodes of a side. A node without area, as on the axis, gets the mean of all, so that its pressure is a number.
VectorXd areas_of(const std::vector<Index>& nodes, const BodyModel& body,
                  const std::string& boundary) {
  const VectorXd share = boundary_weights(body.mesh, boundary, depth_of(body.material));
  const std::vector<Index> on_side = boundary_nodes(body.mesh, boundary);
  VectorXd areas = VectorXd::Constant(static_cast<Index>(nodes.size()), share.mean());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (std::size_t j = 0; j < on_side.size(); ++j)
      if (on_side[j] == nodes[k] - body.first_node && share(static_cast<Index>(j)) > 0)
        areas(static_cast<Index>(k)) = share(static_cast<Index>(j));
  return areas;
}

/// The pairs before supports, in displacements of the first term: whatever it is multiplied by, gaps are lengths, normals have the
/// length 1, and forces are those on the first term. \param sign  of the sum in the gap \param nodes  of the first term, one for each row
Pairs pairs_of(const Relation& relation, double sign, const std::vector<Equation>& rows,
               const std::vector<Index>& nodes, const Plan& draft) {
  const RelationTerm& first = relation.terms.front();
  const BodyModel& body = draft.bodies[body_index(draft.bodies, first.side)];
  const Index count = static_cast<Index>(rows.size());
  Pairs pairs;
  const Eigen::Vector2d along = first.times * first.along;
  const double factor = sign / along.norm();
  pairs.opening = factor * matrix_of(rows, draft.gaps.pairs.opening.cols());
  pairs.sliding.resize(draft.gaps.T.rows() > 0 ? count : 0, draft.gaps.pairs.opening.cols());
  pairs.initial_gap = VectorXd::Constant(count, -factor * relation.right);
  pairs.weight = areas_of(nodes, body, first.side.boundary);
  pairs.position.resize(count, 2);
  for (Index k = 0; k < count; ++k)
    pairs.position.row(k) = body.mesh.nodes.row(nodes[at(k)] - body.first_node);
  pairs.normal = (factor * along).transpose().replicate(count, 1);
  pairs.moment = pairs.target_moment = NodeArray::Zero(count, 2);
  pairs.node = nodes;
  return pairs;
}

/// What supports leave of them: rows that nothing can move are left out with those that equations hold.
Gaps gaps_of(Pairs pairs, const Plan& draft) {
  Gaps gaps;
  gaps.A = -free_columns(pairs.opening, draft.unknowns);
  gaps.T.resize(pairs.sliding.rows(), draft.unknowns.count);
  gaps.initial_slip = VectorXd::Zero(pairs.sliding.rows());
  pairs.initial_gap += pairs.opening * draft.unknowns.held.reshaped<Eigen::RowMajor>();
  gaps.pairs = std::move(pairs);
  return gaps;
}

}  // namespace

NodalRows matrix_of(const std::vector<Equation>& rows, Index components) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const auto& [component, value] : rows[k].terms)
      entries.emplace_back(static_cast<int>(k), static_cast<int>(component), value);
  NodalRows matrix(static_cast<Index>(rows.size()), components);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void add_one_sided(const Relation& relation, const std::string& name, const std::vector<Equation>& rows,
                   const std::vector<Index>& nodes, Plan& draft) {
  const double sign = relation.holds == Holds::AtMost ? -1 : 1;
  std::vector<Index> own = nodes;
  own.resize(rows.size(), nodes.front());
  Gaps gaps = gaps_of(pairs_of(relation, sign, rows, own, draft), draft);
  const Side& side = relation.terms.front().side;
  if (draft.followed) {
    std::vector<FollowedContact> followed = *draft.followed;
    ContactSpec contact;
    contact.source = side;
    FollowedContact own_gaps{contact, gaps.pairs.initial_gap};
    own_gaps.linear = true;
    followed.push_back(std::move(own_gaps));
    draft.followed = std::make_shared<const std::vector<FollowedContact>>(std::move(followed));
  }
  draft.contact_of.resize(draft.contact_of.size() + rows.size(), draft.contacts.size());
  draft.contacts.push_back(name);
  ContactBodies bodies{body_index(draft.bodies, side), {}};
  bodies.acts_elsewhere = true;
  draft.contact_bodies.push_back(bodies);
  draft.small_sliding.push_back(false);
  draft.gaps = stacked(draft.gaps, gaps);
}

}  // namespace signorini
