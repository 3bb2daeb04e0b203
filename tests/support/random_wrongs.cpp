#include "support/random_wrongs.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "papers/solver_table.hpp"
#include "support/far.hpp"

namespace signorini_test {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A member of a list; null if there is none.
template <typename T>
T* any_of(Draws& draw, std::vector<T>& all) {
  return all.empty() ? nullptr : &all[static_cast<std::size_t>(draw.whole(0, 9999)) % all.size()];
}

/// What is no number, or infinite.
double no_number(Draws& draw) { return draw.pick({none, infinity, -infinity}); }
/// What is not above 0 either.
double not_positive(Draws& draw) { return draw.pick({none, infinity, -infinity, 0.0, -1.0}); }
double negative(Draws& draw) { return draw.pick({none, infinity, -infinity, -1.0, -1e-300}); }
/// A factor that is legal, and sensible in no unit.
double extreme(Draws& draw) {
  return draw.pick({1e-320, 1e-300, 1e-150, 1e-30, 1e-12, 1e-8, 1e8, 1e12, 1e30, 1e150, 1e300});
}
VectorField everywhere(const Vector2d& value) {
  return [value](const Vector2d&) { return value; };
}
Vector2d in_one(Draws& draw, double value) {
  return draw.chance(8) ? Vector2d(value, 0) : Vector2d(0, value);
}

/// The name of some boundary of a body.
std::string some_boundary(Draws& draw, const Body& body) {
  std::vector<std::string> names;
  for (const auto& [name, sides] : body.mesh.boundaries) names.push_back(name);
  const std::string* const name = any_of(draw, names);
  return name != nullptr ? *name : "";
}

/// A way to change a scene. \return whether the scene has what it changes
struct Change {
  const char* what;
  bool (*make)(Draws& draw, Scene& scene, Body& body, ContactSpec* contact);
};

const std::vector<Change>& wrong_bodies() {
  static const std::vector<Change> all = {
      {"wrong modulus",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.material.youngs_modulus = not_positive(draw);
         return true;
       }},
      {"wrong Poisson's ratio",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.material.poisson_ratio = draw.pick({none, infinity, -1.0, -2.0, 0.6, 1e300});
         return true;
       }},
      {"wrong thickness",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.material.thickness = not_positive(draw);
         return true;
       }},
      {"wrong expansion",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.material.expansion = no_number(draw);
         return true;
       }},
      {"wrong temperature",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.material.expansion = 1e-5;
         body.temperature = Temperature{1, {0, 0}};
         if (draw.chance(8))
           body.temperature->uniform = no_number(draw);
         else
           body.temperature->gradient = in_one(draw, no_number(draw));
         return true;
       }},
      {"wrong layer",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         Material other = body.material;
         const bool named = draw.chance(8);
         if (named) other.youngs_modulus = not_positive(draw);
         if (named || draw.chance(8)) body.mesh.regions["some"] = {named ? 0 : body.mesh.n_cells()};
         body.layers.push_back({"some", other});
         return true;
       }},
      {"wrong coordinate",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         const Index node = draw.whole(0, 9999) % body.mesh.n_nodes();
         body.mesh.nodes(node, draw.whole(0, 1)) = no_number(draw);
         return true;
       }},
      {"node that does not exist",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         const Index cell = draw.whole(0, 9999) % body.mesh.n_cells();
         body.mesh.cells(cell, draw.whole(0, 2)) =
             draw.pick<Index>({body.mesh.n_nodes(), Index{-7}, Index{1} << 40});
         return true;
       }},
      {"turned or flat cell",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         const Index cell = draw.whole(0, 9999) % body.mesh.n_cells();
         if (draw.chance(8))
           std::swap(body.mesh.cells(cell, 0), body.mesh.cells(cell, 1));
         else
           body.mesh.cells(cell, 0) = body.mesh.cells(cell, 1);
         return true;
       }},
      {"no cells",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         if (draw.chance(8)) body.mesh.nodes.resize(0, 2);
         body.mesh.cells.resize(0, body.mesh.cells.cols());
         return true;
       }},
      {"element of that name does not exist",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.element = draw.pick<const char*>({"q5", "Q4", " ", "mortar"});
         return true;
       }},
      {"two bodies of one name", [](Draws&, Scene& scene, Body& body, ContactSpec*) {
         scene.bodies.push_back(Body(body));
         return true;
       }}};
  return all;
}

