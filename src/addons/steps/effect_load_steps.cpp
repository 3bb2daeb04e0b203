// Load steps: the loads of a scene, sorted by the history that they follow.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "addons/steps/histories.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/checks.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

void check_increasing(const std::vector<double>& times, const std::string& what) {
  for (std::size_t k = 0; k < times.size(); ++k) {
    require_input(std::isfinite(times[k]), what, ": every time must be finite, got ", times[k]);
    require_input(k == 0 || times[k] > times[k - 1], what, ": times must increase, but ", times[k],
                  " follows ", times[k > 0 ? k - 1 : 0]);
  }
}

void check_path(const Path& path) {
  require_input(!path.times.empty(), "load steps: expected the time of one step or more, got none");
  check_increasing(path.times, "load steps");
  require_input(path.times.front() > 0, "load steps: the first step ends at time ",
                path.times.front(), ", but steps begin at 0: a step needs a time > 0");
  require_input(path.halvings >= 0, "load steps: halvings must be >= 0, got ", path.halvings);
  std::map<std::string, int> seen;
  for (const History& history : path.histories) {
    require_input(!history.name.empty(),
                  "a history of load steps needs a name that loads can refer to");
    require_input(++seen[history.name] == 1, "two histories are called '", history.name, "'");
    check_history(history);
  }
}

/// What names a history must name one of the path.
void check_known(const std::string& name, const std::vector<History>& histories) {
  std::string names;
  bool known = name.empty();
  for (const History& history : histories) {
    known = known || history.name == name;
    names += (names.empty() ? "'" : ", '") + history.name + "'";
  }
  require_input(known, "no history is called '", name,
                "'; those of the load steps: ", names.empty() ? "none" : names);
}

/// Asked before effects, which look at what supports give at the end of every step.
Check::Notes check_histories(const Scene& scene, const BodyModel& /*body*/) {
  if (!scene.path) return {};
  check_path(*scene.path);
  const auto known = [&](const std::string& name) { check_known(name, scene.path->histories); };
  for (const Body& body : scene.bodies) each_history(body, known);
  for (const ContactSpec& contact : scene.contacts) known(contact.interference_history);
  return {};
}

/// The rows of a history, if they are few.
std::string rows_in_words(const History& history) {
  constexpr std::size_t few = 6;
  if (history.times.size() > few) return text(history.times.size(), " rows");
  std::string rows;
  for (std::size_t k = 0; k < history.times.size(); ++k)
    rows += text(k == 0 ? "" : ", ", history.values[k], " at time ", history.times[k]);
  return rows;
}

/// The parts of a scene, and how many of its entries follow each.
class Sorting {
 public:
  Sorting(const Scene& scene, const Plan& draft) : scene_(scene), draft_(draft) {
    part("");
    for (const History& history : scene.path->histories) part(history.name);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) sort_body(b);
    for (std::size_t pair = 0; pair < draft.contact_of.size(); ++pair) {
      if (draft.contact_of[pair] >= scene.contacts.size()) continue;  // of a relation
      const ContactSpec& contact = scene.contacts[draft.contact_of[pair]];
      const auto row = static_cast<Index>(pair);
      const Eigen::Vector2d x = draft.gaps.pairs.position.row(row).transpose();
      find(contact.interference_history).interference(row) = interference_at(contact, x);
    }
    for (const ContactSpec& contact : scene.contacts)
      if (contact.interference.value_or(0) != 0) ++entries_[contact.interference_history];
    for (const std::string& history : draft.follows) {
      check_known(history, scene.path->histories);
      ++entries_[history];
    }
  }

  [[nodiscard]] std::vector<LoadPart>& parts() { return parts_; }
  [[nodiscard]] int entries(const std::string& history) const {
    const auto found = entries_.find(history);
    return found == entries_.end() ? 0 : found->second;
  }

 private:
  void part(const std::string& history) {
    LoadPart& added = parts_.emplace_back();
    added.history = history;
    added.loads.resize(scene_.bodies.size());
    added.eigenstrain.resize(scene_.bodies.size());
    for (const BodyModel& body : draft_.bodies)
      added.held.emplace_back(NodeArray::Zero(body.mesh.n_nodes(), 2));
    added.interference.setZero(static_cast<Index>(draft_.contact_of.size()));
  }

  LoadPart& find(const std::string& history) {
    return *std::find_if(parts_.begin(), parts_.end(),
                         [&](const LoadPart& part) { return part.history == history; });
  }

  LoadPart& use(const std::string& history) {
    LoadPart& found = find(history);
    ++entries_[history];
    return found;
  }

  void sort_body(std::size_t b) {
    const Body& body = scene_.bodies[b];
    const Loads& loads = body.loads;
    if (loads.body_force) use(loads.body_force_history).loads[b].body_force = loads.body_force;
    for (const EdgeLoad& load : loads.edges) use(load.history).loads[b].edges.push_back(load);
    for (const PointForce& load : loads.points) use(load.history).loads[b].points.push_back(load);
    if (body.temperature && body.temperature->nonzero())
      use(body.temperature->history).eigenstrain[b] = draft_.bodies[b].material.eigenstrain;
    for (const Support& support : body.supports)
      if (!support.history.empty()) use(support.history);
    for (LoadPart& part : parts_) {
      std::vector<Support> own = body.supports;
      for (Support& support : own)
        if (support.history != part.history)
          support.displacement = [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, 0); };
      part.held[b] = number_unknowns(body.mesh, own, body.material.state).held;
    }
  }

  const Scene& scene_;
  const Plan& draft_;
  std::vector<LoadPart> parts_;
  std::map<std::string, int> entries_;
};

