#include "addons/checks/contact_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "addons/checks/sides.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/far.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;

bool before(const CellSide& a, const CellSide& b) {
  return std::pair(a.cell, a.side) < std::pair(b.cell, b.side);
}

/// The cell sides that are in both boundaries.
std::vector<CellSide> common_sides(const std::vector<BodyModel>& bodies, const Side& one,
                                   const Side& two) {
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

/// Whether all nodes of some sides see the same of two obstacles.
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

/// Of an obstacle: its normal must point towards the body.
std::string obstacle_warning(const Obstacle& obstacle, const std::string& what,
                             const Surface& source, const Pairs& pairs) {
  const Eigen::VectorXd cosine = normal_cosines(pairs, source);
  Index turned = 0;
  const double most = cosine.maxCoeff(&turned);
  constexpr double aside = 1e-6;  // a cosine that says neither
  require_input(
      most <= aside || pairs.initial_gap.maxCoeff() > gap_rounding(pairs), what,
      ": no node of the boundary is in front of the ", obstacle.name, ", and at node ",
      pairs.node[static_cast<std::size_t>(turned)], ", (", pairs.position(turned, 0), ", ",
      pairs.position(turned, 1), "), the normal of the obstacle, (", pairs.normal(turned, 0), ", ",
      pairs.normal(turned, 1),
      "), points away from the body. It must point out of the obstacle, towards the body: turn the "
      "normal round, take a hole for a disc or a disc for a hole, or move the body in front");
  if (cosine.minCoeff() < -aside) return "";
  return text(
      what, ": no node of the boundary faces the ", obstacle.name,
      ", so that they can hardly touch. Check which boundary is meant, and where the normal "
      "of the obstacle points");
}

std::string passage_warning(const std::string& what, const Surface& source, const Surface& target,
                            const Pairs& pairs) {
  const bool overlap = (pairs.initial_gap.array() < -gap_rounding(pairs)).any();
  if (pairs.unpaired.empty() && !overlap) return "";
  const PenetratingNodes passed = penetrating_nodes(source, target);
  if (passed.nodes.empty()) return "";
  const Index first = passed.nodes.front();
  return text(what, ": ", passed.nodes.size(), " source nodes lie behind the target, up to ",
              passed.farthest, " deep, where its body is thinner than that; the first is node ",
              first, " at (", source.mesh.nodes(first, 0), ", ", source.mesh.nodes(first, 1),
              "). If the source has passed through the target, move the bodies apart");
}

/// How far a side turns at a node, if that is too far for one pair with one normal and one pressure.
std::string turn_warning(const std::string& what, const Surface& source) {
  // A side of twelve edges turns by as much, and rounding does not decide about it.
  const double too_far = std::cos(pi / 6) - 16 * direction_rounding(source.mesh);
  std::map<Index, Eigen::Vector2d> normals;
  std::vector<std::pair<double, Index>> turns;  // cosine and node
  for (const SideCurve& side : side_curves(source.mesh, source.boundary))
    for (const int end : {-1, 1}) {
      const Index node = end < 0 ? side.nodes().front() : side.nodes().back();
      const Eigen::Vector2d normal = side.normal(end);
      const auto [known, first] = normals.emplace(node, normal);
      const double cosine = known->second.dot(normal);
      if (!first && cosine < too_far) turns.emplace_back(cosine, node);
    }
  if (turns.empty()) return "";
  const auto [cosine, node] = *std::min_element(turns.begin(), turns.end());
  return text(
      what, ": the source turns by ",
      std::round(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / pi), " degrees at node ", node,
      ", (", source.mesh.nodes(node, 0), ", ", source.mesh.nodes(node, 1),
      "), and by more than 30 at ", turns.size(), turns.size() == 1 ? " node" : " nodes",
      ": a pair there has one normal and one pressure for both sides. Give the parts of a "
      "side with a corner names of their own, and each its contact; make a round side finer");
}

}  // namespace

void check_listed_once(const Scene& scene, const std::vector<BodyModel>& bodies) {
  const std::vector<ContactSpec>& contacts = scene.contacts;
  for (std::size_t two = 1; two < contacts.size(); ++two)
    for (std::size_t one = 0; one < two; ++one)
      require_input(
          !pair_the_same(contacts[one], contacts[two], bodies), "contacts ", one + 1, " and ",
          two + 1, " of the scene are about the same sides: the ", describe(bodies, contacts[one]),
          ", and the ", describe(bodies, contacts[two]),
          ". Each would carry a part of the pressure only: leave one of them out, or let their "
          "boundaries have no side in common");
}

std::vector<std::string> contact_warnings(const ContactSpec& contact,
                                          const std::vector<BodyModel>& bodies,
                                          const Pairs& pairs) {
  const std::string what = describe(bodies, contact);
  const Surface source = surface(bodies, contact.source);
  std::vector<std::string> notes;
  if (!pairs.unpaired.empty())
    notes.push_back(text(what, ": ", pairs.unpaired.size(),
                         " source nodes face no target and are left out, the first is node ",
                         pairs.unpaired.front()));
  const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target);
  notes.push_back(
      obstacle != nullptr
          ? obstacle_warning(*obstacle, what, source, pairs)
          : passage_warning(what, source, surface(bodies, std::get<Side>(contact.target)), pairs));
  notes.push_back(turn_warning(what, source));
  notes.erase(std::remove(notes.begin(), notes.end(), ""), notes.end());
  return notes;
}

}  // namespace signorini
