#include "signorini/contact/interface.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Vector2d;

/// The integral of the normal: across the line from its beginning to its end.
Vector2d mean_normal(const Surface& surface) {
  Vector2d along = Vector2d::Zero();
  for (const SideCurve& side : side_curves(surface.mesh, surface.boundary))
    along += side.point(1) - side.point(-1);
  return {along.y(), -along.x()};
}

void check_columns(const Surface& surface, const GapOptions& options) {
  const Eigen::Index last = surface.first_node + surface.mesh.n_nodes();
  require_argument(surface.first_node >= 0 && last <= options.n_nodes, "gap operator: the body '",
                   surface.mesh.name, "' has the nodes ", surface.first_node, " to ", last - 1,
                   " of all bodies, but options.n_nodes is ", options.n_nodes);
}

std::string names(const Interface& interface) {
  const Surface& source = interface.source;
  const Surface& target = interface.target;
  return text("contact of the source '", source.boundary, "' of '", source.mesh.name,
              "' with the target '", target.boundary, "' of '", target.mesh.name, "'");
}

}  // namespace

Interface::Interface(const Surface& source_side, const Surface& target_side,
                     const GapOptions& options)
    : source(source_side),
      target(target_side),
      sides(side_curves(source.mesh, source.boundary)),
      search(target.mesh, target.boundary),
      depth(options.depth) {
  check_columns(source, options);
  check_columns(target, options);
  require_argument(depth.factor > 0 && std::isfinite(depth.factor),
                   "gap operator: the thickness must be positive, got ", depth.factor);
}

Projection Interface::closest(const AnchoredPoint& x, const Vector2d& normal) const {
  const Projection place = search.closest(x, normal);
  const Vector2d at = x.position();
  if (place.inside)
    throw ProblemError(
        text(names(*this), ": the point (", at.x(), ", ", at.y(), ") of '", source.mesh.name,
             "' lies inside '", target.mesh.name,
             "', deeper than the cell whose side it faces. Move the bodies apart, or check which "
             "boundaries are meant"));
  return place;
}

void Interface::check_paired(std::size_t n_pairs) const {
  if (n_pairs > 0) return;
  const Vector2d a = mean_normal(source);
  const Vector2d b = mean_normal(target);
  require_input(
      a.dot(b) <= 0.5 * a.norm() * b.norm() || a.dot(b) == 0, names(*this),
      ": both face the same way, so that neither can touch the other. Take the boundary of one "
      "body that looks towards the other body");
  throw ProblemError(text(names(*this),
                          ": no point of the first faces the second; it lies beside it or behind "
                          "it. Move one of the bodies, or check which boundaries are meant"));
}

}  // namespace signorini
