#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "closed_form/footing.hpp"
#include "closed_form/moduli.hpp"
#include "exercise.hpp"
#include "meshes/half_space.hpp"
#include "signorini/core/errors.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/readings.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using ex13_2::come_to_rest;
using ex13_2::Rest;

namespace {

const double a = 1.5, load = 45, modulus = signorini::plane_strain_modulus(2e4, 0.25);

struct Ground {
  Eigen::MatrixXd compliance;
  VectorXd position;
};

// The soil of the footing of Lin et al., section 3.3, both halves, 40 a wide either way and deep.
Ground ground() {
  signorini::EdgeBlockSpec half;
  half.edge = a;
  half.width = half.depth = 40 * a;
  half.cells_under = 24;
  half.cells_beside = 26;
  half.cells_deep = 28;
  half.grading_under = 16;
  const signorini::Mesh right = signorini::make_edge_block(half);
  signorini::Scene scene;
  scene.bodies[0].mesh = signorini::joined(
      right, "axis", signorini::mirrored(right, signorini::MirrorLine::Upright), "axis");
  scene.bodies[0].material = {2e4, 0.25, signorini::PlaneState::Strain, 1};
  scene.bodies[0].supports = {signorini::fixed("base")};
  scene.contacts = {{{"loaded"}, signorini::half_plane({0, 0}, {0, -1})}};
  signorini::Ledger ledger;
  const signorini::Model model = signorini::build(scene, ledger);
  return {signorini::condense(model, ledger).problem.compliance, model.pairs.position.col(0)};
}

}  // namespace

// 1 %: the finite soil and its cells; the chapter says how much of it is whose.
TEST_CASE("ex13.2 held out: the tilt is that of the closed form up to e = a/2", "[ex13.2]") {
  const Ground soil = ground();
  for (const double part : {-0.4, 0.2, 0.49}) {
    CAPTURE(part);
    const double e = part * a;
    const Rest rest = come_to_rest(soil.compliance, soil.position, load, e);
    CHECK(rest.tilt ==
          Approx(signorini::rigid_strip_rotation({a, load, e}, modulus)).epsilon(0.01));
    CHECK(rest.force.minCoeff() > 0);
    CHECK(rest.force.sum() == Approx(load).epsilon(1e-12));
    CHECK(rest.force.dot(soil.position) == Approx(load * e).epsilon(1e-12));
  }
}

// Beyond a/2 only the part next to the loaded edge bears, 4 (a - e) wide, as if the footing ended there:
// half-width b = 2 (a - e), tilt 2 P / (pi E* b).
TEST_CASE("ex13.2 held out: beyond e = a/2 the far edge lifts off", "[ex13.2]") {
  const Ground soil = ground();
  for (const double part : {0.55, 0.6, 0.75}) {
    CAPTURE(part);
    const double b = 2 * (1 - part) * a;
    const Rest rest = come_to_rest(soil.compliance, soil.position, load, part * a);
    double nearest_open = -a, first_closed = a;
    for (Index k = 0; k < rest.force.size(); ++k)
      if (rest.force(k) == 0)
        nearest_open = std::max(nearest_open, soil.position(k));
      else
        first_closed = std::min(first_closed, soil.position(k));
    const double cell = first_closed - nearest_open;
    CHECK(cell > 0);
    CHECK(cell < 0.2);
    CHECK(nearest_open < a - 2 * b + 0.5 * cell);
    CHECK(first_closed > a - 2 * b - 0.5 * cell);
    CHECK(rest.tilt == Approx(2 * load / (std::acos(-1.0) * modulus * b)).epsilon(0.01));
  }
}

TEST_CASE("ex13.2 held out: a load beside the footing topples it", "[ex13.2]") {
  const Eigen::Matrix2d springs = Eigen::Matrix2d::Identity();
  CHECK_THROWS_AS(come_to_rest(springs, Eigen::Vector2d(-1, 1), 1, 1.1), signorini::NotSolved);
  CHECK_THROWS_AS(come_to_rest(springs, Eigen::Vector3d(-1, 0, 1), 1, 0), std::invalid_argument);
}
