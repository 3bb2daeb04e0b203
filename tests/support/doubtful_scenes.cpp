#include "support/doubtful_scenes.hpp"

#include <cmath>
#include <utility>

#include "meshes/disc.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/rounding.hpp"
#include "support/cantilever.hpp"
#include "support/loose_meshes.hpp"

namespace signorini_test {
namespace {

using Eigen::Vector2d;
using namespace signorini;

/// A body on its fixed bottom, pressed from above, in a few cells.
Scene pressed(Mesh mesh, std::vector<Support> supports) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = std::move(mesh);
  body.element = body.mesh.cells.cols() == 8 ? "q8" : "q4_incompatible";
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.supports = std::move(supports);
  body.loads.edges = {{"top", 1, {}}};
  return scene;
}

Scene block() { return pressed(named_block("block", {0, 0}, {4, 2}, 8, 4), {fixed("bottom")}); }

/// Two blocks, the upper one pressed on the lower one and held sideways at a node.
Scene stacked_blocks() {
  Scene scene = two_blocks(named_block("lower", {-2, -2}, {4, 2}, 11, 4),
                           named_block("upper", {-1, 0}, {2, 1}, 8, 4));
  scene.bodies[1].supports = {prescribed_at("top", {-1, 1}, Axis::X)};
  scene.bodies[1].loads.edges = {{"top", 5, {}}};
  return scene;
}

template <typename Change>
Scene with(Scene scene, Change&& change) {
  change(scene);
  return scene;
}

EdgeLoad traction(const char* boundary, const VectorField& field) { return {boundary, 0, field}; }

/// A shaft inside the hole of something rigid, or around a rigid pin.
Scene shaft(const Obstacle& obstacle) {
  DiscSpec spec;
  Scene scene = pressed(make_disc(spec), {prescribed_at("rim", {1, 0}, Axis::Y)});
  scene.bodies[0].loads.edges = {{"rim", 0.5, {}}};
  scene.bodies[0].loads.body_force = [](const Vector2d&) { return Vector2d(0, -1); };
  scene.contacts = {{{"rim"}, obstacle}};
  return scene;
}

/// A disc above a plate of one row of cells, which lies on a fixed bottom.
Scene disc_on_plate(double overlap) {
  DiscSpec spec;
  spec.centre.y() = 1 - overlap;
  spec.core_cells = spec.layers = 6;
  Scene scene = two_blocks(named_block("plate", {-2, -0.1}, {4, 0.1}, 40, 1), make_disc(spec));
  scene.bodies[1].supports = {prescribed_at("rim", {0, 2 - overlap}, Axis::X)};
  scene.bodies[1].supports.push_back(prescribed_at("rim", {0, 2 - overlap}, Axis::Y, 0));
  scene.contacts[0].source = {"rim", "disc"};
  scene.contacts[0].target = Side{"top", "plate"};
  return scene;
}

/// A slender beam, clamped at the left and pressed from above.
Scene slender(double pressure) {
  Scene scene = pressed(named_block("beam", {0, 0}, {50, 0.5}, 100, 2), {fixed("left")});
  scene.bodies[0].loads.edges[0].pressure = pressure;
  return scene;
}

/// A block that is pressed to a uniform strain.
Scene squeezed(double strain) {
  Scene scene = block();
  scene.bodies[0].supports = {symmetric("left"), symmetric("bottom"),
                              prescribed("top", Axis::Y, -2 * strain)};
  scene.bodies[0].loads = {};
  return scene;
}

/// A nearly incompressible block between walls, pressed on a floor: its strain is a seventeenth of pressure / E.
Scene confined(double pressure) {
  Scene scene = block();
  scene.bodies[0].material.poisson_ratio = 0.49;
  scene.bodies[0].supports = {symmetric("left"), symmetric("right")};
  scene.bodies[0].loads.edges[0].pressure = pressure;
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

void add_mesh_warnings(std::vector<DoubtfulScene>& all) {
  const Mesh whole = merged(
      together(named_block("block", {0, 0}, {2, 2}, 4, 4), named_block("", {2, 0}, {2, 2}, 4, 4)));
  const std::vector<Support> both = {fixed("bottom"), fixed("bottom2")};
  const Mesh apart =
      together(named_block("block", {0, 0}, {2, 2}, 4, 4), named_block("", {2.5, 0}, {2, 2}, 4, 4));
  all.push_back({"a body of two loose pieces",
                 pressed(apart, both),
                 Said::Plan,
                 {"body 'block' consists of 2 loose pieces", "16 cells around (1, 1)",
                  "16 cells around (3.5, 1)", "share the nodes"},
                 pressed(whole, both)});
  all.push_back({"a piece that nothing holds",
                 pressed(apart, {fixed("bottom")}),
                 Said::Error,
                 {"can move freely in direction x", "add a support", "2 loose pieces"},
                 pressed(whole, {fixed("bottom")})});
  all.push_back({"nodes that coincide and are not joined",
                 pressed(split_block(0.5, 2), both),
                 Said::Plan,
                 {"3 nodes coincide with others", "(2, 1)", "unless a crack is meant", "Coherence"},
                 pressed(whole, both)});
  all.push_back({"hanging nodes",
                 pressed(hanging_block(2), both),
                 Said::Plan,
                 {"2 nodes hang on the side of a cell", "at (1, 0.25)", "have the same nodes"},
                 pressed(hanging_block(1), both)});
}

void add_load_warnings(std::vector<DoubtfulScene>& all) {
  const Scene sound = with(block(), [](Scene& s) {
    s.bodies[0].loads.edges.push_back(
        traction("top", [](const Vector2d& x) { return Vector2d(0, x.x() - 2); }));  // a moment
    s.bodies[0].loads.body_force = [](const Vector2d&) { return Vector2d(0, -0.1); };
  });
  all.push_back({"a load that is zero everywhere",
                 with(block(),
                      [](Scene& s) {
                        s.bodies[0].loads.edges.push_back(
                            traction("right", [](const Vector2d&) { return Vector2d(0, 0); }));
                      }),
                 Said::Plan,
                 {"load on 'right' of 'block' is zero everywhere"},
                 sound});
  all.push_back({"a load that integrates to zero",
                 with(block(),
                      [](Scene& s) {
                        s.bodies[0].loads.edges = {traction("top", [](const Vector2d& x) {
                          return Vector2d(0, std::cos(pi * x.x()));
                        })};
                      }),
                 Said::Plan,
                 {"load on 'top' of 'block'", "no force and no moment", "signs"},
                 sound});
  all.push_back({"a weight of zero",
                 with(block(),
                      [](Scene& s) {
                        s.bodies[0].loads.body_force = [](const Vector2d&) {
                          return Vector2d(0, 0);
                        };
                      }),
                 Said::Plan,
                 {"body force on 'block' is zero everywhere"},
                 sound});
}

void add_contact_warnings(std::vector<DoubtfulScene>& all) {
  const Scene beam = cantilever("q4_incompatible", 20, 2);
  const Scene blocks = stacked_blocks();
  all.push_back({"an obstacle listed twice",
                 with(beam, [](Scene& s) { s.contacts.push_back(s.contacts[0]); }),
                 Said::Error,
                 {"contacts 1 and 2", "the same sides", "'bottom' of 'beam'"},
                 beam});
  const Side lower{"top", "lower"};
  all.push_back({"a contact listed twice",
                 with(blocks, [](Scene& s) { s.contacts.push_back(s.contacts[0]); }),
                 Said::Error,
                 {"contacts 1 and 2", "leave one of them out"},
                 blocks});
  all.push_back({"a contact listed again the other way round",
                 with(blocks,
                      [&](Scene& s) {
                        s.contacts.push_back({lower, Side{"bottom", "upper"}});
                      }),
                 Said::Error,
                 {"contacts 1 and 2", "the same sides"},
                 blocks});
  all.push_back({"an obstacle whose normal points inward",
                 with(beam,
                      [](Scene& s) {
                        s.contacts[0].target = half_plane({0, -1}, {0, -1});
                      }),
                 Said::Error,
                 {"in front of the half plane", "turn the normal round"},
                 beam});
  all.push_back({"an obstacle that touches and whose normal points inward",
                 with(confined(1),
                      [](Scene& s) {
                        s.contacts[0].target = half_plane({0, 0}, {0, -1});
                      }),
                 Said::Error,
                 {"in front of the half plane", "points away from the body"},
                 confined(1)});
  all.push_back({"a disc for a hole",
                 shaft(disc({0, 0}, 1.01)),
                 Said::Error,
                 {"in front of the disc", "a hole for a disc"},
                 shaft(hole({0, 0}, 1.01))});
  all.push_back({"a boundary that looks away from the obstacle",
                 with(beam,
                      [](Scene& s) {
                        s.contacts.push_back({{"top"}, half_plane({0, -2}, {0, 1})});
                      }),
                 Said::Plan,
                 {"'top' of 'beam'", "no node of the boundary faces the half plane"},
                 beam});
  all.push_back({"nothing that touches",
                 with(beam,
                      [](Scene& s) {
                        s.contacts[0].target = half_plane({0, -20}, {0, 1});
                      }),
                 Said::Solution,
                 {"no pair carries a force", "smallest gap left", "direction of the load"},
                 beam});
  all.push_back({"a source that passes through a thin target",
                 disc_on_plate(0.2),
                 Said::Plan,
                 {"source nodes lie behind the target", "has passed through"},
                 disc_on_plate(1e-3)});
}

/// A quarter of a round pin with a bore in a quarter of a bush, between which there is a clearance.
Scene pin_in_bush(Eigen::Index pin_edges, Eigen::Index bush_edges) {
  Scene scene;
  scene.bodies.resize(2);
  AnnulusSpec spec;
  spec.sector = Sector::Quarter;
  spec.cells_radius = 2;
  for (std::size_t b : {0, 1}) {
    spec.name = b == 0 ? "pin" : "bush";
    spec.inner_radius = b == 0 ? 0.5 : 1.0001;
    spec.outer_radius = b == 0 ? 1 : 2;
    spec.cells_angle = b == 0 ? pin_edges : bush_edges;
    scene.bodies[b].mesh = make_annulus(spec);
    scene.bodies[b].material = {1000, 0.3, PlaneState::Strain, 1};
    scene.bodies[b].supports = {symmetric("symmetry"), symmetric("symmetry_y")};
  }
  scene.bodies[0].loads.edges = {{"inner", 1, {}}};
  scene.contacts = {{{"outer", "pin"}, Side{"inner", "bush"}}};
  return scene;
}

void add_fit_warnings(std::vector<DoubtfulScene>& all) {
  const auto on_floor = [](double gap, double adjust, double interference) {
    return with(confined(1), [=](Scene& s) {
      s.contacts[0].target = half_plane({0, -gap}, {0, 1});
      s.contacts[0].adjust = adjust;
      s.contacts[0].interference = interference;
    });
  };
  all.push_back({"gaps that are adjusted by more than the body is thick",
                 on_floor(0.5, 10, 0),
                 Said::Plan,
                 {"adjusted gaps of the contact of 'bottom' of 'block'", "10 is more", "there, 2"},
                 on_floor(0.5, 0.6, 0)});
  all.push_back({"an interference larger than the body is thick",
                 on_floor(0, 0, 3),
                 Said::Plan,
                 {"interference of the contact of 'bottom' of 'block'", "3 is more", "there, 2"},
                 on_floor(0, 0, 1.9)});
  all.push_back({"a gap of a thousand sizes of the body",
                 on_floor(1000 * std::hypot(4.0, 2.0), 0, 0),
                 Said::Solution,
                 {"has closed a gap of 4472", "1000 times the size of 'block'", "units"},
                 on_floor(0.9 * std::hypot(4.0, 2.0), 0, 0)});
  all.push_back({"edges with more sag than clearance",
                 pin_in_bush(4, 5),
                 Said::Plan,
                 {"straight edges of the target", "within the curve", "same nodes"},
                 pin_in_bush(4, 4)});
}

void add_limits(std::vector<DoubtfulScene>& all) {
  all.push_back({"a large strain",
                 squeezed(0.1),
                 Said::Solution,
                 {"takes deformations for small", "strain 10 %", "smaller load"},
                 squeezed(0.01)});
  const double five_degrees = 6 * 1000 / (1 - 0.3 * 0.3) * std::pow(0.5, 3) / 12 / std::pow(50, 3) *
                              5 * pi / 180;  // of a beam: p = 6 E I / L^3 times the angle
  all.push_back({"a large rotation",
                 slender(1.2 * five_degrees),
                 Said::Solution,
                 {"takes deformations for small", "are not: rotation 5.9", "of 'beam' at (49.5"},
                 slender(0.9 * five_degrees)});
  all.push_back(
      {"a pressure that the body does not have",
       confined(200),
       Said::Solution,
       {"takes deformations for small", "are not: contact pressure 0.2 of Young's modulus"},
       confined(50)});
  all.push_back({"a pressure in other units than the stiffness",
                 cantilever("q4_incompatible", 20, 2, 3.6e6),
                 Said::Plan,
                 {"load on 'top'", "171.4", "times Young's modulus", "units"},
                 cantilever("q4_incompatible", 20, 2)});
  all.push_back({"a load a million times too large",
                 cantilever("q4_incompatible", 20, 2, 3.6e6),
                 Said::Solution,
                 {"strain ", "rotation ", "units", "Young's modulus"},
                 cantilever("q4_incompatible", 20, 2)});
}

}  // namespace

std::vector<DoubtfulScene> doubtful_scenes() {
  std::vector<DoubtfulScene> all;
  add_mesh_warnings(all);
  add_load_warnings(all);
  add_contact_warnings(all);
  add_fit_warnings(all);
  add_limits(all);
  return all;
}

}  // namespace signorini_test
