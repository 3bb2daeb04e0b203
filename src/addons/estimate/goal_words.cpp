#include "addons/estimate/goal_words.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/joints.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// Where a contact begins: the place of its smallest gap, of several the first. In axial symmetry it begins on the axis if
/// the side that this place is on does: of three nodes that side has a pair in its middle, and none on the axis.
Vector2d middle_of(const Plan& plan, const std::string& contact) {
  const Pairs& pairs = plan.gaps.pairs;
  Index nearest = -1;
  for (Index pair = 0; pair < pairs.initial_gap.size(); ++pair) {
    const std::string& own = plan.contacts[plan.contact_of[at(pair)]];
    if ((contact.empty() || own == contact) &&
        (nearest < 0 || pairs.initial_gap(pair) < pairs.initial_gap(nearest)))
      nearest = pair;
  }
  if (nearest < 0) return Vector2d::Zero();
  const Vector2d place = pairs.position.row(nearest).transpose();
  const Index node = pairs.node[at(nearest)];
  if (node < 0) return place;
  const BodyModel& body = plan.bodies[body_of_node(plan.bodies, node)];
  if (!depth_of(body.material).axial) return place;
  const Index own = node - body.first_node;
  const auto on_axis = [axis = axis_nodes(body.mesh)](Index other) {
    return std::binary_search(axis.begin(), axis.end(), other);
  };
  if (on_axis(own)) return {0, place.y()};
  for (const CellSide& side : outer_sides(body.mesh)) {
    const std::vector<Index> nodes = body.mesh.side_nodes(side);
    if (nodes.size() < 3 || std::find(nodes.begin(), nodes.end(), own) == nodes.end()) continue;
    for (const Index end : {nodes.front(), nodes.back()})
      if (on_axis(end)) return {0, body.mesh.nodes(end, 1)};
  }
  return place;
}

/// Hertz's contact begins at one place, or between two nodes. One that begins along a line has no middle.
void require_middle(const Plan& plan, const std::string& contact, const std::string& word) {
  const Pairs& pairs = plan.gaps.pairs;
  std::vector<double> gaps;
  for (Index pair = 0; pair < pairs.initial_gap.size(); ++pair)
    if (contact.empty() || plan.contacts[plan.contact_of[at(pair)]] == contact)
      gaps.push_back(pairs.initial_gap(pair));
  if (gaps.empty()) return;
  const double least = *std::min_element(gaps.begin(), gaps.end());
  const double rounding = 64 * epsilon * pairs.position.cwiseAbs().maxCoeff();
  const auto alike =
      std::count_if(gaps.begin(), gaps.end(), [&](double gap) { return gap - least <= rounding; });
  require_input(alike <= 2, "goal ", in_quotes(word), ": the sides are equally close at ", alike,
                " nodes before loading, so that their contact has no middle: it does not press as "
                "Hertz's does; ask for its force or for a displacement");
}

/// The contact that a goal is about: if it is named, or the only one.
std::string contact_in_words(const std::string& word, const std::string& name, const Plan& plan) {
  require_input(!plan.contacts.empty(), "goal ", in_quotes(word), ": the scene has no contact");
  require_input(!name.empty() || plan.contacts.size() == 1, "goal ", in_quotes(word),
                ": say which contact, as in ", in_quotes(word + ":" + plan.contacts.front()),
                "; there are ", listed(plan.contacts));
  bool known = name.empty();
  for (const std::string& contact : plan.contacts) known = known || contact == name;
  require_input(known, "goal ", in_quotes(word), ": unknown contact ", in_quotes(name),
                suggestion(name, plan.contacts));
  return name;
}

Goal displacement_in_words(const std::string& word, const std::string& place, const Plan& plan) {
  const std::size_t last = place.rfind('.');
  const std::size_t first = place.find('.');
  const std::string axis = last == std::string::npos ? "" : place.substr(last + 1);
  require_input((axis == "x" || axis == "y") && last > 0, "goal ", in_quotes(word),
                ": expected displacement:BODY.boundary.x or displacement:BODY.boundary.y");
  Displacement goal;
  goal.axis = axis == "x" ? Axis::X : Axis::Y;
  if (first != last) goal.body = place.substr(0, first);
  goal.boundary = first == last ? place.substr(0, last) : place.substr(first + 1, last - first - 1);
  const std::size_t body = body_index(plan.bodies, {goal.boundary, goal.body});
  static_cast<void>(boundary(plan.bodies[body].mesh, goal.boundary));
  return {word, goal};
}

/// The mean displacement of a boundary in the direction in which it is loaded, or across it.
Goal displacement_of(const BodyModel& body, const std::string& boundary, const Vector2d& force) {
  const bool along_x = std::abs(force.x()) > std::abs(force.y());
  const std::string name =
      text("displacement:", body.mesh.name, '.', boundary, along_x ? ".x" : ".y");
  return {name, Displacement{body.mesh.name, along_x ? Axis::X : Axis::Y, boundary, {}}};
}

/// The first boundary that carries a load of size, with that load.
bool loaded(const Plan& plan, DefaultGoal& found) {
  for (const BodyModel& body : plan.bodies)
    for (const EdgeLoad& edge : body.loads.edges) {
      Loads one;
      one.edges = {edge};
      const Vector2d force =
          nodal_loads(body.mesh, body.element, body.material, one).colwise().sum();
      if (force.isZero(0)) continue;
      found.goal = displacement_of(body, edge.boundary, force);
      return true;
    }
  return false;
}

}  // namespace

DefaultGoal default_goal(const Scene& scene, const Plan& plan) {
  DefaultGoal found;
  if (plan.contacts.size() == 1 && plan.modes.empty()) {
    found.goal = {"normal_force", NormalForce{}};
    return found;
  }
  if (plan.contacts.size() == 1)
    found.why = "equilibrium alone says what the contact force is, on any mesh";
  if (loaded(plan, found)) return found;
  require_input(
      !scene.contacts.empty(),
      "the scene has neither contact nor a loaded boundary: say what is to be accurate, as in "
      "displacement:BODY.boundary.y");
  const Side& source = scene.contacts.front().source;
  const BodyModel& body = plan.bodies[body_index(plan.bodies, source)];
  found.goal = displacement_of(body, source.boundary, Vector2d(0, 1));
  return found;
}

Goal goal_in_words(const std::string& word, const Plan& plan) {
  const std::size_t colon = word.find(':');
  const std::string kind = word.substr(0, colon);
  const std::string name = colon == std::string::npos ? "" : word.substr(colon + 1);
  if (kind == "displacement") return displacement_in_words(word, name, plan);
  const std::vector<std::string> kinds = {"force", "normal_force", "peak", "width"};
  require_input(std::find(kinds.begin(), kinds.end(), kind) != kinds.end(), "unknown goal ",
                in_quotes(word),
                suggestion(kind, {"force", "normal_force", "peak", "width", "displacement"}),
                ". Expected force, normal_force, peak, width, or displacement:BODY.boundary.y");
  const std::string contact = contact_in_words(word, name, plan);
  if (kind == "force") return {word, ContactForce{contact}};
  if (kind == "normal_force") return {word, NormalForce{contact, {}}};
  require_middle(plan, contact, word);
  const Vector2d middle = middle_of(plan, contact);
  if (kind == "peak") return {word, PeakPressure{contact, middle}};
  return {word, HalfWidth{contact, middle}};
}

}  // namespace signorini
