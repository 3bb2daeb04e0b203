#include "signorini/estimate/contact_edges.hpp"

#include <cmath>

#include "signorini/elasticity/matter.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

const BodyModel& source_of(const Model& model, Index pair) {
  const Index node = model.pairs.node[static_cast<std::size_t>(pair)];
  auto body = model.bodies.end();
  while ((--body)->first_node > node) {
  }
  return *body;
}

namespace {

/// Whether a pair presses on no node of its source but its own.
bool presses_one_node(const Model& model, const BodyModel& source, Index pair) {
  const Index own = model.pairs.node[static_cast<std::size_t>(pair)];
  for (NodalRows::InnerIterator entry(model.pairs.opening, pair); entry; ++entry) {
    const Index node = entry.col() / 2;
    const bool of_source =
        node >= source.first_node && node < source.first_node + source.mesh.n_nodes();
    if (of_source && node != own && entry.value() != 0) return false;
  }
  return true;
}

}  // namespace

std::vector<ContactEdge> contact_edges(const Model& model) {
  std::vector<ContactEdge> edges;
  for (Index pair = 0; pair + 1 < model.pairs.weight.size(); ++pair) {
    const auto k = static_cast<std::size_t>(pair);
    if (model.contact_of[k] != model.contact_of[k + 1]) continue;
    const BodyModel& body = source_of(model, pair);
    const Eigen::RowVector2d from = model.pairs.position.row(pair);
    const Eigen::RowVector2d to = model.pairs.position.row(pair + 1);
    edges.push_back(
        {pair, pair + 1, (to - from).norm(), depth_of(body.material).at((from.x() + to.x()) / 2),
         body.mesh.order(),
         body.mesh.order() == MeshOrder::Linear || !presses_one_node(model, body, pair)});
  }
  return edges;
}

double gap_between_nodes(const Model& model, const std::vector<ContactEdge>& edges,
                         const VectorXd& force) {
  const VectorXd& gap = model.pairs.initial_gap;
  VectorXd curvature = VectorXd::Zero(gap.size());  // at the pairs
  Eigen::VectorXi known = Eigen::VectorXi::Zero(gap.size());
  for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
    const ContactEdge& before = edges[e];
    const ContactEdge& after = edges[e + 1];
    if (before.to != after.from) continue;
    curvature(before.to) = 2 / (before.length + after.length) *
                           ((gap(after.to) - gap(after.from)) / after.length -
                            (gap(before.to) - gap(before.from)) / before.length);
    known(before.to) = 1;
  }
  double sum = 0;
  for (const ContactEdge& edge : edges) {
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
