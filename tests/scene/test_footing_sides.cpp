// Which side of the footing is the source, what hangs over, and loads beside the middle.
#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/moduli.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/rounding.hpp"
#include "support/footing.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

const double a = footing_half, load = 2 * footing_load * footing_half;
const double soil_plane = plane_strain_modulus(soil_modulus, 0.25);

SolvedScene settled(const Scene& scene) { return solved(scene, "the footing"); }

Scene by(Scene scene, const char* gap_operator) {
  scene.contacts.front().gap_operator = gap_operator;
  return scene;
}

/// x of a node of the soil, by its number among the nodes of both bodies.
double beside(const SolvedScene& run, Index node) {
  const BodyModel& soil = run.model.bodies[1];
  return soil.mesh.nodes(node - soil.first_node, 0);
}

}  // namespace

// 1e-12: the same problem written twice.
TEST_CASE("on matching meshes either side may be the source, by nodes", "[footing]") {
  const Scene scene = footing_on(soil_spec(7, 9, 5, 4, 10 * a));
  const VectorXd force = ground_of(settled(scene)).force;
  for (const char* gap_operator : {"mortar", "node_to_segment"}) {
    const SolvedScene soil = settled(by(scene, gap_operator));
    const SolvedScene footing = settled(by(turned_round(scene), gap_operator));
    CHECK(soil.model.pairs.unpaired.size() == 9);  // the soil beside the footing
    CHECK(footing.model.pairs.unpaired.empty());
    for (const Index node : soil.model.pairs.unpaired) CHECK(beside(soil, node) > a);
    CHECK((ground_of(soil).force - force).norm() < 1e-12 * force.norm());
    CHECK((ground_of(footing).force - force).norm() < 1e-12 * force.norm());
  }
}

// The stiff side is a straight line whatever its cells, so it is the target.
TEST_CASE("with the soil as source the cells of the footing do not matter", "[footing]") {
  const EdgeBlockSpec soil = soil_spec(24, 26, 28, 64, 40 * a);
  for (const Index columns : {1, 16, 24, 36})
    for (const char* gap_operator : {"mortar", "node_to_segment"}) {
      CAPTURE(columns, gap_operator);
      const Scene scene = by(footing_on(soil, {2, 8, 2e7, columns}), gap_operator);
      const Ground ground = ground_of(settled(scene));
      CHECK(worst_inside(ground.position, ground.force) < 0.003);
      CHECK(ground.force.sum() == Approx(load / 2).epsilon(1e-12).margin(0));
    }
  const Scene coarse = turned_round(footing_on(soil, {2, 8, 2e7, 16}));
  const Ground mortar = ground_of(settled(coarse));
  const Ground nodes = ground_of(settled(by(coarse, "node_to_segment")));
  CHECK(worst_inside(mortar.position, mortar.force) == Approx(0.010).margin(0.001));
  CHECK(worst_inside(nodes.position, nodes.force) > 0.2);  // soil between the nodes bears nothing
}

// The edge of the footing between two nodes of the soil: forces only where it is, up to the node behind it.
TEST_CASE("an edge inside of a cell of the soil loses no force", "[footing]") {
  for (const double half : {1.45, 1.55, 1.6}) {
    CAPTURE(half);
    const Scene scene = footing_on(soil_spec(7, 9, 5, 4, 10 * a), {2, 4, 2e7, 0, half});
    for (const Scene& now : {scene, turned_round(scene)}) {
      const SolvedScene run = settled(now);
      const Ground ground = ground_of(run);
      CHECK(ground.force.sum() == Approx(load / 2).epsilon(1e-12).margin(0));
      CHECK(run.solution.certificate.holds());
      Index behind = 0;
      while (ground.position(behind) < half) ++behind;
      const Index rest = ground.force.size() - behind - 1;
      CHECK(ground.force.tail(rest).cwiseAbs().maxCoeff() == 0);
      for (const Index node : run.model.pairs.unpaired) CHECK(beside(run, node) > half);
    }
  }
}

