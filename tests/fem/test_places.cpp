// Where a point force acts, and which nodes feel it.
#include <limits>

#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/side_curve.hpp"
#include "support/meshes.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Nodal forces of a force at one place, for a sheet half as thick as a unit: that must not matter.
NodeArray forces(const Mesh& mesh, const Vector2d& point, const Vector2d& force) {
  const Element& element = find_element(mesh.cells.cols() == 8 ? "q8" : "q4");
  return nodal_loads(mesh, element, Material{1000, 0.3, PlaneState::Stress, 0.5},
                     {{}, {}, {{point, force}}});
}

std::string message(const Mesh& mesh, const Vector2d& point) {
  return problem_message([&] { static_cast<void>(place_on_edge(mesh, point)); });
}

}  // namespace

TEST_CASE("a force at a node acts on it alone, also inside", "[places]") {
  for (const Element& element : elements()) {
    const Mesh mesh = block_for(element, {3, 2}, 3, 2);
    for (Index node = 0; node < mesh.n_nodes(); ++node) {
      NodeArray force = forces(mesh, mesh.nodes.row(node), {3, -4});
      CHECK(force.row(node) == Eigen::RowVector2d(3, -4));
      force.row(node).setZero();
      CHECK(force.isZero(0));
    }
  }
}

// Resultant and moment are those of the force, on straight and on curved sides, in any unit and anywhere.
TEST_CASE("a force between nodes is shared by those of the side", "[places]") {
  DiscSpec spec;
  spec.core_cells = spec.layers = 2;
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic})
    for (const double unit : {1e-6, 1.0, 1e6})
      for (const Vector2d& shift : {Vector2d(0, 0), Vector2d(1e3, -7e2)}) {
        spec.order = order;
        const Mesh mesh = mapped(make_disc(spec),
                                 [&](const Vector2d& x) -> Vector2d { return unit * (x + shift); });
        for (const SideCurve& side : side_curves(mesh, "rim")) {
          const Vector2d point = side.point(0.3).position();
          const NodeArray force = forces(mesh, point, {3, -4});
          CHECK((force.colwise().sum() - Eigen::RowVector2d(3, -4)).norm() <= 1e-14);
          const NodeArray arms = (mesh.nodes.rowwise() - point.transpose()) / unit;
          const double moment = arms.col(0).dot(force.col(1)) - arms.col(1).dot(force.col(0));
          CHECK(std::abs(moment) <= 1e-13 * (1 + shift.norm()));
          CHECK((force.col(0).array() != 0).count() == (order == MeshOrder::Linear ? 2 : 3));
        }
      }
}

TEST_CASE("a force in the middle of a linear side is shared in halves", "[places]") {
  const Mesh mesh = block_for(q4(), {3, 2}, 3, 2);
  const EdgePlace place = place_on_edge(mesh, {1.5, 2});
  REQUIRE(place.nodes.size() == 2);
  CHECK(place.share.head<2>() == Vector2d(0.5, 0.5));
  CHECK(place_on_edge(mesh, {2.25, 0}).share.head<2>() == Vector2d(0.75, 0.25));
}

TEST_CASE("a place that is no node and not on the edge is an error", "[places]") {
  const Mesh mesh = block_for(q4(), {3, 2}, 3, 2);
  const std::string inside = message(mesh, {1.25, 1});  // on a side, but of two cells
  CHECK_THAT(inside, ContainsSubstring("point (1.25, 1) of 'block'") &&
                         ContainsSubstring("neither a node nor a place on the edge") &&
                         ContainsSubstring("node 5, lies at (1, 1), 0.25 away"));
  CHECK_THAT(message(mesh, {3, 2 + 1e-9}),
             ContainsSubstring("node 11, lies at (3, 2), 1e-09 away"));
  CHECK_THAT(message(mesh, {std::numeric_limits<double>::quiet_NaN(), 0}),
             ContainsSubstring("not finite"));
  // As near as rounding is at it: positions that were computed in another way.
  CHECK(place_on_edge(mesh, {3 * (1 + 1e-15), 2}).nodes == std::vector<Index>{11});
}

TEST_CASE("where a crack opens, a place on it belongs to neither side", "[places]") {
  Mesh mesh = block_for(q4(), {2, 2}, 2, 2);
  mesh.nodes.conservativeResize(10, 2);  // node 3 and half of the line to 4 are there twice
  mesh.nodes.row(9) = mesh.nodes.row(3);
  mesh.cells(2, 0) = 9;
  CHECK_THAT(message(mesh, {0, 1}), ContainsSubstring("nodes 3 and 9 both lie there"));
  CHECK_THAT(message(mesh, {0.5, 1}), ContainsSubstring("two sides that are not joined"));
  CHECK(place_on_edge(mesh, {1, 1}).nodes == std::vector<Index>{4});
}

TEST_CASE("a point force that is not finite is an error, one of zero is nothing", "[places]") {
  const Mesh mesh = block_for(q4(), {3, 2}, 3, 2);
  CHECK_THAT(problem_message([&] {
               forces(mesh, {0, 0}, {0, std::numeric_limits<double>::infinity()});
             }),
             ContainsSubstring("point force on 'block' at (0, 0): not finite"));
  CHECK(forces(mesh, {17, 0}, {0, 0}).isZero(0));
}

TEST_CASE("several forces add up, each at its own place, whatever others are zero", "[places]") {
  const Mesh mesh = block_for(q4(), {3, 2}, 3, 2);
  const std::vector<PointForce> loads = {
      {{0.5, 0}, {1, 2}}, {{17, 17}, {0, 0}}, {{3, 2}, {-4, 0}}, {{3, 1.25}, {8, 0}}};
  NodeArray sum = NodeArray::Zero(mesh.n_nodes(), 2);
  for (const PointForce& load : loads) sum += forces(mesh, load.point, load.force);
  const Material sheet{1000, 0.3, PlaneState::Stress, 0.5};
  CHECK(nodal_loads(mesh, q4(), sheet, {{}, {}, loads}) == sum);
  const std::vector<EdgePlace> places = places_of(mesh, loads);
  REQUIRE(places.size() == loads.size());
  CHECK(places[0].nodes == std::vector<Index>{0, 1});
  CHECK(places[1].nodes.empty());
  CHECK(places[2].nodes == std::vector<Index>{11});
  CHECK(places[3].nodes == std::vector<Index>{7, 11});
}
