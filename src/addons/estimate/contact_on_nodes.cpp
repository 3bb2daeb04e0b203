#include "addons/estimate/contact_on_nodes.hpp"

#include <cmath>

#include "addons/estimate/contact_edges.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/plane.hpp"

namespace signorini {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;

ContactOnNodes::ContactOnNodes(const Model& model, const BodyModel& body)
    : opening_(model.pairs.opening.middleCols(2 * body.first_node, 2 * body.mesh.n_nodes())),
      meshed_(model.pairs.opening.rows()),
      even_(2 * body.mesh.n_nodes(), 2) {
  const std::vector<char> meshed = meshed_contacts(model);
  for (Index pair = 0; pair < meshed_.size(); ++pair)
    meshed_(pair) = meshed[model.contact_of[at(pair)]];
  even_ = on_nodes(model.pairs.weight);
}

Eigen::MatrixX2d ContactOnNodes::on_nodes(const VectorXd& force) const {
  Eigen::MatrixX2d by_kind(meshed_.size(), 2);
  by_kind << force.cwiseProduct(VectorXd::Ones(meshed_.size()) - meshed_),
      force.cwiseProduct(meshed_);
  return opening_.transpose() * by_kind;
}

NodeArray ContactOnNodes::pressures(const VectorXd& force) const {
  const Eigen::MatrixX2d forces = on_nodes(force.head(meshed_.size()));
  NodeArray pressures(even_.rows() / 2, 2);
  for (Index node = 0; node < pressures.rows(); ++node)
    for (const int kind : {0, 1}) {
      const Vector2d even = even_.col(kind).segment<2>(2 * node);
      const double square = even.squaredNorm();
      pressures(node, kind) =
          square > 0 ? even.dot(forces.col(kind).segment<2>(2 * node)) / square : 0;
    }
  return pressures;
}

Vector2d ContactOnNodes::turning(Index first, Index last, double by) const {
  Vector2d turning;
  for (const int kind : {0, 1}) {
    const Vector2d from = even_.col(kind).segment<2>(2 * first);
    const Vector2d to = even_.col(kind).segment<2>(2 * last);
    turning(kind) = std::atan2(cross(from, to), from.dot(to)) / by;
  }
  return turning;
}

}  // namespace signorini
