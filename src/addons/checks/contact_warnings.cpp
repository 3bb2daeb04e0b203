#include "addons/checks/contact_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "addons/checks/sides.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/far.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/contact_input.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Of an obstacle that no node faces.
std::string obstacle_warning(const Obstacle& obstacle, const std::string& what,
                             const Surface& source, const Pairs& pairs) {
  if (normal_cosines(pairs, source).minCoeff() < -aside) return "";
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
              first, " at ", in_brackets(source.mesh.nodes.row(first)),
              ". If the source has passed through the target, move the bodies apart");
}

/// How far a side turns at a node, if that is too far for one pair with one normal and one pressure.
std::string turn_warning(const std::string& what, const Surface& source) {
  std::map<Index, Eigen::Vector2d> normals;
  std::vector<std::pair<double, Index>> turns;  // cosine and node
  for (const SideCurve& side : side_curves(source.mesh, source.boundary))
    for (const int end : {-1, 1}) {
      const Index node = end < 0 ? side.nodes().front() : side.nodes().back();
      const Eigen::Vector2d normal = side.normal(end);
      const auto [known, first] = normals.emplace(node, normal);
      const double cosine = known->second.dot(normal);
      if (!first && cosine < std::cos(pi / 6)) turns.emplace_back(cosine, node);
    }
  if (turns.empty()) return "";
  // A side of twelve edges turns by as much, and rounding does not decide about it.
  const double too_far = std::cos(pi / 6) - 16 * direction_rounding(source.mesh);
  turns.erase(std::remove_if(turns.begin(), turns.end(),
                             [&](const auto& turn) { return turn.first >= too_far; }),
              turns.end());
  if (turns.empty()) return "";
  const auto [cosine, node] = *std::min_element(turns.begin(), turns.end());
  return text(
      what, ": the source turns by ",
      std::round(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / pi), " degrees at node ", node,
      ", ", in_brackets(source.mesh.nodes.row(node)), ", and by more than 30 at ", turns.size(),
      turns.size() == 1 ? " node" : " nodes",
      ": a pair there has one normal and one pressure for both sides. Give the parts of a "
      "side with a corner names of their own, and each its contact; make a round side finer");
}

/// Of nodes on the axis of a body of revolution that have no pair, because no pressure could be told from their force.
std::string axis_warning(const std::string& what, const ContactSpec& contact,
                         const BodyModel& body) {
  if (contact.gap_operator != "node_to_segment" || std::holds_alternative<Obstacle>(contact.target))
    return "";
  const std::vector<Index> idle =
      nodes_without_share(body.mesh, contact.source.boundary, depth_of(body.material));
  if (idle.empty()) return "";
  return text(what, ": the node at ", in_brackets(body.mesh.nodes.row(idle.front())),
              " on the axis has no share of the side and so no pair: only its neighbours keep it "
              "out of the target. Take mortar between two meshes, and small cells at the axis");
}

}  // namespace

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
  notes.push_back(axis_warning(what, contact, bodies[body_index(bodies, contact.source)]));
  notes.erase(std::remove(notes.begin(), notes.end(), ""), notes.end());
  return notes;
}

}  // namespace signorini
