#include "addons/estimate/facing_marks.hpp"

#include <cmath>
#include <utility>

#include "addons/estimate/outline_shape.hpp"
#include "signorini/core/index.hpp"
#include "signorini/pairing/target_search.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

/// One boundary of a contact, and the marks on its body.
struct MarkedSide {
  const Mesh& mesh;
  const std::string& boundary;
  MarkedEdges& marks;

  [[nodiscard]] const std::vector<CellSide>& sides() const {
    return signorini::boundary(mesh, boundary);
  }
  [[nodiscard]] char& mark(std::size_t side) const {
    return marks.halved[at(marks.edges.at(sides()[side]))];
  }
};

double length(const SideCurve& side) { return (side.point(1) - side.point(-1)).norm(); }

bool curved(const Mesh& mesh, const OutlineShape& shape, const SideCurve& side) {
  for (std::size_t k = 0; k + 1 < side.nodes().size(); ++k) {
    const Eigen::Index first = side.nodes()[k];
    const Eigen::Vector2d along = mesh.nodes.row(side.nodes()[k + 1]) - mesh.nodes.row(first);
    const Eigen::Vector2d half = mesh.nodes.row(first).transpose() + along / 2;
    if (shape.middle(first, side.nodes()[k + 1]) != half) return true;
  }
  return false;
}

/// Marks what the marked sides of one boundary face on another. \return whether something was marked
bool mark_from(const MarkedSide& from, const MarkedSide& to) {
  const TargetSearch search(to.mesh, to.boundary);
  const OutlineShape here(from.mesh);
  const OutlineShape there(to.mesh);
  bool marked = false;
  for (std::size_t k = 0; k < from.sides().size(); ++k) {
    if (from.mark(k) == 0) continue;
    const SideCurve side(from.mesh, from.sides()[k]);
    const Projection faced = search.closest(side.point(0), side.normal(0));
    if (!faced.found) continue;
    const SideCurve& other = search.side(faced.side);
    char& mark = to.mark(at(faced.side));
    if (mark != 0 || length(other) < std::sqrt(0.5) * length(side)) continue;
    if (!curved(from.mesh, here, side) && !curved(to.mesh, there, other)) continue;
    mark = 1;
    marked = true;
  }
  return marked;
}

}  // namespace

void mark_facing(const std::vector<ContactSpec>& contacts, const std::vector<BodyModel>& bodies,
                 std::vector<MarkedEdges>& marks) {
  const auto marked_side = [&](const Side& side) {
    const std::size_t body = body_index(bodies, side);
    return MarkedSide{bodies[body].mesh, side.boundary, marks[body]};
  };
  bool again = true;
  while (again) {
    for (std::size_t b = 0; b < marks.size(); ++b)
      marks[b].halved =
          closed_under_halving(bodies[b].mesh, marks[b].edges, std::move(marks[b].halved));
    again = false;
    for (const ContactSpec& contact : contacts) {
      const Side* const target = std::get_if<Side>(&contact.target);
      if (target == nullptr) continue;
      const MarkedSide one = marked_side(contact.source);
      const MarkedSide other = marked_side(*target);
      again = mark_from(one, other) || again;
      again = mark_from(other, one) || again;
    }
  }
}

}  // namespace signorini
