#include "support/sliding_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "addons/steps/steps.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/bodies.hpp"
#include "support/random_bodies.hpp"
#include "support/two_bodies.hpp"

namespace signorini_test {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using Profile = std::function<double(double)>;

/// A side that is flat, round or wavy, of height 0 at 0. \param out  the sign of y out of its body
/// \param cell  length of the edges, of which a wave has at least six
Profile profile_of(Draws& draw, double out, double cell) {
  const int what = draw.whole(0, 3);
  const double size = draw.pick({0.5, 1.0, 3.0, 10.0});
  draw.say(what == 0 ? "flat" : what == 1 ? "bulging " : what == 2 ? "hollow " : "wavy ", size);
  if (what == 0) return [](double) { return 0.0; };
  if (what < 3)
    return [=](double x) { return (what == 1 ? -out : out) * x * x / (2 * (size + 1)); };
  const double number = 1 / (cell * (1 + size));  // of the wave
  const double height = 0.02 / number;
  return [=](double x) { return height * out * (std::cos(number * x) - 1); };
}

/// Puts the side of a block that is at y = 0 on a profile.
Mesh with_side(const Mesh& mesh, const Profile& profile, double height) {
  return mapped(mesh, [&](const Vector2d& x) {
    return Vector2d(x.x(), x.y() + profile(x.x()) * (1 - std::abs(x.y()) / height));
  });
}

Material elastic(double modulus) {
  Material material;
  material.youngs_modulus = modulus;
  material.poisson_ratio = 0.3;
  return material;
}

/// The obstacle below, and the height of its surface; nothing if there is a mesh.
std::pair<std::optional<Obstacle>, Profile> obstacle_of(Draws& draw) {
  const double size = draw.pick({0.5, 1.0, 3.0, 10.0});
  const double R = size + 1;
  switch (draw.whole(0, 8)) {
    case 0:
      draw.say("half plane");
      return {half_plane({0, 0}, {0, 1}), [](double) { return 0.0; }};
    case 1:
    case 2:
      draw.say("disc ", R);
      return {disc({0, -R}, R), [R](double x) { return std::sqrt(R * R - x * x) - R; }};
    case 3:
      draw.say("hole ", R);
      return {hole({0, R}, R), [R](double x) { return R - std::sqrt(R * R - x * x); }};
    case 4:
      draw.say("wave ", size);
      return {profile([=](double x) { return 0.05 * (std::cos(4 * x / size) - 1); },
                      [=](double x) { return -0.2 / size * std::sin(4 * x / size); }),
              [=](double x) { return 0.05 * (std::cos(4 * x / size) - 1); }};
    default:
      return {std::nullopt, {}};
  }
}

/// Moves what is above as far down as it goes without an overlap.
Mesh put_down(const Mesh& mesh, const Profile& above, const Profile& below) {
  double room = std::numeric_limits<double>::infinity();
  for (int k = -200; k <= 200; ++k) room = std::min(room, above(k / 400.0) - below(k / 400.0));
  return mapped(mesh, [room](const Vector2d& x) { return Vector2d(x.x(), x.y() - room); });
}

History history(const char* name, std::vector<double> values) {
  History made{name, {0}, {0}};
  for (const double value : values) {
    made.times.push_back(static_cast<double>(made.times.size()));
    made.values.push_back(value);
  }
  return made;
}

void add_steps(Draws& draw, Scene& scene) {
  if (draw.chance(8)) return;
  const bool back = draw.chance(3);
  draw.say(back ? "; steps forth and back" : "; steps");
  Path path;
  path.histories = {history("press", {1, 1, 1}), history("drag", {0, 1, back ? 0.1 : 1.0})};
  for (int k = 1; k <= 4 * (back ? 3 : 2); ++k) path.times.push_back(k / 4.0);
  for (Support& support : scene.bodies[0].supports)
    support.history = support.holds_x ? "drag" : "press";
  for (EdgeLoad& load : scene.bodies[0].loads.edges) load.history = "press";
  scene.path = std::move(path);
}

NodeArray together(const std::vector<NodeArray>& bodies) {
  NodeArray all(0, 2);
  for (const NodeArray& one : bodies) {
    const NodeArray before = all;
    all.resize(before.rows() + one.rows(), 2);
    all << before, one;
  }
  return all;
}

VectorXd flat(const NodeArray& u) { return Eigen::Map<const VectorXd>(u.data(), u.size()); }

/// What a contact does.
struct ContactForce {
  double normal = 0;                  // sum of the normal forces of all pairs
  Vector2d force = Vector2d::Zero();  // on the first body
};

ContactForce contact_force(const Model& model, const Solution& solution, const Scene& scene) {
  const Index pairs = model.pairs.weight.size();
  const VectorXd& f = solution.refined.force;
  VectorXd nodal = model.pairs.opening.transpose() * f.head(pairs);
  if (!model.law.pair.empty())
    nodal +=
        selected_rows(model.pairs.sliding, model.law.pair).transpose() * f.tail(f.size() - pairs);
  ContactForce sum{f.head(pairs).sum(), Vector2d::Zero()};
  for (Index k = 0; k < 2 * scene.bodies[0].mesh.n_nodes(); ++k) sum.force(k % 2) += nodal(k);
  return sum;
}

/// A scene with pairs that stay on the places that they face at first.
struct Paired {
  SolveStatus end = SolveStatus::Solved;
  std::vector<ContactForce> forces = {};  // at the times of its path
  std::string notes = {};                 // that they slide, of any step
};

void see(const Model& model, const Solution& solution, const Scene& scene, Paired& paired) {
  paired.forces.push_back(contact_force(model, solution, scene));
  for (const std::string& note : solution.notes)
    if (note.find("Where the bodies have moved to") != std::string::npos)
      paired.notes += "\n  " + note;
}

Paired as_paired(const Scene& scene) {
  Paired paired;
  Ledger ledger;
  Model model = build(scene, ledger);
  if (!scene.path) {
    const Solution solution = solve(model, condense(model, ledger), ledger);
    paired.end = solution.contact.report.status;
    if (paired.end == SolveStatus::Solved) see(model, solution, scene, paired);
    return paired;
  }
  CondensedPath path = condense_path(model, ledger);
  const std::vector<double>& times = scene.path->times;
  const auto observe = [&](const Model& at, const Step& step) {
    if (std::find(times.begin(), times.end(), step.state.time) != times.end())
      see(at, step.solution, scene, paired);
  };
  paired.end = solve_steps(model, path, ledger, observe, {}).status;
  return paired;
}

/// The scene with its nodes moved, and nothing that moves them: of it the contact is asked.
Scene geometry(Scene scene, const NodeArray& u) {
  Index first = 0;
  for (Body& body : scene.bodies) {
    body.mesh.nodes += u.middleRows(first, body.mesh.n_nodes());
    first += body.mesh.n_nodes();
    body.loads = {};
    for (Support& support : body.supports) {
      support.displacement = [](const Vector2d&) { return Vector2d(0, 0); };
      support.history.clear();
    }
  }
  scene.path.reset();
  return scene;
}

/// Where the bodies are, and how far the nodes of the source have slid since the step began.
struct Place {
  NodeArray u;
  std::map<Index, double> slid;
};

/// One contact problem with the pairs of the meshes where they are.
Solution solve_there(const Scene& scene, Model& model, Condensed& condensed, const Place& at) {
  Plan there = plan(geometry(scene, at.u));
  const VectorXd rest = flat(model.unknowns.held) - flat(at.u);  // gaps there count from u
  const Index slips = static_cast<Index>(there.law.pair.size());
  const Index pairs = there.gaps.A.rows();
  model.programme.A = contact_rows(there.gaps, there.law);
  model.programme.initial_gap.resize(pairs + slips);
  model.programme.initial_gap.head(pairs) =
      there.gaps.pairs.initial_gap + there.gaps.pairs.opening * rest;
  if (slips > 0) {
    VectorXd slid(slips);
    for (Index k = 0; k < slips; ++k) {
      const auto pair = static_cast<std::size_t>(there.law.pair[static_cast<std::size_t>(k)]);
      const auto known = at.slid.find(there.gaps.pairs.node[pair]);
      slid(k) = known == at.slid.end() ? 0 : known->second;
    }
    model.programme.initial_gap.tail(slips) =
        slid + selected_rows(there.gaps.pairs.sliding, there.law.pair) * rest;
  }
  model.pairs = std::move(there.gaps.pairs);
  model.contact_of = std::move(there.contact_of);
  model.law = std::move(there.law);
  model.followed = nullptr;
  condensed.problem.law = model.law;
  Ledger ledger;
  condensed.problem.compliance = condensed.factor.compliance(model.programme.A, ledger);
  move_freely(model, condensed.factor.solve(model.programme.load), condensed);
  return solve(model, condensed, Ledger());
}

/// Solves a step until its bodies stay where they are; says why it does not end, or nothing.
std::string follow_step(const Scene& scene, const Model& model, Condensed& condensed, Place& at,
                        ContactForce& force) {
  constexpr double still = 1e-7;  // of the width of the upper body
  double moved = 1;
  for (int k = 0; k < 40 && moved > still; ++k) {
    Model there = model;
    const Solution solution = solve_there(scene, there, condensed, at);
    if (solution.contact.report.status != SolveStatus::Solved)
      return why_unsolved(solution) + " unsolved";
    const NodeArray u = together(solution.displacements);
    moved = (u - at.u).cwiseAbs().maxCoeff();
    at.u = u;
    at.slid.clear();
    for (std::size_t p = 0; p < there.law.pair.size(); ++p)
      at.slid[there.pairs.node[static_cast<std::size_t>(there.law.pair[p])]] =
          solution.contact.slip(static_cast<Index>(p));
    force = contact_force(there, solution, scene);
  }
  return moved > still ? text("goes on moving by ", moved) : "";
}

/// The forces with pairs that follow the bodies, at the times of its path, and why it came to no end, or nothing.
std::pair<std::vector<ContactForce>, std::string> as_moved(const Scene& scene) {
  Ledger ledger;
  Model model = build(scene, ledger);
  Condensed condensed = condense(model, ledger);
  Place at{NodeArray::Zero(count_nodes(model.bodies), 2), {}};
  std::vector<ContactForce> forces;
  for (const double time : scene.path ? scene.path->times : std::vector<double>{1}) try {
      if (scene.path) set_time(time, model);
      at.slid.clear();
      const std::string why = follow_step(scene, model, condensed, at, forces.emplace_back());
      if (!why.empty()) return {forces, why};
    } catch (const ProblemError& error) {
      return {forces, error.what()};
    }
  return {forces, ""};
}

}  // namespace