const std::vector<Change>& wrong_entries() {
  static const std::vector<Change> all = {
      {"load of no number",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         EdgeLoad load{some_boundary(draw, body), 1, {}};
         if (draw.chance(8))
           load.pressure = no_number(draw);
         else
           load.traction = everywhere(in_one(draw, no_number(draw)));
         body.loads.edges.push_back(load);
         return true;
       }},
      {"load on a boundary that does not exist",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.loads.edges.push_back({draw.pick<const char*>({"", "nowhere", "Top"}), 1, {}});
         return true;
       }},
      {"load on a boundary without sides",
       [](Draws&, Scene&, Body& body, ContactSpec*) {
         body.mesh.boundaries["empty"] = {};
         body.loads.edges.push_back({"empty", 1, {}});
         return true;
       }},
      {"load on a side that does not exist",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         const Index cell = draw.pick<Index>({body.mesh.n_cells(), Index{-1}, Index{0}});
         body.mesh.boundaries["wrong"] = {{cell, cell == 0 ? 7 : 0}};
         body.loads.edges.push_back({"wrong", 1, {}});
         return true;
       }},
      {"weight of no number",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.loads.body_force = everywhere(in_one(draw, no_number(draw)));
         return true;
       }},
      {"wrong point force",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         PointForce load{body.mesh.nodes.row(body.mesh.cells(0, 0)), {1, 0}};
         const bool number = draw.chance(8);
         if (number) load.force = in_one(draw, no_number(draw));
         if (!number)
           load.point =
               draw.chance(8) ? Vector2d(no_number(draw), 0) : 1e3 * load.point + Vector2d(1e9, 0);
         body.loads.points.push_back(load);
         return true;
       }},
      {"support by no number",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.supports = {prescribed(some_boundary(draw, body), draw.chance(8) ? Axis::X : Axis::Y,
                                     no_number(draw))};
         return true;
       }},
      {"support where nothing is",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         if (draw.chance(8))
           body.supports.push_back(fixed("nowhere"));
         else
           body.supports.push_back(
               prescribed_at(some_boundary(draw, body), {no_number(draw), 0}, Axis::X));
         return true;
       }},
      {"supports that contradict each other",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         const std::string where = some_boundary(draw, body);
         body.supports = {prescribed(where, Axis::Y, 1), prescribed(where, Axis::Y, -2)};
         return true;
       }},
      {"wrong spring",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         Spring spring{some_boundary(draw, body), {1, 1}};
         if (draw.chance(10))
           spring.stiffness = in_one(draw, negative(draw));
         else
           spring.boundary = "nowhere";
         body.springs.push_back(spring);
         return true;
       }},
      {"no bodies",
       [](Draws&, Scene& scene, Body&, ContactSpec*) {
         scene.bodies.clear();
         return true;
       }},
      {"solver or back end that is none",
       [](Draws& draw, Scene& scene, Body&, ContactSpec*) {
         if (draw.chance(50))
           scene.solver = {};
         else
           scene.backend = {};
         return true;
       }},
      {"history that does not exist",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.loads.edges.push_back({some_boundary(draw, body), 1, {}, "nothing"});
         return true;
       }},
      {"wrong history",
       [](Draws& draw, Scene& scene, Body&, ContactSpec*) {
         if (!scene.path) return false;
         History* const history = any_of(draw, scene.path->histories);
         if (history == nullptr) return false;
         const int how = draw.whole(0, 3);
         if (how == 0) history->values.back() = no_number(draw);
         if (how == 1) history->times.back() = no_number(draw);
         if (how == 2) history->values.pop_back();
         if (how == 3) std::swap(history->times.front(), history->times.back());
         return true;
       }},
      {"wrong times", [](Draws& draw, Scene& scene, Body&, ContactSpec*) {
         if (!scene.path) return false;
         const int how = draw.whole(0, 2);
         if (how == 0) scene.path->times.clear();
         if (how == 1) scene.path->times.back() = no_number(draw);
         if (how == 2) scene.path->times.front() = draw.pick({0.0, -1.0, 99.0});
         return true;
       }}};
  return all;
}

