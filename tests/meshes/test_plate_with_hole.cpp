#include <cmath>

#include "catch_compat.hpp"
#include "meshes/plate_with_hole.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/rounding.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::RowVector2d;
using namespace signorini;
using signorini_test::argument_message;

namespace {

/// Area from the corners of all cells; clockwise cells count negative.
double area_of(const Mesh& mesh) {
  double area = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int k = 0; k < 4; ++k) {
      const RowVector2d a = mesh.nodes.row(mesh.cells(cell, k));
      const RowVector2d b = mesh.nodes.row(mesh.cells(cell, (k + 1) % 4));
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  return area;
}

/// Area of a regular polygon with `n` corners on a circle.
double polygon(double radius, Index n) {
  const double corners = static_cast<double>(n);
  return 0.5 * corners * radius * radius * std::sin(2 * pi / corners);
}

PlateWithHoleSpec plate(Sector sector, MeshOrder order) {
  PlateWithHoleSpec spec;
  spec.centre = {1, -2};
  spec.hole_radius = 0.5;
  spec.size = {6, 4};
  spec.cells_angle = sector == Sector::Full ? 28 : sector == Sector::Half ? 14 : 7;
  spec.cells_radius = 3;
  spec.grading = 4;
  spec.sector = sector;
  spec.order = order;
  return spec;
}

AnnulusSpec ring(Sector sector, MeshOrder order) {
  AnnulusSpec spec;
  spec.centre = {1, -2};
  spec.inner_radius = 2;
  spec.outer_radius = 5;
  spec.cells_angle = sector == Sector::Full ? 24 : sector == Sector::Half ? 12 : 6;
  spec.cells_radius = 4;
  spec.sector = sector;
  spec.order = order;
  return spec;
}

double part_of(Sector sector) { return opening(sector) / (2 * pi); }

/// Whether every side begins where the one before it ends.
bool is_walk(const Mesh& mesh, const std::string& name) {
  const std::vector<CellSide>& sides = boundary(mesh, name);
  for (std::size_t s = 1; s < sides.size(); ++s)
    if (mesh.side_nodes(sides[s]).front() != mesh.side_nodes(sides[s - 1]).back()) return false;
  return true;
}

}  // namespace

TEST_CASE("a plate with a hole has the area of the plate less that of a polygon", "[plate]") {
  const Sector sector = GENERATE(Sector::Quarter, Sector::Half, Sector::Full);
  const MeshOrder order = GENERATE(MeshOrder::Linear, MeshOrder::Quadratic);
  const Mesh mesh = make_plate_with_hole(plate(sector, order));
  CHECK(area_of(mesh) == Approx(part_of(sector) * (24 - polygon(0.5, 28))).epsilon(1e-14));
  const MeshQuality quality = check_mesh(mesh);
  CHECK(quality.smallest_jacobian_ratio > 0.1);
  CHECK(quality.largest_aspect_ratio < 10);
}

TEST_CASE("a ring has the area of one polygon less that of another", "[annulus]") {
  const Sector sector = GENERATE(Sector::Quarter, Sector::Half, Sector::Full);
  const MeshOrder order = GENERATE(MeshOrder::Linear, MeshOrder::Quadratic);
  const Mesh mesh = make_annulus(ring(sector, order));
  const double whole = polygon(5, 24) - polygon(2, 24);
  CHECK(area_of(mesh) == Approx(part_of(sector) * whole).epsilon(1e-14));
  CHECK_NOTHROW(check_mesh(mesh));
}

TEST_CASE("nodes are counted once, also where a ring closes", "[plate][annulus]") {
  CHECK(make_plate_with_hole(plate(Sector::Half, MeshOrder::Linear)).n_nodes() == 15 * 4);
  CHECK(make_plate_with_hole(plate(Sector::Full, MeshOrder::Linear)).n_nodes() == 28 * 4);
  CHECK(make_plate_with_hole(plate(Sector::Half, MeshOrder::Quadratic)).n_nodes() ==
        15 * 7 + 14 * 4);
  const Mesh full = make_annulus(ring(Sector::Full, MeshOrder::Quadratic));
  CHECK(full.n_nodes() == 24 * 9 + 24 * 5);
  for (Index node = 0; node < full.n_nodes(); ++node)
    for (Index other = 0; other < node; ++other)
      if ((full.nodes.row(node) - full.nodes.row(other)).norm() < 0.1)
        FAIL("nodes " << node << " and " << other << " lie in one place");
}

TEST_CASE("hole and circles are round, midpoints included", "[plate][annulus]") {
  const Mesh mesh = make_plate_with_hole(plate(Sector::Full, MeshOrder::Quadratic));
  for (const Index node : boundary_nodes(mesh, "hole"))
    CHECK((mesh.nodes.row(node) - RowVector2d(1, -2)).norm() == Approx(0.5).epsilon(1e-14));
  CHECK(boundary_nodes(mesh, "hole").size() == 56);
  const Mesh disc = make_annulus(ring(Sector::Half, MeshOrder::Quadratic));
  for (const Index node : boundary_nodes(disc, "outer"))
    CHECK((disc.nodes.row(node) - RowVector2d(1, -2)).norm() == Approx(5).epsilon(1e-14));
  CHECK(boundary_nodes(disc, "inner").size() == 25);
}

