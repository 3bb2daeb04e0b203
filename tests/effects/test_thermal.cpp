// Warm bodies: what nothing hinders needs no stress, what is hindered does.
#include <cmath>

#include "addons/effects/thermal.hpp"
#include "catch_compat.hpp"
#include "signorini/fem/eigenstrain.hpp"
#include "signorini/fem/elements.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/stress.hpp"
#include "support/linear_solve.hpp"
#include "support/meshes.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

MaterialField warm(PlaneState state, const Temperature& temperature) {
  MaterialField material(Material{1000, 0.3, state, state == PlaneState::Axial ? 1 : 0.5, 1e-3});
  material.eigenstrain = expansion(temperature);
  return material;
}

/// A block that can expand freely from the origin.
std::vector<Support> hung_up(const Mesh& mesh) {
  return {prescribed_at("left", mesh.nodes.row(0), Axis::X),
          prescribed_at("left", mesh.nodes.row(0), Axis::Y),
          prescribed_at("left", mesh.nodes.row(boundary_nodes(mesh, "left").front()), Axis::X)};
}

}  // namespace

TEST_CASE("every element: an even temperature expands a free body without stress", "[thermal]") {
  for (const Element& element : elements())
    for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain}) {
      CAPTURE(element.name);
      const Vector2d size(3, 2);
      const Mesh mesh = distorted(block_for(element, size, 4, 3), size, {0.75, 2.0 / 3}, 7);
      const MaterialField material = warm(state, {20, {0, 0}});
      const NodeArray u = solve_body(mesh, element, material, hung_up(mesh));
      const double strain = 0.02 * (state == PlaneState::Strain ? 1.3 : 1);
      CHECK((u - strain * mesh.nodes).cwiseAbs().maxCoeff() <= 1e-12 * strain * 3);
      // Across the plane strain it is held: -E alpha dT.
      const double across = state == PlaneState::Strain ? -1000 * 0.02 : 0;
      for (const StressArray& stress :
           {nodal_stress(mesh, element, material, u), cell_stress(mesh, element, material, u)}) {
        CHECK(stress.leftCols(3).cwiseAbs().maxCoeff() <= 1e-12 * 20);
        CHECK((stress.col(3).array() - across).abs().maxCoeff() <= 1e-12 * 20);
      }
      CHECK(internal_forces(mesh, element, material, u).cwiseAbs().maxCoeff() <= 1e-12 * 20);
    }
}

// u = e (x dT - g r^2 / 2) with dT = g x: quadratic, so without stress where an element has all of them.
TEST_CASE("a temperature that varies linearly bends a free body without stress", "[thermal]") {
  const Vector2d g(3, -2);
  for (const char* name : {"q4_incompatible", "q8", "t6"})
    for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain}) {
      CAPTURE(name);
      const Element& element = find_element(name);
      const Mesh mesh = mapped(block_for(element, {3, 2}, 4, 3), [](const Vector2d& x) -> Vector2d {
        return {x.x(), x.y()};
      });
      const MaterialField material = warm(state, {20, g});
      const double e = 1e-3 * (state == PlaneState::Strain ? 1.3 : 1);
      const auto exact = [&](const Vector2d& x) -> Vector2d {
        return e * (x * (20 + g.dot(x)) - g * x.squaredNorm() / 2);
      };
      const NodeArray u = solve_body(mesh, element, material,
                                     {{"left", true, true, exact, false, Vector2d(0, 0)},
                                      {"left", true, false, exact, false, Vector2d(0, 2)}});
      double worst = 0;
      for (Index node = 0; node < mesh.n_nodes(); ++node)
        worst = std::max(worst, (u.row(node).transpose() - exact(mesh.nodes.row(node))).norm());
      CHECK(worst <= 1e-12 * u.cwiseAbs().maxCoeff());
      const StressArray stress = nodal_stress(mesh, element, material, u);
      CHECK(stress.leftCols(3).cwiseAbs().maxCoeff() <= 1e-11 * 1000 * 0.03);
      if (state == PlaneState::Stress) continue;
      for (Index node = 0; node < mesh.n_nodes(); ++node)
        CHECK(stress(node, 3) ==
              Approx(-1 * (20 + g.dot(mesh.nodes.row(node).transpose()))).epsilon(1e-10));
    }
}

// Held all around: no strain, -E alpha dT / (1 - nu) in plane stress, / (1 - 2 nu) in plane strain, everywhere.
TEST_CASE("every element: a body held all around is pressed by its expansion", "[thermal]") {
  for (const Element& element : elements()) {
    CAPTURE(element.name);
    const Vector2d size(3, 2);
    const Mesh mesh = distorted(block_for(element, size, 4, 3), size, {0.75, 2.0 / 3}, 5);
    const VectorField none = [](const Vector2d&) { return Vector2d(0, 0); };
    for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain}) {
      const MaterialField material = warm(state, {20, {0, 0}});
      const NodeArray u = solve_body(mesh, element, material, given_around(none));
      CHECK(u.cwiseAbs().maxCoeff() <= 1e-14);
      const double pressed = -20 / (state == PlaneState::Stress ? 0.7 : 0.4);
      const StressArray stress = cell_stress(mesh, element, material, u);
      CHECK((stress.col(0).array() - pressed).abs().maxCoeff() <= 1e-11);
      CHECK((stress.col(1).array() - pressed).abs().maxCoeff() <= 1e-11);
      CHECK(stress.col(2).cwiseAbs().maxCoeff() <= 1e-11);
      const double across = state == PlaneState::Stress ? 0 : pressed;
      CHECK((stress.col(3).array() - across).abs().maxCoeff() <= 1e-11);
    }
  }
}

// Forces of a temperature alone have no resultant and no moment, and do the work of its expansion.
TEST_CASE("every element: the forces of a temperature are in balance", "[thermal]") {
  for (const Element& element : elements()) {
    CAPTURE(element.name);
    const Vector2d size(3, 2);
    const Mesh mesh = distorted(block_for(element, size, 4, 3), size, {0.75, 2.0 / 3}, 5);
    const NodeArray force =
        eigenstrain_forces(mesh, element, warm(PlaneState::Strain, {20, {3, -2}}));
    const double size_of = force.cwiseAbs().maxCoeff();
    CHECK(force.colwise().sum().norm() <= 1e-13 * size_of);
    CHECK(std::abs(mesh.nodes.col(0).dot(force.col(1)) - mesh.nodes.col(1).dot(force.col(0))) <=
          1e-13 * size_of * 5);
    // Of u = x: the sum over the area of E alpha dT 2 / (1 - 2 nu), 0.5 thick; dT in the middle is 22.5.
    const double work = force.cwiseProduct(mesh.nodes).sum();
    CHECK(work == Approx(2 * 22.5 * 0.5 * 6 / 0.4).epsilon(1e-12));
  }
}

TEST_CASE("a temperature of zero is none", "[thermal]") {
  const Mesh mesh = block_for(q4_incompatible(), {3, 2}, 4, 3);
  const NodeArray u = 1e-3 * NodeArray::Random(mesh.n_nodes(), 2);
  const MaterialField cold = warm(PlaneState::Strain, {0, {0, 0}});
  const Material plain{1000, 0.3, PlaneState::Strain, 0.5};
  CHECK(nodal_stress(mesh, q4_incompatible(), cold, u) ==
        nodal_stress(mesh, q4_incompatible(), plain, u));
  CHECK(internal_forces(mesh, q4_incompatible(), cold, u) ==
        internal_forces(mesh, q4_incompatible(), plain, u));
  CHECK(eigenstrain_forces(mesh, q4_incompatible(), cold).isZero(0));
}
