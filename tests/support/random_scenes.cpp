#include "support/random_scenes.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "addons/equations/bonds.hpp"
#include "meshes/split.hpp"
#include "signorini/core/errors.hpp"
#include "support/far.hpp"
#include "support/random_moving.hpp"
#include "support/random_paths.hpp"
#include "support/random_wrongs.hpp"

namespace signorini_test {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

/// Draws one scene: every member function draws a part of it and says so in the text.
class Drawing {
 public:
  Drawing(std::uint64_t seed, RandomScenes kind) : draw_(seed), kind_(kind) {
    scene_.bodies.clear();
  }
  RandomScene drawn();

 private:
  void one_body();
  void two_bodies();
  void symmetric_half();
  void rings();
  void vary(Body& body);
  void vary(ContactSpec& contact);

  /// Holds one node of a boundary.
  Support at_node(const Body& body, const std::string& boundary, int place, Axis axis);
  /// What holds a block that lies on something, if anything does.
  void hold(Body& block);
  void hold_ring(Body& ring, const std::string& boundary, Sector sector);
  /// \param far  boundary that is pressed \param beside  one that is pressed as well, sometimes
  void load(Body& body, const char* far, const char* beside);
  void add_weight(Body& body);
  void add_contact(const Side& source, std::variant<Obstacle, Side> target);
  void draw_operator(ContactSpec& contact);
  Friction draw_friction();
  void walls(const std::string& body);
  /// Puts triangles in the place of quadrilaterals.
  void cut();

  Draws draw_;
  [[nodiscard]] bool has_friction() const { return kind_ == RandomScenes::Frictional || varies(); }

  [[nodiscard]] bool varies() const {
    return kind_ == RandomScenes::Varied || kind_ == RandomScenes::Paths;
  }

