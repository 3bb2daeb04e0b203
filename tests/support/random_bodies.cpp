#include "support/random_bodies.hpp"

#include <utility>

#include "meshes/disc.hpp"
#include "meshes/half_space.hpp"
#include "meshes/ring.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"

namespace signorini_test {

using Eigen::Vector2d;
using namespace signorini;

double Draws::decade(int low, int high) {
  const int exponent = random_.whole(low, high);
  double power = 1;
  for (int k = 0; k < exponent; ++k) power *= 10;
  for (int k = 0; k > exponent; --k) power *= 10;
  return exponent < 0 ? 1 / power : power;
}

RandomBodies::RandomBodies(Draws& draws, bool straight) : draw_(draws) {
  if (draw_.chance(4)) length = draw_.decade(-6, 6);
  if (draw_.chance(4)) stress = draw_.decade(-6, 6);
  if (!draw_.chance(1)) {
    load = draw_.decade(-4, -1);
    load *= draw_.sixteenths(8, 40);
  } else {
    load = 0;
  }
  if (!straight && draw_.chance(4))
    direction =
        draw_.pick<Vector2d>({{0.6, 0.8}, {5.0 / 13, 12.0 / 13}, {0, 1}, {-1, 0}, {0.96, 0.28}});
  if (draw_.chance(3)) {
    const double far = length * draw_.decade(0, 4);
    shift.x() = far * draw_.sixteenths(-16, 16);
    shift.y() = far * draw_.sixteenths(-16, 16);
  }
  if (draw_.chance(5)) {
    gap = draw_.decade(-5, -1);
    gap *= draw_.sixteenths(8, 24);
  } else if (draw_.chance(6)) {
    gap = -draw_.decade(-5, -2);
    gap *= draw_.sixteenths(8, 24);
  }
  draw_.say("length ", length, ", stress ", stress, ", load ", load, ", turned to (",
            direction.transpose(), "), moved by (", shift.transpose(), "), gap ", gap);
}

Vector2d RandomBodies::turned(const Vector2d& v) const {
  return {direction.x() * v.x() - direction.y() * v.y(),
          direction.y() * v.x() + direction.x() * v.y()};
}

Vector2d RandomBodies::placed(const Vector2d& x) const { return length * turned(x) + shift; }

MeshOrder RandomBodies::draw_element(Body& body) {
  body.element =
      draw_.pick<const char*>({"q4", "q4_bbar", "q4_incompatible", "q4_incompatible", "q8"});
  return body.element == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear;
}

Body RandomBodies::finished(Body body, const Mesh& mesh) {
  Material& material = body.material;
  material.youngs_modulus = stress;
  if (!first_ && draw_.chance(6)) material.youngs_modulus *= draw_.decade(-6, 6);
  first_ = false;
  material.poisson_ratio = draw_.pick({0.0, 0.25, 0.3, 0.3, 0.3, 0.45, 0.49, 0.499, 0.4999});
  material.state = draw_.chance(8) ? PlaneState::Strain : PlaneState::Stress;
  material.thickness = length;
  body.mesh = mapped(mesh, [this](const Vector2d& x) { return placed(x); });
  draw_.say("; '", mesh.name, "' ", mesh.n_cells(), ' ', body.element, ", E ",
            material.youngs_modulus, ", nu ", material.poisson_ratio,
            material.state == PlaneState::Strain ? " strain" : " stress");
  return body;
}

namespace {

/// Size and cells of a block: square, or up to 300 times as wide as high.
BlockSpec drawn_block(Draws& draw, double width, const std::string& name, MeshOrder order) {
  BlockSpec spec;
  spec.name = name;
  spec.order = order;
  const double ratio = draw.pick({1.0, 1.0, 2.0, 2.0, 4.0, 10.0, 100.0, 300.0});
  spec.size.x() = width;
  spec.size.y() = width / ratio;
  spec.cells_x = ratio > 4 ? draw.whole(8, 30) : draw.whole(2, 10);
  spec.cells_y = ratio > 4 ? draw.whole(1, 2) : draw.whole(1, 5);
  if (draw.chance(4)) spec.grading_x = draw.sixteenths(4, 64);
  if (draw.chance(4)) spec.grading_y = draw.sixteenths(4, 64);
  return spec;
}

/// Radius, core and layers of a disc on the origin.
DiscSpec drawn_disc(Draws& draw, const std::string& name, int most, MeshOrder order) {
  DiscSpec spec;
  spec.name = name;
  spec.order = order;
  spec.radius = draw.sixteenths(4, 32);
  spec.centre.y() = spec.radius;
  spec.core_cells = draw.whole(1, most);
  spec.layers = draw.whole(1, most);
  return spec;
}

}  // namespace

Body RandomBodies::block_above(const std::string& name) {
  Body body;
  const MeshOrder order = draw_element(body);
  const double wide = draw_.sixteenths(8, 40);
  BlockSpec spec = drawn_block(draw_, wide, name, order);
  if (spec.size.x() > 2 * spec.size.y() && draw_.chance(3)) {
    std::swap(spec.size.x(), spec.size.y());
    std::swap(spec.cells_x, spec.cells_y);
  }
  width = spec.size.x();
  const double height = spec.size.y();
  // Parallel sides close everywhere at once; bent ones, here and there.
  double bend = 0;
  if (!draw_.chance(6)) {
    bend = draw_.decade(-4, -1);
    bend *= height * draw_.sixteenths(-16, 24);
  }
  const double middle = width * draw_.sixteenths(0, 16);
  draw_.say("; ", width, " x ", height, " bent by ", bend);
  return finished(std::move(body), mapped(make_block(spec), [&](const Vector2d& x) -> Vector2d {
                    const double s = (x.x() - middle) / width;
                    return {x.x(), x.y() + bend * s * s * (1 - x.y() / height)};
                  }));
}

Body RandomBodies::block_below(const std::string& name) {
  Body body;
  const MeshOrder order = draw_element(body);
  const double wide = width * draw_.sixteenths(12, 32);
  BlockSpec spec = drawn_block(draw_, wide, name, order);
  spec.corner.x() = -wide * draw_.sixteenths(0, 8);
  spec.corner.y() = -gap - spec.size.y();
  draw_.say("; ", spec.size.x(), " x ", spec.size.y());
  return finished(std::move(body), make_block(spec));
}

Body RandomBodies::full_disc(const std::string& name) {
  Body body;
  const MeshOrder order = draw_element(body);
  const DiscSpec spec = drawn_disc(draw_, name, 2, order);
  width = 2 * spec.radius;
  return finished(std::move(body), make_disc(spec));
}

Body RandomBodies::quarter_disc(const std::string& name) {
  Body body;
  const MeshOrder order = draw_element(body);
  DiscSpec spec = drawn_disc(draw_, name, 4, order);
  spec.part = draw_.chance(8) ? DiscPart::LowerRight : DiscPart::Right;
  body.supports = {symmetric("axis")};
  if (spec.part == DiscPart::LowerRight && draw_.chance(8))
    body.supports.push_back(
        prescribed("middle", Axis::Y, -length * load * draw_.sixteenths(1, 16)));
  return finished(std::move(body), make_disc(spec));
}

Body RandomBodies::half_space(const std::string& name) {
  Body body;
  HalfSpaceSpec spec;
  spec.name = name;
  spec.order = draw_element(body);
  spec.core_columns = draw_.whole(2, 4);
  spec.core_rows = draw_.whole(2, 4);
  spec.layers = draw_.whole(1, 4);
  spec.width = draw_.sixteenths(24, 160);
  spec.depth = spec.width;
  body.supports = {symmetric("axis"), fixed("base")};
  return finished(std::move(body), moved(make_half_space(spec), {0, -gap}));
}

Body RandomBodies::ring(const std::string& name, double inner, double outer, Sector sector) {
  Body body;
  AnnulusSpec spec;
  spec.name = name;
  spec.order = draw_element(body);
  spec.inner_radius = inner;
  spec.outer_radius = outer;
  spec.cells_angle = sector == Sector::Full ? draw_.whole(8, 24) : draw_.whole(3, 12);
  spec.cells_radius = draw_.whole(1, 3);
  spec.sector = sector;
  return finished(std::move(body), make_annulus(spec));
}

}  // namespace signorini_test
