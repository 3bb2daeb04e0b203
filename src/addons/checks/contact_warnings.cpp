#include "addons/checks/contact_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "addons/checks/sides.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/far.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/pairing/target_search.hpp"
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

/// Where a surface turns by more than 30 degrees from one side to the next: the cosine and the node.
using Turns = std::vector<std::pair<double, Index>>;

/// The sides of a boundary, each mostly followed by the next one of its list.
class Walk {
 public:
  explicit Walk(const Surface& surface) : sides(side_curves(surface.mesh, surface.boundary)) {}

  /// \return the side that begins where one ends; null at the end of a boundary
  const SideCurve* behind(std::size_t k) {
    const Index end = sides[k].nodes().back();
    const SideCurve& next = sides[(k + 1) % sides.size()];
    if (next.nodes().front() == end) return &next;
    if (k + 1 < sides.size() && begins_.empty())
      for (const SideCurve& side : sides) begins_.emplace(side.nodes().front(), &side);
    const auto found = begins_.find(end);
    return found == begins_.end() ? nullptr : found->second;
  }

  std::vector<SideCurve> sides;

 private:
  std::map<Index, const SideCurve*> begins_;  // once one is not followed by the next of the list
};

/// \param outwards  whether only corners that stick out count
Turns turns_of(const Surface& surface, bool outwards) {
  Turns turns;
  Walk walk(surface);
  for (std::size_t k = 0; k < walk.sides.size(); ++k) {
    const SideCurve* const next = walk.behind(k);
    if (next == nullptr) continue;
    const Eigen::Vector2d normal = walk.sides[k].normal(1), other = next->normal(-1);
    const bool sticks_out = normal.x() * other.y() - normal.y() * other.x() > 0;
    if (const double cosine = normal.dot(other); cosine < std::cos(pi / 6) && (sticks_out || !outwards))
      turns.emplace_back(cosine, walk.sides[k].nodes().back());
  }
  if (turns.empty()) return turns;
  // A side of twelve edges turns by as much, and rounding does not decide about it.
  const double too_far = std::cos(pi / 6) - 16 * direction_rounding(surface.mesh);
  turns.erase(std::remove_if(turns.begin(), turns.end(),
                             [&](const auto& turn) { return turn.first >= too_far; }),
              turns.end());
  return turns;
}

/// How far a side turns at a node, in words. \param which  side \param why  it is too far, and what to do
std::string turn_warning(const std::string& what, const char* which, const Surface& surface,
                         const Turns& turns, const char* why) {
  if (turns.empty()) return "";
  const auto [cosine, node] = *std::min_element(turns.begin(), turns.end());
  return text(what, ": the ", which, " turns by ",
              std::round(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / pi), " degrees at node ",
              node, ", ", in_brackets(surface.mesh.nodes.row(node)), ", and by more than 30 at ",
              turns.size(), turns.size() == 1 ? " node" : " nodes", why);
}

