#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "signorini/core/rounding.hpp"
#include "support/mesh_measures.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::RowVector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

DiscSpec even(DiscPart part, MeshOrder order) {
  DiscSpec spec;
  spec.centre = {1, -2};
  spec.radius = 3;
  spec.part = part;
  spec.order = order;
  return spec;
}

PressedDiscSpec pressed(DiscPart part, MeshOrder order) {
  PressedDiscSpec spec;
  spec.pole = {0, -2};
  spec.radius = 50;
  spec.core = {1.4, 1.2};
  spec.core_columns = 7;
  spec.core_rows = 6;
  spec.layers = 9;
  spec.part = part;
  spec.order = order;
  return spec;
}

double part_of(DiscPart part) {
  return part == DiscPart::LowerRight ? 0.25 : part == DiscPart::Right ? 0.5 : 1;
}

std::vector<std::string> rim_of(DiscPart part) {
  if (part == DiscPart::LowerRight) return {"axis", "rim", "middle"};
  if (part == DiscPart::Right) return {"axis", "rim"};
  return {"rim"};
}

DiscPart any_part() { return GENERATE(DiscPart::LowerRight, DiscPart::Right, DiscPart::Full); }

MeshOrder any_order() { return GENERATE(MeshOrder::Linear, MeshOrder::Quadratic); }

}  // namespace

TEST_CASE("an even disc has good cells, all its nodes, and one rim with the body inside",
          "[disc]") {
  const DiscPart part = any_part();
  const MeshOrder order = any_order();
  const Mesh mesh = make_disc(even(part, order));
  const MeshQuality quality = check_mesh(mesh);
  CHECK(quality.smallest_jacobian_ratio > 0.6);
  CHECK(quality.largest_aspect_ratio < 3.2);
  CHECK(mesh.n_nodes() == nodes_if_joined(mesh, rim_of(part)));
  CHECK(is_rim(mesh, rim_of(part)));
  CHECK(mesh.boundaries.size() == rim_of(part).size());
  for (const Index node : boundary_nodes(mesh, "rim"))
    CHECK((mesh.nodes.row(node) - RowVector2d(1, -2)).norm() == Approx(3).epsilon(1e-15));
}

TEST_CASE("a pressed disc has good cells, all its nodes, and one rim with the body inside",
          "[disc]") {
  const DiscPart part = any_part();
  const MeshOrder order = any_order();
  const Mesh mesh = make_pressed_disc(pressed(part, order));
  const MeshQuality quality = check_mesh(mesh);
  CHECK(quality.smallest_jacobian_ratio > 0.55);
  CHECK(quality.largest_aspect_ratio < 6);
  CHECK(mesh.n_nodes() == nodes_if_joined(mesh, rim_of(part)));
  CHECK(is_rim(mesh, rim_of(part)));
  for (const Index node : boundary_nodes(mesh, "rim"))
    CHECK((mesh.nodes.row(node) - RowVector2d(0, 48)).norm() == Approx(50).epsilon(1e-15));
}

TEST_CASE("areas and rims of quadratic discs: errors fall with the fourth power", "[disc]") {
  const DiscPart part = any_part();
  double area_error = 0;
  double rim_error = 0;
  for (const Index refinement : {1, 2}) {
    DiscSpec spec = even(part, MeshOrder::Quadratic);
    spec.core_cells *= refinement;
    spec.layers *= refinement;
    const Mesh mesh = make_disc(spec);
    const double area = std::abs(area_of(mesh) / (part_of(part) * 9 * pi) - 1);
    const double rim = std::abs(length_of(mesh, "rim") / (part_of(part) * 6 * pi) - 1);
    if (refinement == 2) {
      CHECK(area == Approx(area_error / 16).epsilon(0.1).margin(0));  // h is not small yet
      CHECK(rim == Approx(rim_error / 16).epsilon(0.1).margin(0));
      CHECK(area < 3e-6);
    }
    area_error = area;
    rim_error = rim;
  }
  const Mesh curved = make_pressed_disc(pressed(part, MeshOrder::Quadratic));
  CHECK(area_of(curved) == Approx(part_of(part) * 2500 * pi).epsilon(2e-4).margin(0));
}

TEST_CASE("halves of discs mirror each other to the last bit", "[disc]") {
  const MeshOrder order = any_order();
  DiscSpec spec = even(DiscPart::Full, order);
  spec.centre.setZero();
  const Mesh disc = make_disc(spec);
  CHECK(is_symmetric(disc, [](const RowVector2d& x) { return RowVector2d(-x.x(), x.y()); }));
  CHECK(is_symmetric(disc, [](const RowVector2d& x) { return RowVector2d(x.x(), -x.y()); }));
  const Mesh between_plates = make_pressed_disc(pressed(DiscPart::Full, order));
  CHECK(is_symmetric(between_plates,
                     [](const RowVector2d& x) { return RowVector2d(-x.x(), x.y()); }));
}