  RandomScenes kind_;
  Scene scene_;
  std::optional<RandomBodies> make_;
};

Support Drawing::at_node(const Body& body, const std::string& boundary, int place, Axis axis) {
  const std::vector<Eigen::Index> nodes = boundary_nodes(body.mesh, boundary);
  const std::size_t node = static_cast<std::size_t>(place) % nodes.size();
  return prescribed_at(boundary, body.mesh.nodes.row(nodes[node]), axis);
}

void Drawing::hold(Body& block) {
  const int how = draw_.whole(0, 9);
  double push = 0;
  if (!draw_.chance(6)) push = -make_->length * make_->load * draw_.sixteenths(1, 32);
  draw_.say("; '", block.mesh.name, "' held ", how, ", pushed ", push);
  if (how == 0) block.supports = {fixed("left")};
  if (how == 1) block.supports = {prescribed("top", Axis::X, 0), prescribed("top", Axis::Y, push)};
  if (how == 2)
    block.supports = {prescribed("top", Axis::Y, push), at_node(block, "top", 0, Axis::X)};
  if (how == 3) block.supports = {prescribed("top", Axis::X, push)};
  if (how == 4 && make_->direction.y() == 0) block.supports = {symmetric("left")};
  if (how >= 5 && how <= 7)
    block.supports = {at_node(block, how == 7 ? "left" : "top", draw_.whole(0, 9), Axis::X)};
  if (how == 8) walls(block.mesh.name);
}

void Drawing::hold_ring(Body& ring, const std::string& boundary, Sector sector) {
  if (sector != Sector::Full) ring.supports = {symmetric("symmetry")};
  if (sector == Sector::Quarter) ring.supports.push_back(symmetric("symmetry_y"));
  if (sector == Sector::Full && !draw_.chance(2))
    ring.supports = {at_node(ring, boundary, 0, Axis::Y)};
  if (sector != Sector::Quarter && draw_.chance(10))
    ring.supports.push_back(at_node(ring, boundary, 0, Axis::X));
}

void Drawing::load(Body& body, const char* far, const char* beside) {
  double pressure = make_->stress * make_->load;
  pressure *= draw_.chance(1) ? -draw_.sixteenths(1, 8) : draw_.sixteenths(4, 32);
  const bool drags = draw_.chance(has_friction() ? 10 : 4);
  Vector2d drag(0, 0);
  if (drags) drag = pressure * make_->turned({draw_.sixteenths(-16, 16), 0});
  const int what = draw_.whole(0, 7);
  draw_.say("; '", body.mesh.name, "' loaded ", what, ", pressure ", pressure, ", drag (",
            drag.transpose(), ")");
  if (what != 1) body.loads.edges.push_back({far, pressure, {}});
  if (what != 1 && drags)
    body.loads.edges.back().traction = [drag](const Vector2d&) { return drag; };
  if (what == 2) body.loads.edges.push_back({beside, pressure * draw_.sixteenths(-16, 16), {}});
  if (what != 1 && what != 3) return;
  const double aside = drags ? draw_.sixteenths(-8, 8) : 0;
  const Vector2d pull = pressure / make_->length * make_->turned({aside, -draw_.sixteenths(4, 16)});
  body.loads.body_force = [pull](const Vector2d&) { return pull; };
}

void Drawing::add_weight(Body& body) {
  if (body.loads.body_force) return;
  const Vector2d weight = make_->stress * make_->load / make_->length * make_->turned({0, -1});
  body.loads.body_force = [weight](const Vector2d&) { return weight; };
}

void Drawing::draw_operator(ContactSpec& contact) {
  Side& target = std::get<Side>(contact.target);
  if (draw_.chance(6)) std::swap(contact.source, target);
  contact.gap_operator =
      draw_.pick<const char*>({"mortar", "mortar", "node_to_segment", "gauss_points"});
  const GapOperator& how = find_gap_operator(contact.gap_operator);
  if (how.takes_points && !draw_.chance(8)) contact.points = draw_.whole(1, 5);
  if (how.takes_quadrature && draw_.chance(5)) contact.quadrature = Quadrature::SourceEdges;
  draw_.say("; '", contact.source.body, "' touches by ", how.name, ' ', contact.points,
            contact.quadrature == Quadrature::Segments ? " segments" : " edges");
}

Friction Drawing::draw_friction() {
  Friction friction;
  friction.coefficient =
      draw_.pick({1e-6, 1e-3, 0.1, 0.2, 0.3, 0.3, 0.5, 0.5, 0.7, 1.0, 2.0, 10.0, 100.0, 1e4});
  if (draw_.chance(4)) {
    friction.cohesion = make_->stress * make_->load * draw_.decade(-3, 1);
    friction.cohesion *= draw_.sixteenths(8, 24);
    if (friction.cohesion > 0 && draw_.chance(4)) friction.coefficient = 0;
  }
  draw_.say("; mu ", friction.coefficient, ", c ", friction.cohesion);
  return friction;
}

void Drawing::add_contact(const Side& source, std::variant<Obstacle, Side> target) {
  ContactSpec contact;
  contact.source = source;
  contact.target = std::move(target);
  if (std::holds_alternative<Side>(contact.target)) draw_operator(contact);
  const bool rough = scene_.contacts.empty() || draw_.chance(8);
  if (has_friction() && rough) contact.friction = draw_friction();
  scene_.contacts.push_back(std::move(contact));
}

void Drawing::walls(const std::string& body) {
  const double gap = draw_.chance(8) ? 0 : draw_.decade(-4, -2);
  draw_.say("; walls ", gap, " aside");
  add_contact({"left", body}, half_plane(make_->placed({-gap, 0}), make_->turned({1, 0})));
  if (draw_.chance(8))
    add_contact({"right", body},
                half_plane(make_->placed({make_->width + gap, 0}), make_->turned({-1, 0})));
}

void Drawing::one_body() {
  make_.emplace(draw_, false);
  const bool round = draw_.chance(4);
  scene_.bodies.push_back(round ? make_->full_disc("disc") : make_->block_above("block"));
  Body& body = scene_.bodies.back();
  const Side side{round ? "rim" : "bottom", body.mesh.name};
  if (round || draw_.chance(10)) {
    draw_.say("; on a plane");
    add_contact(side, half_plane(make_->placed({0, -make_->gap}), make_->turned({0, 1})));
  } else {
    const double radius = draw_.sixteenths(8, 80);
    const Vector2d centre(make_->width * draw_.sixteenths(0, 16), -make_->gap - radius);
    draw_.say("; on a disc of ", radius, " around (", centre.transpose(), ")");
    add_contact(side, disc(make_->placed(centre), make_->length * radius));
  }
  if (!round) {
    hold(body);
    load(body, "top", "right");
    return;
  }
  if (draw_.chance(4)) {
    draw_.say(" and under one");
    add_contact(side, half_plane(make_->placed({0, make_->width}), make_->turned({0, -1})));
  }
  const int how = draw_.whole(0, 7);
  draw_.say("; rim held ", how);
  if (how != 0) body.supports = {at_node(body, "rim", how == 1 ? draw_.whole(0, 9) : 0, Axis::X)};
  if (how == 7) body.supports.push_back(at_node(body, "rim", 4, Axis::Y));
  load(body, "rim", "rim");
  add_weight(body);
}

void Drawing::two_bodies() {
  make_.emplace(draw_, false);
  const bool round = draw_.chance(4);
  scene_.bodies.push_back(round ? make_->full_disc("upper") : make_->block_above("upper"));
  scene_.bodies.push_back(make_->block_below("lower"));
  Body& upper = scene_.bodies.front();
  Body& lower = scene_.bodies.back();
  add_contact({round ? "rim" : "bottom", "upper"}, Side{"top", "lower"});
  if (round) {
    if (!draw_.chance(1)) upper.supports = {at_node(upper, "rim", 0, Axis::X)};
    load(upper, "rim", "rim");
    add_weight(upper);
  } else {
    hold(upper);
    load(upper, "top", "right");
  }
  const int how = draw_.whole(0, 7);
  draw_.say("; 'lower' held ", how);
  if (how >= 2) {
    lower.supports = {fixed("bottom")};
    return;
  }
  lower.supports = {at_node(lower, "bottom", 0, Axis::X)};
  const Vector2d corner = lower.mesh.nodes.row(boundary_nodes(lower.mesh, "bottom").front());
  if (how == 1)
    lower.supports.push_back(prescribed("bottom", Axis::Y, 0));
  else
    add_contact({"bottom", "lower"}, half_plane(corner, make_->turned({0, 1})));
}

/// The right half of a body on a half-space.
void Drawing::symmetric_half() {
  make_.emplace(draw_, true);
  const bool round = draw_.chance(8);
  scene_.bodies.push_back(round ? make_->quarter_disc("upper") : make_->block_above("upper"));
  scene_.bodies.push_back(make_->half_space("lower"));
  Body& upper = scene_.bodies.front();
  add_contact({round ? "rim" : "bottom", "upper"}, Side{"surface", "lower"});
  load(upper, round ? "rim" : "top", round ? "rim" : "right");
  if (round)
    add_weight(upper);
  else
    upper.supports = {symmetric("left")};
}

/// A ring on a pin, in a hole, or in another ring.
void Drawing::rings() {
  make_.emplace(draw_, true);
  const Sector sector = draw_.pick({Sector::Quarter, Sector::Half, Sector::Full, Sector::Full});
  const int what = draw_.whole(0, 2);
  const double gap = make_->gap;
  const double outer = draw_.sixteenths(12, 24);
  const double inner = outer * (1 - draw_.pick({0.0625, 0.25, 0.5}));
  scene_.bodies.push_back(make_->ring("ring", inner, outer, sector));
  if (what == 2) {
    const double around = outer * (1 + draw_.pick({0.0625, 0.5, 2.0}));
    scene_.bodies.push_back(make_->ring("around", outer + gap, around + gap, sector));
  }
  const double aside = draw_.chance(8) ? 0 : gap * draw_.sixteenths(-16, 16);
  draw_.say("; ring ", what, ", sector ", static_cast<int>(sector), ", aside ", aside);
  const Vector2d centre = make_->placed({aside, 0});
  if (what == 0) add_contact({"inner", "ring"}, disc(centre, make_->length * (inner - gap)));
  if (what == 1) add_contact({"outer", "ring"}, hole(centre, make_->length * (outer + gap)));
  if (what == 2) add_contact({"outer", "ring"}, Side{"inner", "around"});
  for (Body& body : scene_.bodies) {
    const char* free = what == 0 || body.mesh.name == "around" ? "outer" : "inner";
    hold_ring(body, free, sector);
    load(body, free, free);
  }
}

void Drawing::vary(Body& body) {
  const std::string& boundary = body.mesh.boundaries.begin()->first;
  const std::vector<Eigen::Index> nodes = boundary_nodes(body.mesh, boundary);
  const auto some_node = [&]() -> Vector2d {
    return body.mesh.nodes.row(nodes[static_cast<std::size_t>(draw_.whole(0, 99)) % nodes.size()]);
  };
  const double length = make_->length;
  if (draw_.chance(5)) {
    const double force = make_->stress * make_->load * length * length * draw_.sixteenths(-16, 16);
    body.loads.points = {{some_node(), make_->turned({0, force})}};
    draw_.say("; force ", force);
  }
  if (draw_.chance(5)) {
    body.material.expansion = 1;
    body.temperature = Temperature{make_->load * draw_.sixteenths(-4, 16), {0, 0}};
    if (draw_.chance(8)) body.temperature->gradient = make_->load / length * Vector2d(1, -0.5);
    draw_.say("; warmer by ", body.temperature->uniform);
  }
  if (draw_.chance(5)) {
    for (Eigen::Index cell = 0; cell < body.mesh.n_cells(); ++cell)
      if (draw_.chance(8)) body.mesh.regions["other"].push_back(cell);
    Material other = body.material;
    other.youngs_modulus *= draw_.decade(-4, 4);
    other.poisson_ratio = draw_.pick({0.0, 0.3, 0.49});
    if (!body.mesh.regions.empty()) body.layers = {{"other", other}};
    draw_.say("; layer E ", other.youngs_modulus, ", nu ", other.poisson_ratio);
  }
  if (draw_.chance(5)) {
    const double stiffness = make_->stress / length * draw_.decade(-3, 3);
    body.springs = {{boundary, {stiffness, draw_.chance(8) ? stiffness : 0}}};
    if (draw_.chance(8))
      body.springs[0] = {boundary, length * length * body.springs[0].stiffness, some_node()};
    draw_.say("; springs ", body.springs[0].stiffness.transpose());
  }
}

void Drawing::vary(ContactSpec& contact) {
  if (draw_.chance(4)) contact.interference = make_->length * draw_.decade(-5, -2);
  if (draw_.chance(4)) contact.adjust = make_->length * draw_.decade(-5, -2);
  draw_.say("; interference ", contact.interference.value_or(0), ", adjust ",
            contact.adjust.value_or(0));
}

void Drawing::cut() {
  Index step = 1;
  for (Body& body : scene_.bodies) {
    std::vector<Index> cells;
    for (Index cell = 0; cell < body.mesh.n_cells(); cell += step) cells.push_back(cell);
    body.mesh = split(body.mesh, cells);
    if (step == 1) body.element.clear();
    step = 2;
  }
  draw_.say("; in triangles");
}

RandomScene Drawing::drawn() {
  const int what = draw_.whole(0, 15);
  if (what < 5)
    one_body();
  else if (what < 10)
    two_bodies();
  else if (what < 12)
    symmetric_half();
  else
    rings();
  if (varies()) {
    for (Body& body : scene_.bodies) vary(body);
    for (ContactSpec& contact : scene_.contacts) vary(contact);
  }
  const bool path = kind_ == RandomScenes::Paths;
  if (kind_ == RandomScenes::Triangles || (path && draw_.chance(4))) cut();
  if (path) add_path(draw_, scene_);
  return {std::move(scene_), std::move(draw_.text)};
}

/// The scene as the cross-section of bodies of revolution, `off` sizes away from the axis.
RandomScene revolved(RandomScene plane, double off) {
  double lowest = plane.scene.bodies.front().mesh.nodes(0, 0);
  for (const Body& body : plane.scene.bodies)
    lowest = std::min(lowest, body.mesh.nodes.col(0).minCoeff());
  RandomScene round{moved(plane.scene, {off * size_of(plane.scene) - lowest, 0}),
                    text(plane.text, "; revolved ", off, " sizes off the axis")};
  for (Body& body : round.scene.bodies) {
    body.material.state = PlaneState::Axial;
    body.material.thickness = 1;
    for (Layer& layer : body.layers) {
      layer.material.state = PlaneState::Axial;
      layer.material.thickness = 1;
    }
  }
  return round;
}

/// The scene with ties in the place of contacts between two bodies, every third one of which slides.
RandomScene tied(RandomScene loose, std::uint64_t seed) {
  auto bonds = std::make_shared<Bonds>();
  std::vector<ContactSpec> others;
  for (ContactSpec contact : loose.scene.contacts) {
    if (std::holds_alternative<Obstacle>(contact.target)) {
      others.push_back(contact);
      continue;
    }
    contact.friction.reset();
    contact.interference.reset();
    contact.adjust.reset();
    bonds->ties.push_back({contact, seed % 3 == 0, seed % 4 == 0});
  }
  loose.scene.contacts = others;
  if (!bonds->ties.empty()) loose.scene.bonds = bonds;
  loose.text += "; tied";
  return loose;
}

}  // namespace

RandomScene random_scene(std::uint64_t seed, RandomScenes kind) {
  if (kind == RandomScenes::Any) {
    Draws draw(~seed);
    const auto plain =
        draw.pick({RandomScenes::Frictionless, RandomScenes::Frictional, RandomScenes::Varied,
                   RandomScenes::Revolved, RandomScenes::Triangles, RandomScenes::Paths});
    RandomScene drawn = random_scene(seed, plain);
    drawn.wrong = spoil(draw, drawn.scene);
    drawn.text += draw.text;
    return drawn;
  }
  if (kind == RandomScenes::Moving) {
    Draws draw(seed);
    Scene scene = random_moving(draw);
    return {std::move(scene), std::move(draw.text)};
  }
  if (kind == RandomScenes::Tied) return tied(random_scene(seed, RandomScenes::Varied), seed);
  const bool path = kind == RandomScenes::Paths;
  RandomScene plane =
      Drawing(seed, kind == RandomScenes::Revolved ? RandomScenes::Frictionless : kind).drawn();
  if (kind != RandomScenes::Revolved && !(path && seed % 5 == 0)) return plane;
  const double off[] = {0, 0.25, 3};
  return revolved(std::move(plane), off[seed % 3]);
}

}  // namespace signorini_test
