// A lining in a tunnel, Lin et al., section 3.4.
#include <cmath>

#include "catch_compat.hpp"
#include "reference/lining.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/solvers.hpp"
#include "support/lining.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::closed_form;
using signorini_test::Lining;
using signorini_test::scene_of;

namespace {

const double half_cell = pi / 36;  // of nine cells [rad]

SolvedScene run_of(const Lining& lining) { return solved(scene_of(lining), "the lining"); }

/// Displacements of the inner rim, outwards [length].
Eigen::VectorXd rim(const SolvedScene& run) {
  const std::vector<Index> nodes = boundary_nodes(run.model.bodies[0].mesh, "inner");
  Eigen::VectorXd u(static_cast<Index>(nodes.size()));
  for (Index k = 0; k < u.size(); ++k)
    u(k) = run.solution.displacements[0].row(nodes[static_cast<std::size_t>(k)]).norm();
  return u;
}

/// Largest deviation of the rim's displacement and of the contact pressure from the closed form.
std::pair<double, double> deviation(const Lining& lining) {
  const SolvedScene run = run_of(lining);
  const NestedRings rings = closed_form(lining);
  const NestedPressure p = nested_pressure(rings);
  const double u = ring_displacement(rings.inner, p.inner, rings.inner.inner_radius);
  return {(rim(run).array() / u - 1).abs().maxCoeff(),
          (run.solution.pressure.array() / p.inner.outside - 1).abs().maxCoeff()};
}

double spread(const Eigen::VectorXd& x) { return x.maxCoeff() / x.minCoeff() - 1; }

}  // namespace

// Tolerances: half a unit of the last digit of the reference. It divides by arcs; the weight of a node is what a pressure on its two chords does along its normal.
TEST_CASE("the lining reproduces the mesh-exact values", "[lining][reference]") {
  for (const reference::LiningMesh& expected : reference::lining_meshes) {
    CAPTURE(expected.element);
    Lining lining;
    lining.element = expected.element;
    lining.gap_operator = "node_to_segment";
    const SolvedScene run = run_of(lining);
    const double chord_by_arc = std::cos(half_cell) * std::sin(half_cell) / half_cell;
    CHECK(rim(run).mean() == Approx(expected.u).epsilon(0).margin(5e-7));
    CHECK(run.solution.pressure.mean() * chord_by_arc ==
          Approx(expected.pressure).epsilon(0).margin(5e-5));
  }
}

TEST_CASE("120 nodes have the closed form to 0.5 % in pressure, to 0.25 % in displacement",
          "[lining][closed-form]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible"}) {
    CAPTURE(element);
    Lining lining;
    lining.element = element;
    const Scene scene = scene_of(lining);
    CHECK(scene.bodies[0].mesh.nodes.rows() + scene.bodies[1].mesh.nodes.rows() == 120);
    CHECK(scene.bodies[0].mesh.cells.rows() + scene.bodies[1].mesh.cells.rows() == 90);
    const auto [u, p] = deviation(lining);
    CHECK(u < 0.0025);
    CHECK(p < 0.005);
  }
}

// Symmetry: 1e-9 leaves room for the condition of K. Two Gauss points per side are more than nodes can tell
// apart: their forces are not unique.
TEST_CASE("pressure and displacement of the lining are the same all round", "[lining]") {
  for (const char* gap_operator : {"node_to_segment", "mortar"})
    for (const Index times : {1, 4}) {
      CAPTURE(gap_operator, times);
      Lining lining;
      lining.gap_operator = gap_operator;
      lining.cells_angle *= times;
      lining.cells_radius *= times;
      const SolvedScene run = run_of(lining);
      CHECK(run.solution.contact.active().size() ==
            static_cast<std::size_t>(run.solution.pressure.size()));
      CHECK(spread(run.solution.pressure) < 1e-9);
      CHECK(spread(rim(run)) < 1e-9);
    }
}

