// # Contacts that cannot be meant
//
// Two mistakes in a scene give a wrong answer and no error of any solver.
//
// The first is a contact that is listed twice. Every pair of it then exists twice. Two equal
// pairs have the compliance
// \f[ G = \begin{pmatrix} 1 & 1 \\ 1 & 1 \end{pmatrix}, \quad d = \binom{-2}{-2}: \f]
// the forces must add up to 2, and any split will do. Gaps and displacements are right, but
// each contact reports only a part of the pressure.
//
// The second is a normal that points into the obstacle, as of a hole that was meant to be a
// disc. Then the body counts as overlapping, and contact pushes it through the obstacle to
// the other side.
//
// The library refuses both. Checks of an add-on may only write notes, see
// [checks.cpp](checks.cpp).

#include "signorini/scene/contact_input.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// Sides of cells are compared by number, so that common ones are found by one walk through
// two sorted lists.
bool before(const CellSide& a, const CellSide& b) {
  return std::pair(a.cell, a.side) < std::pair(b.cell, b.side);
}

// The cell sides that are in both boundaries. Two boundaries with different names may share
// some, so names prove nothing.
std::vector<CellSide> common_sides(const std::vector<BodyModel>& bodies, const Side& one,
                                   const Side& two) {
  if (!one.body.empty() && !two.body.empty() && one.body != two.body) return {};
  const std::size_t body = body_index(bodies, one);
  if (body_index(bodies, two) != body) return {};
  std::vector<CellSide> a = boundary(bodies[body].mesh, one.boundary);
  std::vector<CellSide> b = boundary(bodies[body].mesh, two.boundary);
  std::sort(a.begin(), a.end(), before);
  std::sort(b.begin(), b.end(), before);
  std::vector<CellSide> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common), before);
  return common;
}

// An obstacle is a function, and two functions cannot be compared. What matters is what the
// common nodes see of them: the same gap and the same normal, up to rounding.
bool look_alike(const Mesh& mesh, const std::vector<CellSide>& sides, const Obstacle& one,
                const Obstacle& two) {
  const double rounding = 16 * epsilon * mesh.nodes.cwiseAbs().maxCoeff();
  for (const CellSide& side : sides)
    for (const Index node : mesh.side_nodes(side)) {
      const Eigen::Vector2d x = mesh.nodes.row(node).transpose();
      const ObstacleContact a = one.look(x);
      const ObstacleContact b = two.look(x);
      if (std::abs(a.gap - b.gap) > rounding || (a.normal - b.normal).norm() > 16 * epsilon)
        return false;
    }
  return true;
}

// Of two bodies, source and target may be exchanged: the contact is the same one. A body and
// an obstacle are never the same target. Two obstacles are the same if they look alike from
// the sides that both contacts have.
bool pair_the_same(const ContactSpec& one, const ContactSpec& two,
                   const std::vector<BodyModel>& bodies) {
  const auto share = [&bodies](const Side& a, const Side& b) {
    return !common_sides(bodies, a, b).empty();
  };
  const Side* a = std::get_if<Side>(&one.target);
  const Side* b = std::get_if<Side>(&two.target);
  if (a != nullptr && b != nullptr)
    return (share(one.source, two.source) && share(*a, *b)) ||
           (share(one.source, *b) && share(*a, two.source));
  if (a != nullptr || b != nullptr) return false;
  const std::vector<CellSide> common = common_sides(bodies, one.source, two.source);
  return !common.empty() &&
         look_alike(bodies[body_index(bodies, one.source)].mesh, common,
                    std::get<Obstacle>(one.target), std::get<Obstacle>(two.target));
}

}  // namespace

// Every contact is compared with those before it. Scenes have few contacts, so this costs
// little. The message names both, by their numbers in the scene and by their sides.
// An add-on may count ties that rub among the contacts, which the message says.
void check_listed_once(const Scene& scene, const std::vector<BodyModel>& bodies) {
  const std::vector<ContactSpec>& contacts = scene.contacts;
  for (std::size_t two = 1; two < contacts.size(); ++two)
    for (std::size_t one = 0; one < two; ++one)
      if (pair_the_same(contacts[one], contacts[two], bodies))
        throw ProblemError(text(
            "contacts ", one + 1, " and ", two + 1, " of the scene",
            scene.bonds ? " (ties that rub count as contacts)" : "", " are about the same sides: the ",
            describe(bodies, contacts[one]), ", and the ", describe(bodies, contacts[two]),
            ". Each would carry a part of the pressure only: leave one of them out, or let their "
            "boundaries have no side in common"));
}

// One node in front of the obstacle is enough to show that the side is right. A body that
// overlaps everywhere may be a press fit, and is refused only if some node looks the same
// way as the obstacle.
void check_obstacle_side(const ContactSpec& contact, const std::vector<BodyModel>& bodies,
                         const Pairs& pairs) {
  const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target);
  if (obstacle == nullptr || pairs.initial_gap.maxCoeff() > gap_rounding(pairs)) return;
  const Eigen::VectorXd cosine = normal_cosines(pairs, surface(bodies, contact.source));
  Index turned = 0;
  require_input(
      cosine.maxCoeff(&turned) <= aside, describe(bodies, contact),
      ": no node of the boundary is in front of the ", obstacle->name, ", and at node ",
      pairs.node[static_cast<std::size_t>(turned)], ", (", pairs.position(turned, 0), ", ",
      pairs.position(turned, 1), "), the normal of the obstacle, (", pairs.normal(turned, 0), ", ",
      pairs.normal(turned, 1),
      "), points away from the body. It must point out of the obstacle, towards the body: turn the "
      "normal round, take a hole for a disc or a disc for a hole, or move the body in front");
}

// Two sides that face each other have opposite normals, with the cosine -1. A node between
// two sides has the sum of their normals, so this sum is made a unit vector first.
Eigen::VectorXd normal_cosines(const Pairs& pairs, const Surface& source) {
  const std::vector<SideCurve> sides = side_curves(source.mesh, source.boundary);
  const std::map<Index, NodeOnSide> on_side = nodes_on_sides(sides);
  Eigen::VectorXd cosine(pairs.normal.rows());
  for (Index pair = 0; pair < cosine.size(); ++pair) {
    const NodeOnSide& node = on_side.at(pairs.node[static_cast<std::size_t>(pair)]);
    cosine(pair) = pairs.normal.row(pair).dot(node.normal.normalized());
  }
  return cosine;
}

}  // namespace signorini