TEST_CASE("the boundaries of a plate lie where their names say and are walks", "[plate]") {
  const Sector sector = GENERATE(Sector::Quarter, Sector::Half, Sector::Full);
  const MeshOrder order = GENERATE(MeshOrder::Linear, MeshOrder::Quadratic);
  const Mesh mesh = make_plate_with_hole(plate(sector, order));
  const auto check_line = [&](const char* name, int axis, double place) {
    CAPTURE(name);
    for (const Index node : boundary_nodes(mesh, name)) CHECK(mesh.nodes(node, axis) == place);
    if (name != std::string("symmetry")) CHECK(is_walk(mesh, name));
  };
  check_line("right", 0, 4);
  check_line("top", 1, 0);
  if (sector != Sector::Quarter) check_line("left", 0, -2);
  if (sector == Sector::Full) check_line("bottom", 1, -4);
  if (sector != Sector::Full) check_line("symmetry", 1, -2);  // exact: a support will ask
  if (sector == Sector::Quarter) check_line("symmetry_y", 0, 1);
  CHECK(is_walk(mesh, "hole"));
  CHECK(mesh.boundaries.size() == 5);
}

TEST_CASE("every boundary of plate and ring has the body on its left", "[plate][annulus]") {
  for (const Mesh& mesh : {make_plate_with_hole(plate(Sector::Half, MeshOrder::Linear)),
                           make_annulus(ring(Sector::Quarter, MeshOrder::Linear))})
    for (const auto& [name, sides] : mesh.boundaries)
      for (const CellSide& side : sides) {
        CAPTURE(name, side.cell);
        RowVector2d middle = RowVector2d::Zero();
        for (int k = 0; k < 4; ++k) middle += 0.25 * mesh.nodes.row(mesh.cells(side.cell, k));
        const std::vector<Index> nodes = mesh.side_nodes(side);
        const RowVector2d a = mesh.nodes.row(nodes.front());
        const RowVector2d along = mesh.nodes.row(nodes.back()) - a;
        const RowVector2d inward = middle - a;
        CHECK(along.x() * inward.y() - along.y() * inward.x() > 0);
      }
}

TEST_CASE("a corner moves the nearest ray, of two equally near ones the first", "[plate]") {
  PlateWithHoleSpec spec;
  spec.size = {4, 4};
  spec.sector = Sector::Half;
  spec.cells_angle = 15;  // rays every 12 degrees: 48 is nearest to 45, 132 to 135
  Mesh mesh = make_plate_with_hole(spec);
  CHECK(mesh.nodes.row(2 * 4 + 1) == RowVector2d(2, 2));
  CHECK(mesh.nodes.row(2 * 11 + 1) == RowVector2d(-2, 2));
  CHECK(mesh.nodes(2 * 4, 0) == Approx(std::cos(48 * pi / 180)).epsilon(1e-14));  // inner end stays
  spec.rays = rays_by_quadrant({3, 4});  // 45 lies between 30 and 60; 135 is a ray
  spec.cells_angle = 7;
  mesh = make_plate_with_hole(spec);
  CHECK(mesh.nodes.row(2 * 1 + 1) == RowVector2d(2, 2));
  CHECK(mesh.nodes.row(2 * 5 + 1) == RowVector2d(-2, 2));
}

TEST_CASE("similar cells: radii form a geometric row", "[annulus]") {
  AnnulusSpec spec = ring(Sector::Half, MeshOrder::Linear);
  spec.centre.setZero();
  spec.grading = similar_cells(5.0 / 2, 4);
  const Mesh mesh = make_annulus(spec);
  for (Index step = 0; step <= 4; ++step)
    CHECK(mesh.nodes(step, 0) ==
          Approx(2 * std::pow(2.5, static_cast<double>(step) / 4)).epsilon(1e-13));
}

TEST_CASE("plates and rings that cannot be made are refused by name", "[plate][annulus]") {
  const auto message = [](auto&& change) {
    PlateWithHoleSpec spec = plate(Sector::Half, MeshOrder::Linear);
    change(spec);
    return argument_message([&] { static_cast<void>(make_plate_with_hole(spec)); });
  };
  using Spec = PlateWithHoleSpec;
  CHECK_THAT(message([](Spec& s) { s.hole_radius = 2; }), ContainsSubstring("must fit"));
  CHECK_THAT(message([](Spec& s) { s.hole_radius = -1; }), ContainsSubstring("'plate'"));
  CHECK_THAT(message([](Spec& s) { s.cells_radius = 0; }), ContainsSubstring("at least one cell"));
  CHECK_THAT(message([](Spec& s) { s.cells_angle = 2; }),
             ContainsSubstring("no ray for the corner"));
  CHECK_THAT(message([](Spec& s) { s.rays = Eigen::VectorXd::LinSpaced(15, 0, 3); }),
             ContainsSubstring("from 0 to 3.14159"));
  CHECK_THAT(message([](Spec& s) { s.rays = Eigen::VectorXd::LinSpaced(4, 0, pi); }),
             ContainsSubstring("one ray more than cells"));
  CHECK_THAT(message([](Spec& s) { s.grading = 0; }), ContainsSubstring("grading"));
  AnnulusSpec bad = ring(Sector::Full, MeshOrder::Linear);
  bad.outer_radius = 2;
  CHECK_THROWS_AS(make_annulus(bad), std::invalid_argument);
  CHECK_THROWS_AS(similar_cells(1, 3), std::invalid_argument);
  CHECK_THROWS_AS(rays_by_quadrant({3, 4, 5}), std::invalid_argument);
  CHECK_THROWS_AS(rays_by_quadrant({3, 0}), std::invalid_argument);
}