TEST_CASE("axis and middle are exactly straight", "[disc]") {
  const MeshOrder order = any_order();
  const Mesh mesh = make_pressed_disc(pressed(DiscPart::LowerRight, order));
  for (const Index node : boundary_nodes(mesh, "axis")) CHECK(mesh.nodes(node, 0) == 0);
  for (const Index node : boundary_nodes(mesh, "middle")) CHECK(mesh.nodes(node, 1) == 48);
  CHECK(mesh.nodes.row(boundary_nodes(mesh, "rim").front()) == RowVector2d(0, -2));
  CHECK((mesh.nodes.row(boundary_nodes(mesh, "middle").front()) - RowVector2d(50, 48)).norm() <
        1e-13);
  const Mesh disc = make_disc(even(DiscPart::LowerRight, order));
  for (const Index node : boundary_nodes(disc, "axis")) CHECK(disc.nodes(node, 0) == 1);
  for (const Index node : boundary_nodes(disc, "middle")) CHECK(disc.nodes(node, 1) == -2);
}

TEST_CASE("the core of a pressed disc has even nodes on rim and axis", "[disc]") {
  PressedDiscSpec spec = pressed(DiscPart::LowerRight, MeshOrder::Quadratic);
  spec.pole.setZero();
  const Mesh mesh = make_pressed_disc(spec);
  const std::vector<Index> rim = boundary_nodes(mesh, "rim");
  for (std::size_t k = 0; k <= 14; ++k) {
    const double x = 0.1 * static_cast<double>(k);
    CHECK(mesh.nodes(rim[k], 0) == Approx(x).epsilon(1e-14).margin(1e-300));
    // The height of the rim is relatively exact: it is the gap of a contact.
    CHECK(mesh.nodes(rim[k], 1) ==
          Approx(x * x / (50 + std::sqrt(2500 - x * x))).epsilon(1e-14).margin(1e-300));
  }
  std::vector<Index> axis = boundary_nodes(mesh, "axis");
  for (std::size_t k = 0; k <= 12; ++k)
    CHECK(mesh.nodes(axis[axis.size() - 1 - k], 1) ==
          Approx(0.1 * static_cast<double>(k)).epsilon(1e-14).margin(1e-300));
}

TEST_CASE("discs that cannot be made are refused by name", "[disc]") {
  const auto message = [](auto&& change) {
    DiscSpec spec;
    spec.name = "coin";
    change(spec);
    return argument_message([&] { static_cast<void>(make_disc(spec)); });
  };
  CHECK_THAT(message([](DiscSpec& s) { s.radius = 0; }),
             ContainsSubstring("make_disc 'coin': radius must be positive, got 0"));
  CHECK_THAT(message([](DiscSpec& s) { s.core = 1; }), ContainsSubstring("core must be"));
  CHECK_THAT(message([](DiscSpec& s) { s.core = 0.8; }),
             ContainsSubstring("a core of 0.8 needs a core_roundness above 0.6, got 0.5"));
  CHECK_THAT(message([](DiscSpec& s) { s.core_roundness = 1; }), ContainsSubstring("roundness"));
  CHECK_THAT(message([](DiscSpec& s) { s.layers = 0; }),
             ContainsSubstring("at least 1, got 4 and 0"));
  CHECK_THAT(message([](DiscSpec& s) { s.layer_grading = -1; }), ContainsSubstring("got -1"));
  const auto pressed_message = [](auto&& change) {
    PressedDiscSpec spec;
    change(spec);
    return argument_message([&] { static_cast<void>(make_pressed_disc(spec)); });
  };
  using Spec = PressedDiscSpec;
  CHECK_THAT(pressed_message([](Spec& s) { s.core.x() = 25; }),
             ContainsSubstring("half the radius, 25, got 25"));
  CHECK_THAT(pressed_message([](Spec& s) { s.core.y() = 0; }), ContainsSubstring("got 1 and 0"));
  CHECK_THAT(pressed_message([](Spec& s) { s.core_rows = 0; }), ContainsSubstring("8, 0 and 10"));
  CHECK_THAT(pressed_message([](Spec& s) { s.layer_grading = 0; }), ContainsSubstring("layer_gr"));
  CHECK_THAT(pressed_message([](Spec& s) { s.pole.x() = std::numeric_limits<double>::infinity(); }),
             ContainsSubstring("make_pressed_disc 'disc'"));
}
