#include "addons/estimate/contact_ends.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

std::vector<ContactEnd> contact_ends(const std::vector<ContactEdge>& edges,
                                     const Solution& solution, const Dual& dual) {
  const ContactState& contact = solution.contact;
  const auto closed = [&](Index pair) {
    return contact.contact_status[static_cast<std::size_t>(pair)] != ContactStatus::Open;
  };
  std::vector<ContactEnd> ends;
  for (const ContactEdge& edge : edges) {
    if (closed(edge.from) == closed(edge.to)) continue;
    ContactEnd end{edge.from, edge.to, 0, 0, 0};
    if (!closed(edge.from)) std::swap(end.closed, end.open);
    end.pull = dual.force_to_close(end.open);
    end.overlap = dual.gap_without(end.closed);
    const double out = std::sqrt(-end.pull * contact.gap(end.open));
    const double in = std::sqrt(-end.overlap * contact.force(end.closed));
    end.offset = (in - out) / (2 * (in + out));
    if (std::isfinite(end.offset)) ends.push_back(end);
  }
  return ends;
}

double free_boundary(const ContactEnd& end, double per_force, double per_gap) {
  const double out = per_force * end.pull, in = -per_gap * end.overlap, t = end.offset;
  const double bend = (out + in) / 2, slope = (out - in) / 2;
  const double cubic = (slope + 2 * bend * t) / (1 - 3 * t * t);
  return t * (slope - cubic + t * (bend + t * cubic));
}

VectorXd away_from_ends(const std::vector<ContactEnd>& ends, const Model& model,
                        const BodyModel& body) {
  const Mesh& mesh = body.mesh;
  VectorXd away = VectorXd::Ones(mesh.n_cells());
  VectorXd pressed(mesh.n_nodes());
  for (const ContactEnd& end : ends) {
    pressed.setZero();
    for (NodalRows::InnerIterator entry(model.pairs.opening, end.closed); entry; ++entry)
      if (const Index node = entry.col() / 2 - body.first_node; node >= 0 && node < pressed.size())
        pressed(node) += std::abs(entry.value());
    const double all = pressed.sum();
    if (!(all > 0)) continue;
    for (Index cell = 0; cell < away.size(); ++cell)
      for (Index k = 0; k < mesh.cell_size(cell); ++k)
        away(cell) -= pressed(mesh.cells(cell, k)) / all;
  }
  return away.cwiseMax(0);
}

}  // namespace signorini