const std::vector<Change>& wrong_contacts() {
  static const std::vector<Change> all = {
      {"wrong friction",
       [](Draws& draw, Scene&, Body&, ContactSpec* contact) {
         contact->friction = Friction{0.5, 0};
         const int how = draw.whole(0, 2);
         if (how == 0) contact->friction->coefficient = negative(draw);
         if (how == 1) contact->friction->cohesion = negative(draw);
         if (how == 2) contact->friction->law = draw.pick<const char*>({"", "Coulomb", "mohr"});
         return true;
       }},
      {"Tresca's law with a coefficient",
       [](Draws& draw, Scene&, Body&, ContactSpec* contact) {
         contact->friction = Friction{0.5, draw.chance(8) ? 1.0 : 0.0, "tresca"};
         return true;
       }},
      {"wrong fit",
       [](Draws& draw, Scene&, Body&, ContactSpec* contact) {
         (draw.chance(8) ? contact->interference : contact->adjust) = negative(draw);
         return true;
       }},
      {"contact of a boundary that does not exist",
       [](Draws& draw, Scene&, Body&, ContactSpec* contact) {
         if (draw.chance(8))
           contact->source.boundary = "nowhere";
         else
           contact->target = Side{"nowhere", contact->source.body};
         return true;
       }},
      {"contact of a body that does not exist",
       [](Draws&, Scene&, Body&, ContactSpec* contact) {
         contact->source.body = "nobody";
         return true;
       }},
      {"gap operator that does not exist",
       [](Draws& draw, Scene&, Body&, ContactSpec* contact) {
         contact->gap_operator = draw.pick<const char*>({"", "mortars", "q8"});
         return true;
       }},
      {"wrong number of points",
       [](Draws& draw, Scene&, Body&, ContactSpec* contact) {
         if (!std::holds_alternative<Side>(contact->target)) return false;
         contact->gap_operator = draw.pick<const char*>({"mortar", "gauss_points"});
         contact->points = draw.pick({-1, 17, 1000000, -2147483647});
         return true;
       }},
      {"contact that is listed twice",
       [](Draws&, Scene& scene, Body&, ContactSpec* contact) {
         scene.contacts.push_back(ContactSpec(*contact));
         return true;
       }},
      {"wrong obstacle", [](Draws& draw, Scene&, Body&, ContactSpec* contact) {
         const Vector2d normal = draw.chance(8) ? in_one(draw, no_number(draw)) : Vector2d(0, 1);
         const double gap = normal == Vector2d(0, 1) ? no_number(draw) : 0;
         contact->target = Obstacle{"an odd obstacle", [=](const Vector2d&) {
                                      return ObstacleContact{gap, normal};
                                    }};
         return true;
       }}};
  return all;
}

const std::vector<Change>& odd() {
  static const std::vector<Change> all = {
      {"odd modulus",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.material.youngs_modulus *= extreme(draw);
         return true;
       }},
      {"odd Poisson's ratio",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.material.poisson_ratio = draw.pick({-0.999, -0.5, 0.49999, 0.4999999999, 1e-300});
         return true;
       }},
      {"odd thickness",
       [](Draws& draw, Scene& scene, Body&, ContactSpec*) {
         const double factor = extreme(draw);
         for (Body& body : scene.bodies) {
           if (body.material.state == PlaneState::Axial) return false;
           body.material.thickness *= factor;
         }
         return true;
       }},
      {"odd loads",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         const double factor = extreme(draw);
         for (EdgeLoad& load : body.loads.edges) load.pressure *= factor;
         return true;
       }},
      {"without loads",
       [](Draws&, Scene& scene, Body&, ContactSpec*) {
         if (scene.path) return false;  // histories that nothing follows
         for (Body& body : scene.bodies) body.loads = {};
         return true;
       }},
      {"without supports",
       [](Draws&, Scene&, Body& body, ContactSpec*) {
         body.supports = {};
         return true;
       }},
      {"held all around",
       [](Draws&, Scene&, Body& body, ContactSpec*) {
         body.supports = {};
         for (const auto& [name, sides] : body.mesh.boundaries)
           body.supports.push_back(fixed(name));
         return true;
       }},
      {"odd displacement",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         Support* const support = any_of(draw, body.supports);
         if (support == nullptr) return false;
         support->displacement = everywhere(Vector2d(0, -1) * extreme(draw));
         return true;
       }},
      {"without contacts",
       [](Draws&, Scene& scene, Body&, ContactSpec*) {
         scene.contacts.clear();
         return true;
       }},
      {"far away",
       [](Draws& draw, Scene& scene, Body&, ContactSpec*) {
         scene = moved(scene, size_of(scene) * draw.decade(5, 15) * Vector2d(1, -0.75));
         return true;
       }},
      {"one body elsewhere",
       [](Draws& draw, Scene& scene, Body& body, ContactSpec*) {
         const double size = size_of(scene);
         body.mesh = moved(std::move(body.mesh),
                           {size * draw.sixteenths(-16, 16), size * draw.sixteenths(-16, 16)});
         return true;
       }},
      {"odd spring",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         const double stiffness = body.material.youngs_modulus * extreme(draw);
         body.springs.push_back({some_boundary(draw, body), in_one(draw, stiffness)});
         return true;
       }},
      {"odd temperature",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.material.expansion = draw.pick({-1e-5, 1e-5, 1.0});
         body.temperature = Temperature{extreme(draw), {0, 0}};
         return true;
       }},
      {"element for any mesh",
       [](Draws& draw, Scene&, Body& body, ContactSpec*) {
         body.element =
             draw.pick<const char*>({"", "q4", "q4_bbar", "q4_incompatible", "q8", "t3", "t6"});
         return true;
       }},
      {"any solver",
       [](Draws& draw, Scene& scene, Body&, ContactSpec*) {
         std::vector<Solver> family = all_solvers();
         scene.solver = *any_of(draw, family);
         draw.say(' ', scene.solver.name);
         return true;
       }},
      {"one node moved", [](Draws& draw, Scene& scene, Body& body, ContactSpec*) {
         const Index node = draw.whole(0, 9999) % body.mesh.n_nodes();
         body.mesh.nodes(node, draw.whole(0, 1)) += size_of(scene) * draw.decade(-12, 0);
         return true;
       }}};
  return all;
}