void declare_steps(const Scene& scene, Plan& draft) {
  Sorting sorting(scene, draft);
  draft.path = *scene.path;
  const bool finite =
      std::any_of(draft.bodies.begin(), draft.bodies.end(), [](const BodyModel& body) {
        return body.material.base.law != nullptr;
      });
  draft.on.push_back(text("load steps: ", draft.path.times.size(), " up to time ",
                          draft.path.times.back(), finite ? "" : ", one factor for all"));
  for (const History& history : draft.path.histories) {
    const int entries = sorting.entries(history.name);
    draft.on.push_back(text("history '", history.name, "': ", rows_in_words(history), "; ", entries,
                            entries == 1 ? " load follows it" : " loads follow it"));
    if (entries == 0) draft.notes.push_back("history '" + history.name + "': nothing follows it");
  }
  draft.parts = std::move(sorting.parts());
}

/// What a part does to the nodes of a body, held ones too.
NodeArray nodal_forces(const BodyModel& body, const Loads& loads, const Eigenstrain& eigenstrain,
                       const NodeArray& held) {
  NodeArray forces = nodal_loads(body.mesh, body.element, body.material, loads);
  if (eigenstrain || (held.array() != 0).any()) {
    MaterialField material = at_rest(body.material);
    material.eigenstrain = eigenstrain;
    forces -= internal_forces(body.mesh, body.element, material, held);
  }
  if (body.springs.rows() > 0)
    Eigen::Map<VectorXd>(forces.data(), forces.size()) -=
        body.springs * Eigen::Map<const VectorXd>(held.data(), held.size());
  return forces;
}

void add_parts(Model& model) {
  const Index pairs = model.pairs.weight.size();
  VectorXd rest = model.programme.initial_gap;
  for (std::size_t k = model.parts.size(); k-- > 0;) {
    LoadPart& part = model.parts[k];
    part.load.setZero(model.unknowns.count);
    NodeArray held = NodeArray::Zero(count_nodes(model.bodies), 2);
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      const BodyModel& body = model.bodies[b];
      add_nodal_forces(body, nodal_forces(body, part.loads[b], part.eigenstrain[b], part.held[b]),
                       part.load);
      held.middleRows(body.first_node, body.mesh.n_nodes()) = part.held[b];
    }
    const Eigen::Map<const VectorXd> given(held.data(), held.size());
    part.movement.resize(rest.size());
    part.movement.head(pairs) = model.pairs.opening * given - part.interference;
    if (!model.law.pair.empty())
      part.movement.tail(rest.size() - pairs) =
          selected_rows(model.pairs.sliding, model.law.pair) * given;
    if (k > 0)
      rest -= part.movement;
    else
      part.movement = rest;  // with the gaps of the meshes
  }
}

}  // namespace

void check_history(const History& history) {
  const std::string what = "history '" + history.name + "'";
  require_input(!history.times.empty() && history.times.size() == history.values.size(), what,
                ": expected as many values as times, at least one, got ", history.times.size(),
                " times and ", history.values.size(), " values");
  check_increasing(history.times, what);
  for (const double value : history.values)
    require_input(std::isfinite(value), what, ": every value must be finite, got ", value);
}

History proportional(const std::string& name) { return {name, {0, 1}, {0, 1}}; }

std::vector<double> equal_steps(int steps, double end) {
  std::vector<double> times;
  for (int k = 1; k <= steps; ++k) times.push_back(end * k / steps);
  return times;
}

void register_load_steps() {
  add_check({"histories", check_histories});
  add_effect({"load steps",
              [](const Scene& scene, const Plan& /*draft*/) { return scene.path.has_value(); },
              declare_steps, add_parts});
}

}  // namespace signorini
