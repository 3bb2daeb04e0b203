// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What lies between neighbouring pairs of a contact.
#pragma once
#include <vector>

#include "signorini/scene/solution.hpp"

namespace signorini {

/// Two pairs of one contact whose nodes are neighbours on a side of a cell of the source.
struct ContactEdge {
  Eigen::Index from;  ///< number of the first pair
  Eigen::Index to;    ///< number of the second
  CellSide side;      ///< of the source, which both nodes lie on
  double length;      ///< between their nodes, straight [length]
  double depth;       ///< across the plane, in the middle [length]
  MeshOrder order;    ///< of the source: of three nodes per side, two edges make one
  /// Whether pressures and shares between the nodes are taken as straight. Only where forces act on nodes of sides of three
  /// are they parabolas; a mortar pair there spreads its force over more nodes than its own.
  bool straight;
};

/// \param model  from build(), all of whose pairs have nodes
/// \return the edges of all contacts, in walking order; none across a piece without pairs, and of a closed ring also the
///   one from its last pair to its first
[[nodiscard]] std::vector<ContactEdge> contact_edges(const Model& model);

/// The body that the source of a pair belongs to.
/// \param model  from build()
/// \param pair   whose node is known
/// \return the body
[[nodiscard]] const BodyModel& source_of(const Model& model, Eigen::Index pair);

/// \param model  from build() \param pair  whose node is known \return number of its source among the bodies
[[nodiscard]] std::size_t source_index(const Model& model, Eigen::Index pair);

/// \param model  from build(), all of whose pairs have nodes
/// \return of each contact, not 0 if its target is a mesh too
[[nodiscard]] std::vector<char> meshed_contacts(const Model& model);

/// What the gaps between the nodes of a source and an obstacle count for a goal besides the straight lines that the pairs
/// know of; what two meshes leave between them is in outline_shares(). On sides of two nodes a gap of the curvature g'' lies by \f$ g'' s (h - s)/2 \f$ below its chord, if it is convex:
///
/// \f[ \langle\mu, g - I g\rangle = -\sum \frac{h^3}{12}\, g''\, \bar\mu, \f]
///
/// with mean curvatures of three gaps each, and \f$ \bar\mu \f$ the dual pressure. It covers curved obstacles and the arcs
/// that a source is cut short by, both as far as the gaps of the nodes show them; sides of three nodes follow both.
/// \param model  from build()
/// \param edges  contact_edges() of it
/// \param force  mu of all pairs
/// \return its part of the error of the goal
[[nodiscard]] double gap_between_nodes(const Model& model, const std::vector<ContactEdge>& edges,
                                       const Eigen::VectorXd& force);

}  // namespace signorini
