#include "addons/estimate/contact_edges.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

std::size_t source_index(const Model& model, Index pair) {
  return body_of_node(model.bodies, model.pairs.node[at(pair)]);
}

const BodyModel& source_of(const Model& model, Index pair) {
  return model.bodies[source_index(model, pair)];
}

namespace {

/// Whether a pair presses on no node of its source but its own.
bool presses_one_node(const Model& model, const BodyModel& source, Index pair) {
  const Index own = model.pairs.node[at(pair)];
  for (NodalRows::InnerIterator entry(model.pairs.opening, pair); entry; ++entry) {
    const Index node = entry.col() / 2;
    const bool of_source =
        node >= source.first_node && node < source.first_node + source.mesh.n_nodes();
    if (of_source && node != own && entry.value() != 0) return false;
  }
  return true;
}

/// The side of a body that two neighbouring nodes of it belong to, in either order.
using SidesByNodes = std::map<std::pair<Index, Index>, CellSide>;

SidesByNodes sides_by_nodes(const Mesh& mesh) {
  SidesByNodes sides;
  for (const auto& [name, list] : mesh.boundaries)
    for (const CellSide& side : list) {
      const std::vector<Index> nodes = mesh.side_nodes(side);
      for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        sides.insert({{nodes[k], nodes[k + 1]}, side});
        sides.insert({{nodes[k + 1], nodes[k]}, side});
      }
    }
  return sides;
}

}  // namespace

std::vector<char> meshed_contacts(const Model& model) {
  std::vector<char> meshed(model.contacts.size(), 0);
  for (Index pair = 0; pair < model.pairs.opening.rows(); ++pair) {
    const BodyModel& source = source_of(model, pair);
    char& own = meshed[model.contact_of[at(pair)]];
    for (NodalRows::InnerIterator entry(model.pairs.opening, pair); entry; ++entry) {
      const Index node = entry.col() / 2 - source.first_node;
      if (node < 0 || node >= source.mesh.n_nodes()) own = 1;
    }
  }
  return meshed;
}

std::vector<ContactEdge> contact_edges(const Model& model) {
  std::vector<SidesByNodes> sides;
  for (const BodyModel& body : model.bodies) sides.push_back(sides_by_nodes(body.mesh));
  std::vector<ContactEdge> edges;
  const auto join = [&](Index first, Index second) {
    const std::size_t b = source_index(model, first);
    const BodyModel& body = model.bodies[b];
    const auto node = [&](Index pair) { return model.pairs.node[at(pair)] - body.first_node; };
    const auto side = sides[b].find({node(first), node(second)});
    if (side == sides[b].end()) return;
    const Eigen::RowVector2d from = model.pairs.position.row(first);
    const Eigen::RowVector2d to = model.pairs.position.row(second);
    edges.push_back(
        {first, second, side->second, (to - from).norm(),
         depth_of(body.material).at((from.x() + to.x()) / 2), body.mesh.order(),
         body.mesh.order() == MeshOrder::Linear || !presses_one_node(model, body, first)});
  };
  const Index count = model.pairs.weight.size();
  Index begin = 0;  // of the contact
  for (Index pair = 0; pair < count; ++pair) {
    const std::size_t contact = model.contact_of[at(pair)];
    const bool last = pair + 1 == count || model.contact_of[at(pair + 1)] != contact;
    if (!last) join(pair, pair + 1);
    if (last && pair - begin > 1) join(pair, begin);  // as on a closed ring
    if (last) begin = pair + 1;
  }
  return edges;
}

double gap_between_nodes(const Model& model, const std::vector<ContactEdge>& edges,
                         const VectorXd& force) {
  const VectorXd& gap = model.pairs.initial_gap;
  VectorXd curvature = VectorXd::Zero(gap.size());  // at the pairs
  Eigen::VectorXi known = Eigen::VectorXi::Zero(gap.size());
  std::vector<const ContactEdge*> ending(at(gap.size()), nullptr);
  for (const ContactEdge& edge : edges) ending[at(edge.to)] = &edge;
  for (const ContactEdge& after : edges) {
    const ContactEdge* const before = ending[at(after.from)];
    if (before == nullptr) continue;
    curvature(after.from) = 2 / (before->length + after.length) *
                            ((gap(after.to) - gap(after.from)) / after.length -
                             (gap(before->to) - gap(before->from)) / before->length);
    known(after.from) = 1;
  }
  const std::vector<char> meshed = meshed_contacts(model);
  double sum = 0;
  for (const ContactEdge& edge : edges) {
    if (meshed[model.contact_of[at(edge.from)]] != 0) continue;
    const int ends = known(edge.from) + known(edge.to);
    if (edge.order == MeshOrder::Quadratic || ends == 0) continue;
    const double bend = (curvature(edge.from) + curvature(edge.to)) / ends;
    const double mu = (force(edge.from) / model.pairs.weight(edge.from) +
                       force(edge.to) / model.pairs.weight(edge.to)) /
                      2;
    sum -= std::pow(edge.length, 3) / 12 * bend * mu * edge.depth;
  }
  return sum;
}

}  // namespace signorini