// The two chords of a node pull in directions half a cell apart: its force is p l cos(half a cell), and so is its weight.
TEST_CASE("all operators give the lining the same forces and read one pressure from them",
          "[lining]") {
  Lining lining;
  const SolvedScene mortar = run_of(lining);
  lining.gap_operator = "node_to_segment";
  const SolvedScene nodes = run_of(lining);
  lining.gap_operator = "gauss_points";
  const SolvedScene points = run_of(lining);
  const double p = mortar.solution.pressure.mean();
  CHECK(points.solution.pressure.mean() == Approx(p).epsilon(1e-7));
  CHECK(nodes.solution.pressure.mean() == Approx(p).epsilon(1e-10));
  for (const SolvedScene* other : {&nodes, &points})
    CHECK((other->solution.displacements[0] - mortar.solution.displacements[0]).norm() <
          1e-7 * mortar.solution.displacements[0].norm());
}

TEST_CASE("the lining converges with the second order of the cell size", "[lining]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible"})
    for (const char* gap_operator : {"node_to_segment", "mortar"}) {
      CAPTURE(element, gap_operator);
      Lining lining;
      lining.element = element;
      lining.gap_operator = gap_operator;
      auto [u, p] = deviation(lining);
      for (int step = 0; step < 3; ++step) {
        lining.cells_angle *= 2;
        lining.cells_radius *= 2;
        const auto [finer_u, finer_p] = deviation(lining);
        CHECK(u / finer_u == Approx(4).epsilon(0.02));
        CHECK(p / finer_p == Approx(4).epsilon(0.02));
        u = finer_u;
        p = finer_p;
      }
    }
}

// 1e-12 cm: rounding of radii of 68 cm and of their displacements.
TEST_CASE("facing nodes of the lining meet and do not pass", "[lining][reference]") {
  for (const char* gap_operator : {"node_to_segment", "gauss_points", "mortar"}) {
    CAPTURE(gap_operator);
    Lining lining;
    lining.gap_operator = gap_operator;
    const SolvedScene run = run_of(lining);
    for (int k = 0; k <= 9; ++k) {
      const double angle = 2 * k * half_cell;
      Eigen::RowVector2d closing(0, 0);
      for (const std::size_t body : {0, 1}) {
        const Mesh& mesh = run.model.bodies[body].mesh;
        const double r = body == 0 ? 68 : 68.15;
        for (const Index node : boundary_nodes(mesh, body == 0 ? "outer" : "inner"))
          if ((mesh.nodes.row(node) - r * unit_vector(angle)).norm() < 1e-9)
            closing += (body == 0 ? 1 : -1) * run.solution.displacements[body].row(node);
      }
      CHECK((closing - 0.15 * unit_vector(angle)).norm() < 1e-12);
      if (k == 4)  // nodes 10 and 80 of the paper
        for (Index i = 0; i < 2; ++i)
          CHECK(closing(i) == Approx(reference::lining_pair[i]).epsilon(0).margin(5e-5));
    }
  }
}

TEST_CASE("72 MPa leave the gap of the lining open, 73 MPa close it", "[lining]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible", "q8"}) {
    CAPTURE(element);
    Lining lining;
    lining.element = element;
    lining.inside = 72;
    CHECK(run_of(lining).solution.contact.active().empty());
    lining.inside = 73;
    const SolvedScene run = run_of(lining);
    CHECK(run.solution.contact.active().size() ==
          static_cast<std::size_t>(run.solution.pressure.size()));
  }
}

// E and loads ten times smaller: the same displacements, so the same closed gap.
TEST_CASE("a softer lining under as much less load moves the same", "[lining][units]") {
  Lining lining;
  const SolvedScene whole = run_of(lining);
  lining.inside /= 10;
  lining.youngs_modulus /= 10;
  const SolvedScene part = run_of(lining);
  CHECK((10 * part.solution.pressure - whole.solution.pressure).norm() <
        1e-11 * whole.solution.pressure.norm());
  CHECK((part.solution.displacements[0] - whole.solution.displacements[0]).norm() <
        1e-11 * whole.solution.displacements[0].norm());
}
