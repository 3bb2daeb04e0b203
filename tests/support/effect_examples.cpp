#include "support/effect_examples.hpp"

#include "addons/steps/histories.hpp"
#include "signorini/fem/regions.hpp"
#include "support/cantilever.hpp"

namespace signorini_test {

using namespace signorini;

Scene plain_beam() {
  Scene scene = cantilever("q4_incompatible", 12, 2);
  scene.bodies[0].loads = {};
  return scene;
}

namespace {

Scene without_contact() {
  Scene scene = plain_beam();
  scene.contacts.clear();
  return scene;
}

Scene two_parts() {
  Scene scene = plain_beam();
  Mesh& mesh = scene.bodies[0].mesh;
  mesh = with_region(mesh, "skin", {0, 2.5}, {50, 5});
  return scene;
}

/// Of a mesh that was written with few digits.
Scene slightly_off() {
  Scene scene = plain_beam();
  scene.contacts[0].target = half_plane({0, -1e-4}, {0, 1});
  return scene;
}

Scene on_disc() {
  Scene scene = plain_beam();
  scene.contacts[0].target = disc({40, -10}, 10.5);
  return scene;
}

Scene above_disc() {
  Scene scene = plain_beam();
  scene.contacts[0].target = disc({40, -10}, 9.5);
  return scene;
}

}  // namespace

const std::map<std::string, EffectExample>& effect_examples() {
  static const std::map<std::string, EffectExample> all = {
      {"axial symmetry",
       {plain_beam(),
        [](Scene& scene) { scene.bodies[0].material.state = PlaneState::Axial; },
        {"K", "pairs"},
        {}}},
      {"body force",
       {plain_beam(),
        [](Scene& scene) {
          scene.bodies[0].loads.body_force = [](const Eigen::Vector2d&) {
            return Eigen::Vector2d(0, -1);
          };
        },
        {"p"},
        {}}},
      {"edge loads",
       {plain_beam(),
        [](Scene& scene) {
          scene.bodies[0].loads.edges = {{"top", 3.6, {}}};
        },
        {"p"},
        {}}},
      {"point forces",
       {plain_beam(),
        [](Scene& scene) {
          scene.bodies[0].loads.points = {{{50, 5}, {0, -1}}};
        },
        {"p"},
        {}}},
      {"layers",
       {two_parts(),
        [](Scene& scene) {
          scene.bodies[0].layers = {{"skin", {1e4, 0.2, PlaneState::Stress, 1}}};
        },
        {"K"},
        {}}},
      {"temperature",
       {two_parts(),
        [](Scene& scene) {
          scene.bodies[0].material.expansion = 1e-5;
          scene.bodies[0].temperature = Temperature{100, {0, 2}};
        },
        {"p"},
        {}}},
      {"springs",
       {plain_beam(),
        [](Scene& scene) {
          scene.bodies[0].springs = {{"right", {0, 2}}};
        },
        {"K"},
        {}}},
      {"adjusted gaps",
       {slightly_off(), [](Scene& scene) { scene.contacts[0].adjust = 1e-3; }, {"g"}, {}}},
      {"interference",
       {on_disc(), [](Scene& scene) { scene.contacts[0].interference = 0.01; }, {"g"}, {}}},
      {"contact",
       {without_contact(),
        [](Scene& scene) { scene.contacts = plain_beam().contacts; },
        {"A", "g", "pairs"},
        {"A", "g", "pairs"}}},
      {"initial overlap",
       {above_disc(),
        [](Scene& scene) {
          scene.contacts[0].target = disc({40, -10}, 10.5);
        },
        {"g"},
        {}}},
      {"friction",
       {plain_beam(),
        [](Scene& scene) {
          scene.contacts[0].friction = Friction{0.3, 0};
        },
        {"A", "g", "law", "sliding"},
        {"law", "sliding"}}},
      {"cohesion",
       {plain_beam(),
        [](Scene& scene) {
          scene.contacts[0].friction = Friction{0, 0.2};
        },
        {"A", "g", "law", "sliding"},
        {"law", "sliding"}}},
      {"rigid motions",
       {plain_beam(),
        [](Scene& scene) { scene.bodies[0].supports = {prescribed("left", Axis::X, 0)}; },
        {"A", "K", "g", "modes", "p", "pairs"},
        {"modes"}}},
      {"load steps",
       {plain_beam(),
        [](Scene& scene) {
          scene.path = Path{{0.5, 1}, {proportional("load")}};
        },
        {"parts"},
        {"parts"}}},
  };
  return all;
}

}  // namespace signorini_test