// Pairs at two points per edge: 14 forces for 8 nodes. The last edge alone pushes the corner.
TEST_CASE("points of integration push the nodes as nodes would, with pressures of their own",
          "[footing]") {
  const Scene scene = footing_on(soil_spec(7, 9, 5, 4, 10 * a));
  Scene points = by(scene, "gauss_points");
  points.solver = find_solver("quasi_active_set");
  const SolvedScene run = settled(points);
  const Ground nodal = ground_of(settled(scene)), ground = ground_of(run);
  CHECK(run.solution.pressure.size() == 14);
  CHECK((ground.force - nodal.force).norm() < 1e-12 * nodal.force.norm());
  const double exact =
      rigid_strip_pressure({a, load}, a - (1 - std::sqrt(1 / 3.0)) / 2 * (a - nodal.position(6)));
  CHECK(run.solution.pressure.maxCoeff() > 1.6 * exact);
  // The corner feels only the last two points, its neighbour those and one more edge, and all press.
  const double outer = (1 + std::sqrt(1 / 3.0)) / 2, inner = 1 - outer;  // places on the edge
  const double corner = nodal.force(7), next = nodal.force(6);
  const double last = run.solution.pressure.maxCoeff() * (a - nodal.position(6)) / 2;
  CHECK(last <= corner / outer * (1 + 1e-12));
  CHECK(last >= (outer * corner - inner * next) / (outer * outer - inner * inner) * (1 - 1e-12));
}

// 1 %: the finite soil and its cells. Balance to rounding.
TEST_CASE("an eccentric load tilts the footing as the closed form", "[footing][closed-form]") {
  for (const double part : {-0.45, 0.0, 0.25, 0.49}) {
    CAPTURE(part);
    const double e = part * a;
    const RigidRest rest = rigid_on(soil_spec(24, 26, 28, 64, 40 * a), &e);
    CHECK(rest.force.minCoeff() > 0);
    CHECK(rest.force.sum() == Approx(load).epsilon(1e-12).margin(0));
    CHECK(rest.force.dot(rest.position) == Approx(load * e).epsilon(1e-12).margin(1e-10));
    CHECK(rest.tilt ==
          Approx(rigid_strip_rotation({a, load, e}, soil_plane)).epsilon(0.01).margin(1e-12));
    const Index middle = rest.force.size() / 2;
    CHECK(rest.settlement == Approx(5.26e-3).epsilon(0.01));
    CHECK(std::abs(rest.position(middle)) < 1e-14);
    for (Index k = middle - 8; k <= middle + 8; ++k) {
      const double left = (rest.position(k - 1) + rest.position(k)) / 2;
      const double right = (rest.position(k) + rest.position(k + 1)) / 2;
      CHECK(rest.force(k) ==
            Approx(rigid_strip_force({a, load, e}, std::min(left, right), std::max(left, right)))
                .epsilon(0.006));
    }
  }
}

// Past e = a/2 what bears is 4 (a - e) wide, with half-width b = 2 (a - e) and the tilt 2 P / (pi E* b).
TEST_CASE("an eccentric load lifts the far edge off beyond a quarter of the width", "[footing]") {
  for (const double part : {0.51, 0.6, 0.75, 0.9}) {
    CAPTURE(part);
    const double e = part * a, b = 2 * (a - e);
    const RigidRest rest = rigid_on(soil_spec(48, 40, 40, 16, 40 * a), &e);
    double open = -a, closed = a;
    for (Index k = 0; k < rest.force.size(); ++k)
      (rest.force(k) > 0 ? closed : open) =
          rest.force(k) > 0 ? std::min(closed, rest.position(k)) : std::max(open, rest.position(k));
    CHECK(open < closed);
    CHECK(open - (closed - open) < a - 2 * b);
    CHECK(closed + (closed - open) > a - 2 * b);
    CHECK(rest.tilt == Approx(2 * load / (pi * soil_plane * b)).epsilon(0.015));
  }
}