/// A pair of a source has one normal and one pressure. A mean gap over an edge of which one end hangs over a corner of the target is less
/// than any gap of that edge, because the weights of mortar are negative at its far end. Corners of nearly a right angle and more are
/// ends for a source that looks at one of their sides, see TargetSearch::beyond_corner().
std::vector<std::string> turn_warnings(const ContactSpec& contact, const std::string& what,
                                       const Surface& source,
                                       const std::vector<BodyModel>& bodies) {
  std::vector<std::string> notes = {turn_warning(
      what, "source", source, turns_of(source, false),
      ": a pair there has one normal and one pressure for both sides. Give the parts of a "
      "side with a corner names of their own, and each its contact; make a round side finer")};
  if (contact.gap_operator != "mortar" || std::holds_alternative<Obstacle>(contact.target))
    return notes;
  const Surface target = surface(bodies, std::get<Side>(contact.target));
  Turns turns = turns_of(target, true);
  const auto ends_target = [](const auto& turn) { return turn.first < grazing_cosine; };
  turns.erase(std::remove_if(turns.begin(), turns.end(), ends_target), turns.end());
  notes.push_back(turn_warning(
      what, "target", target, turns,
      ": an edge of the source that hangs over such a corner closes before it touches. Leave the "
      "sides behind the corner out, take this side as the source, or operator = "
      "\"gauss_points\" where nothing moves"));
  return notes;
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

/// A way between two nodes of a source that follow each other.
struct Way {
  Index from, to;
  Eigen::Vector2d start, end;
  double rise;  ///< of the obstacle above the line through what both nodes see [length]
};

/// Looks at places between the nodes of the sides of a source.
std::vector<Way> ways_between(const Surface& source, const Obstacle& obstacle) {
  constexpr int places = 16;
  std::vector<Way> ways;
  for (const SideCurve& side : side_curves(source.mesh, source.boundary)) {
    const auto count = static_cast<int>(side.nodes().size()) - 1;
    for (int k = 0; k < count; ++k) {
      const auto at_xi = [&](double t) -> Eigen::Vector2d {
        return side.point(2 * (k + t) / count - 1).position();
      };
      Way way{side.nodes()[at(k)], side.nodes()[at(k + 1)], at_xi(0), at_xi(1), 0};
      const double first = obstacle.look(way.start).gap, last = obstacle.look(way.end).gap;
      for (int i = 1; i < places; ++i) try {
          const double t = static_cast<double>(i) / places;
          way.rise = std::max(way.rise, (1 - t) * first + t * last - obstacle.look(at_xi(t)).gap);
        } catch (const ProblemError&) {  // nothing can be seen there, as in the centre of a disc
        }
      ways.push_back(way);
    }
  }
  return ways;
}

/// Of an obstacle that rises between two neighbouring nodes by more than half of what these nodes and the ones beside them tell
/// apart: a curve or a corner that the nodes see rises by less. Round sources leave their own arcs by as much as they turn.
std::string unseen_warning(const Obstacle& obstacle, const std::string& what,
                           const Surface& source) {
  if (obstacle.linear) return "";
  const std::vector<Way> ways = ways_between(source, obstacle);
  std::map<Index, std::vector<std::size_t>> around;
  for (std::size_t k = 0; k < ways.size(); ++k)
    for (const Index node : {ways[k].from, ways[k].to}) around[node].push_back(k);
  const Way* most = nullptr;
  for (const Way& way : ways) {
    double seen = 0, turn = 0;
    const Eigen::Vector2d along = way.end - way.start;
    for (const Index node : {way.from, way.to})
      for (const std::size_t k : around[node]) {
        const Way& beside = ways[k];
        const Eigen::Vector2d other = beside.end - beside.start;
        seen = std::max(seen,
                        std::abs(obstacle.look(beside.end).gap - obstacle.look(beside.start).gap));
        turn = std::max(
            turn, std::acos(std::clamp(along.normalized().dot(other.normalized()), -1.0, 1.0)));
      }
    const double rounding = 64 * epsilon * source.mesh.nodes.cwiseAbs().maxCoeff();
    const double own = along.norm() * turn / 4 + rounding;  // twice the rise of an arc
    if (way.rise > seen / 2 + own && (most == nullptr || way.rise > most->rise)) most = &way;
  }
  if (most == nullptr) return "";
  return text(what, ": between the neighbouring nodes at ", in_brackets(most->start), " and ",
              in_brackets(most->end), " the ", obstacle.name, " rises by ", most->rise,
              " above the line through what both see, and no node sees that. Make the sides there "
              "shorter than what rises is wide");
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
  if (obstacle != nullptr) notes.push_back(unseen_warning(*obstacle, what, source));
  for (std::string& note : turn_warnings(contact, what, source, bodies))
    notes.push_back(std::move(note));
  notes.push_back(axis_warning(what, contact, bodies[body_index(bodies, contact.source)]));
  notes.erase(std::remove(notes.begin(), notes.end(), ""), notes.end());
  return notes;
}

}  // namespace signorini
