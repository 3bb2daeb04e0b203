// # Two boundaries that may touch
//
// Three mistakes in a scene are found here: source and target face the same way, they lie beside
// each other, or one lies inside the other. Each of them would end as a problem that has no pairs
// or no solution, with a message that speaks of matrices. Here it is still geometry, and a user
// can act on it.

#include "signorini/pairing/interface.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Vector2d;

/// The integral of the normal: across the line from its beginning to its end.
///
/// The normal of a curve is its tangent turned by a quarter, so its integral is the chord turned by
/// a quarter: a quick answer to the question which way a boundary looks, however it winds. A closed
/// boundary has the chord 0 and looks in no direction.
Vector2d mean_normal(const Surface& surface) {
  Vector2d along = Vector2d::Zero();
  for (const SideCurve& side : side_curves(surface.mesh, surface.boundary))
    along += side.point(1) - side.point(-1);
  return {along.y(), -along.x()};
}

/// Columns are counted through all bodies. A wrong offset would write the forces of one body to
/// another.
void check_columns(const Surface& surface, const GapOptions& options) {
  const Eigen::Index last = surface.first_node + surface.mesh.n_nodes();
  require_argument(surface.first_node >= 0 && last <= options.n_nodes, "gap operator: the body '",
                   surface.mesh.name, "' has the nodes ", surface.first_node, " to ", last - 1,
                   " of all bodies, but options.n_nodes is ", options.n_nodes);
}

/// What messages call the two: boundaries by name, with the name of the body each belongs to.
std::string names(const Interface& interface) {
  const Surface& source = interface.source;
  const Surface& target = interface.target;
  return text("contact of the source '", source.boundary, "' of '", source.mesh.name,
              "' with the target '", target.boundary, "' of '", target.mesh.name, "'");
}

}  // namespace

/// Sides of the source are kept as curves in walking order, those of the target in a tree.
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

/// A point that lies deeper than the cell behind the side it faces is not paired, as another side
/// may be meant. If it even lies within the target, no side is: the scene begins with an overlap
/// that is no small displacement.
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

/// Two boundaries that look the same way within 60 degrees cannot touch; a wrong name is the usual
/// reason. Otherwise they only miss each other.
void Interface::check_paired(std::size_t n_pairs) const {
  if (n_pairs > 0) return;
  // The mean normals decide which of the two messages helps.
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
