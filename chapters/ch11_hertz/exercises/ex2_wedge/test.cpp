#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/scene/readings.hpp"

using Eigen::Index;
using Eigen::VectorXd;

// a = P / (E* t) = 1: E* = E / (2 (1 - nu^2)).
static const ex11_2::Wedge wedge{0.01, 2 * (1 - 0.09), 0.3, 0.01, 1.4, 50, 16};

TEST_CASE("ex11.2 the pressure of a wedge has a sixth of a^2 as its second moment", "[ex11.2]") {
  VectorXd x(2001), force(2001);
  for (Index k = 0; k < 2001; ++k) {
    const double from = 0.001 * std::max(static_cast<double>(k) - 0.5, 0.0);
    const double to = 0.001 * (static_cast<double>(k) + 0.5);
    const auto load = [](double s) {  // from 0 to s, with a = 2
      return s < 2 ? s * std::acosh(2 / std::max(s, 1e-300)) + 2 * std::asin(s / 2)
                   : std::acos(-1.0);
    };
    x(k) = 0.001 * static_cast<double>(k);
    force(k) = load(to) - load(from);
  }
  CHECK(ex11_2::wedge_half_width(x, force) == Approx(2).epsilon(1e-5));
}

// A uniform pressure from 0 to 2 has the second moment 8/3 on a force of 2.
TEST_CASE("ex11.2 linear edges are corrected for", "[ex11.2]") {
  const VectorXd x = VectorXd::LinSpaced(3, 0, 2);
  CHECK(ex11_2::wedge_half_width(x, Eigen::Vector3d(0.5, 1, 0.5)) ==
        Approx(std::sqrt(8)).epsilon(1e-14));
}

TEST_CASE("ex11.2 the scene is a wedge above a plate", "[ex11.2]") {
  const signorini::Scene scene = ex11_2::wedge_on_plate(wedge);
  REQUIRE(scene.bodies.size() == 2);
  CHECK(scene.bodies[0].mesh.name == "wedge");
  CHECK(scene.bodies[1].mesh.name == "plate");
  for (const Index node : signorini::boundary_nodes(scene.bodies[0].mesh, "surface")) {
    const Eigen::RowVector2d at = scene.bodies[0].mesh.nodes.row(node);
    CHECK(at.y() == Approx(0.01 * at.x()).margin(1e-15));
  }
  const signorini::Mesh& above = scene.bodies[0].mesh;
  for (const Index node : signorini::boundary_nodes(above, "base"))
    CHECK(above.nodes(node, 1) == Approx(50).epsilon(1e-14));  // level
}

TEST_CASE("ex11.2 contact carries the load and is as wide as it should be", "[ex11.2]") {
  const signorini::Scene scene = ex11_2::wedge_on_plate(wedge);
  REQUIRE(scene.contacts.size() == 1);
  const signorini::SolvedScene run = signorini::solved(scene, "the wedge");
  CHECK(run.solution.contact.force.sum() == Approx(0.005).epsilon(1e-9));
  const Index n = run.model.pairs.weight.size();
  VectorXd x = run.model.pairs.position.col(0), force = run.solution.contact.force;
  if (x(0) > x(n - 1)) {
    x.reverseInPlace();
    force.reverseInPlace();
  }
  CHECK(ex11_2::wedge_half_width(x, force) == Approx(1).epsilon(0.005));
}