SlidingScene sliding_scene(std::uint64_t seed) {
  Draws draw(seed);
  SlidingScene made;
  Scene& scene = made.scene;
  const Index cells = draw.whole(4, 12);
  const MeshOrder order = draw.chance(4) ? MeshOrder::Quadratic : MeshOrder::Linear;
  const double height = draw.pick({0.25, 0.5, 1.0});
  scene.bodies.clear();
  draw.say("upper ", cells, ' ');
  const Profile lower_side = profile_of(draw, -1, 1.0 / static_cast<double>(cells));
  Mesh upper =
      with_side(named_block("upper", {-0.5, 0}, {1, height}, cells, 3, order), lower_side, height);
  draw.say(" on ");
  auto [obstacle, surface] = obstacle_of(draw);
  ContactSpec contact;
  contact.source = {"bottom", "upper"};
  std::optional<Body> base;
  double softer = 1;
  if (obstacle) {
    contact.target = *obstacle;
  } else {
    const Index columns = draw.whole(6, 30);
    draw.say(columns, ' ');
    surface = profile_of(draw, 1, 3.0 / static_cast<double>(columns));
    softer = draw.pick({1e-2, 1.0, 1.0, 1e3});
    base = Body{with_side(named_block("base", {-1.5, -1}, {3, 1}, columns, 4, order), surface, 1),
                "",
                elastic(softer),
                {},
                {fixed("bottom")},
                {},
                {}};
    contact.target = Side{"top", "base"};
    if (draw.chance(4)) std::swap(contact.source, std::get<Side>(contact.target));
    contact.gap_operator =
        draw.pick<const char*>({"mortar", "mortar", "node_to_segment", "gauss_points"});
    draw.say(" by ", contact.gap_operator, " from ", contact.source.body);
  }
  // Points that are no nodes have no number to remember a slip by, see Place.
  if (draw.chance(8) && contact.gap_operator != "gauss_points")
    contact.friction = Friction{draw.pick({0.1, 0.3, 0.8})};
  draw.say("; mu ", contact.friction ? contact.friction->coefficient : 0);
  Body body{put_down(upper, lower_side, surface), "", elastic(1), {}, {}, {}, {}};
  const double edge = 1.0 / static_cast<double>(cells);
  const double along =
      edge * std::pow(2.0, draw.whole(-8, 4)) * draw.sixteenths(8, 16) * draw.pick({-1.0, 1.0});
  const double down = height * draw.decade(-4, -2) * draw.sixteenths(16, 48);
  const bool by_load = draw.chance(5);
  body.supports = {prescribed("top", Axis::X, along)};
  if (by_load) {  // and held by springs that let it down, but hardly turn
    body.loads.edges = {{"top", std::min(softer, 1.0) * down / height, {}}};
    body.springs = {{"top", {0, 0.1 * std::min(softer, 1.0)}, {}}};
  } else {
    body.supports.push_back(prescribed("top", Axis::Y, -down));
  }
  draw.say("; along ", along / edge, " edges, ", by_load ? "pressed " : "down ", down / height);
  scene.bodies.push_back(std::move(body));
  if (base) scene.bodies.push_back(std::move(*base));
  scene.contacts = {contact};
  add_steps(draw, scene);
  made.text = std::move(draw.text);
  return made;
}

SlidingTrial try_sliding(std::uint64_t seed) {
  SlidingScene drawn = sliding_scene(seed);
  SlidingTrial trial;
  const Paired usual = as_paired(drawn.scene);
  trial.refused = usual.end == SolveStatus::SlidTooFar;
  trial.noted = !trial.refused && !usual.notes.empty();
  drawn.scene.contacts[0].small_sliding = true;
  const Paired paired = as_paired(drawn.scene);
  const auto [forces, why] = as_moved(drawn.scene);
  trial.found = why.empty() && paired.end == SolveStatus::Solved;
  trial.text =
      text(drawn.text, "; ", to_string(usual.end), usual.notes, why.empty() ? "" : "\n  ", why);
  for (std::size_t k = 0; trial.found && k < forces.size(); ++k) {
    const ContactForce& stays = paired.forces[k];
    const double difference =
        std::max((forces[k].force - stays.force).norm(), std::abs(forces[k].normal - stays.normal));
    if (difference > 0) trial.change = std::max(trial.change, difference / stays.normal);
  }
  return trial;
}

}  // namespace signorini_test