const std::vector<Change>& odd_contacts() {
  static const std::vector<Change> all = {
      {"odd friction",
       [](Draws& draw, Scene&, Body&, ContactSpec* contact) {
         contact->friction = Friction{draw.chance(8) ? extreme(draw) : 0, 0};
         if (draw.chance(8)) contact->friction->cohesion = extreme(draw);
         return true;
       }},
      {"Tresca's law",
       [](Draws& draw, Scene&, Body& body, ContactSpec* contact) {
         const double cohesion = body.material.youngs_modulus * draw.decade(-6, 0);
         contact->friction = Friction{0, cohesion, "tresca"};
         return true;
       }},
      {"odd interference",
       [](Draws& draw, Scene& scene, Body&, ContactSpec* contact) {
         contact->interference = size_of(scene) * draw.pick({1e-300, 1e-12, 0.1, 1.0, 1e3, 1e12});
         return true;
       }},
      {"odd adjustment",
       [](Draws& draw, Scene& scene, Body&, ContactSpec* contact) {
         contact->adjust = size_of(scene) * draw.pick({1e-300, 1e-12, 0.1, 10.0, 1e300});
         return true;
       }},
      {"other boundary in contact",
       [](Draws& draw, Scene& scene, Body&, ContactSpec* contact) {
         for (const Body& body : scene.bodies)
           if (body.mesh.name == contact->source.body)
             contact->source.boundary = some_boundary(draw, body);
         return true;
       }},
      {"contact of the body with itself",
       [](Draws& draw, Scene&, Body& body, ContactSpec* contact) {
         contact->source = {some_boundary(draw, body), body.mesh.name};
         contact->target = Side{some_boundary(draw, body), body.mesh.name};
         return true;
       }}};
  return all;
}

}  // namespace

bool spoil(Draws& draw, Scene& scene) {
  bool wrong = false;
  for (int left = draw.whole(0, 3); left > 0 && !wrong; --left) {
    if (scene.bodies.empty()) break;
    ContactSpec* const contact = any_of(draw, scene.contacts);
    const bool touches = contact != nullptr && draw.chance(6);
    const bool breaks = draw.chance(5);
    std::vector<Change> list = breaks ? wrong_entries() : odd();
    if (breaks && draw.chance(8)) list = wrong_bodies();
    if (touches) list = breaks ? wrong_contacts() : odd_contacts();
    const Change& change = *any_of(draw, list);
    draw.say("; ", change.what);
    const bool done = change.make(draw, scene, *any_of(draw, scene.bodies), contact);
    wrong = breaks && done;
  }
  return wrong;
}

}  // namespace signorini_test
